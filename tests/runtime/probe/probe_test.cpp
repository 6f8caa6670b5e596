// Programs under probes: what is found of them, and that nothing is run.
#include <physgen/executor.h>
#include <physgen/row_arrays.h>
#include <sys/mman.h>

#include "probe_checks.h"

namespace physgen {
namespace {

using namespace test;

template <class View>
struct Term {
  using Scalar = float;
  View view;
  template <class I>
  auto operator()(I i) const -> lanes_t<float, I> {
    return view[i].x1111();
  }
};
template <class View>
Term(View) -> Term<View>;
template <class View>
struct Then {
  View view;
  void operator()(double sum) const { view[index_t{0}].x2222() = static_cast<float>(sum); }
};
template <class View>
Then(View) -> Then<View>;
template <class View>
struct Done {
  View view;
  bool operator()() const { return view[index_t{0}].x3333() > 0.0F; }
};
template <class View>
Done(View) -> Done<View>;

template <class On, class Sums, class Shapes>
void program(On& on, Sums& sums, Shapes& shapes) {
  typename On::Loop loop;
  on.repeat(
      loop, 3, [&] { on.reduce(sums.size(), Term{sums.const_view()}, Sum{}, Then{sums.view()}); },
      Done{sums.const_view()});
  on.wait();
  const auto value = on.value(shapes);
  (void)value;
}

PHYSGEN_TEST_ARRAY(sums);
PHYSGEN_TEST_ARRAY(host_values);
TEST(Probes, want_what_ends_a_loop_what_follows_a_sum_and_what_the_host_reads) {
  Derivatives<sums> derivatives;
  Shapes<host_values> shapes;
  ProbeExecutor<Host> on;
  program(on, derivatives, shapes);
  EXPECT_EQ(fields_of("sums"), (Fields{"x1111 R", "x2222 W", "x3333 R"}));
  EXPECT_EQ(fields_of("host_values"), (Fields{"dm_inverse R", "volume R"}));
  HostExecutor host;
  elasticity::StressDerivativeArray<float> real(3);
  elasticity::RestShapeArray<float> one(1);
  for (index_t i = 0; i < 3; ++i) real.view()[i].x1111() = 2.0F;
  program(host, real, one);
  EXPECT_EQ(real.const_view()[0].x2222(), 6.0F) << "the same source runs";
}

template <class Ranges, class Entries, class To>
struct SumOfRows {
  Rows<Ranges, Entries> rows;
  To to;
  void operator()(index_t i) const {
    to[i].volume() = rows.sum(i, 0.0F, [&](const auto& entry) { return float(entry.local()); });
  }
};
template <class Ranges, class Entries, class To>
SumOfRows(Rows<Ranges, Entries>, To) -> SumOfRows<Ranges, Entries, To>;

PHYSGEN_TEST_ARRAY(ranges);
PHYSGEN_TEST_ARRAY(entries);
PHYSGEN_TEST_ARRAY(sums_of_rows);
TEST(Probes, follow_rows) {
  ProbeRows<ProbeOf<elasticity::IncidenceRangeArray<float>, ranges>,
            ProbeOf<elasticity::IncidenceArray<float>, entries>>
      rows;
  Shapes<sums_of_rows> to;
  Perform()(SumOfRows{rows.const_view(), to.view()});
  EXPECT_EQ(fields_of("ranges"), (Fields{"begin R", "end R"}));
  EXPECT_EQ(fields_of("entries"), Fields{"local R"});
  EXPECT_EQ(fields_of("sums_of_rows"), Fields{"volume W"});
}

// Memory that ends the program when it is touched.
PHYSGEN_TEST_ARRAY(poisoned);
TEST(Probes, run_nothing) {
  constexpr std::size_t bytes = 1 << 16;
  void* memory = mmap(nullptr, bytes, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  ASSERT_NE(memory, MAP_FAILED);
  struct Poisoned : Derivatives<poisoned> {
    std::byte* base;
    explicit Poisoned(void* at) : base(static_cast<std::byte*>(at)) {}
    [[nodiscard]] View view() const { return {base, 64, 64}; }
    [[nodiscard]] ConstView const_view() const { return view(); }
    [[nodiscard]] index_t size() const { return 64; }
  } array(memory);
  ProbeExecutor<Host> on;
  program(on, array, array);
  on.run(array.size(), Term{array.view()});
  bool performed = false;
  on.perform([&](Stream /*stream*/) { performed = true; });
  EXPECT_FALSE(performed);
  EXPECT_EQ(fields_of("poisoned").size(), 12U) << "and yet everything is found";
  munmap(memory, bytes);
}

TEST(Probes, see_all_code_of_the_host) { EXPECT_EQ(probe::unseen(), std::vector<std::string>()); }

}  // namespace
}  // namespace physgen
