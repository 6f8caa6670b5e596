// Objects and fields that are assigned from references of one format keep the bits that are stored, however often: one
// by one, in packs, gathered, by way of fields, exchanged, and through locals of fused kernels.
#include <physgen/fuse.h>
#include <physgen/parallel_for.h>

#include "format/own_formats.h"
#include "stored_copies_checks.h"

namespace physgen::test {
namespace {

template <class To, class From>
struct CopyFields {
  using Scalar = typename To::Precision;
  To to;
  From from;
  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    to[i].U() = from[i].U();
    to[i].V() = from[i].V();
    to[i].s() = from[i].s();
  }
};
/// Copies all objects there and back 100 times in each way.
template <class Object, class Real, class Formats>
void check_copies_of_objects() {
  constexpr index_t n = 203;
  std::mt19937 random(seed());
  using Source = Array<Object, Real, Host, Aos, Formats>;
  Source source(n), back(n);
  fill_with_random_bits(source, random);
  Array<Object, Real, Host, Soa, Formats> a(n);
  Array<Object, Real, Host, Aosoa<8>, Formats> b(n);
  elasticity::IncidenceArray<float> reversed(n);
  for (index_t i = 0; i < n; ++i) reversed.view()[i].element() = static_cast<std::int32_t>(n - 1 - i);
  const auto check = [&](const char* way, const auto& there, const auto& here) {
    move_objects(a, source);
    for (int time = 0; time < 100; ++time) {
      there();
      here();
    }
    poison(back);
    move_objects(back, a);
    EXPECT_EQ(count_different(source, back), 0) << way;
  };
  using A = decltype(a.view());
  using B = decltype(b.view());
  using ConstA = decltype(a.const_view());
  using ConstB = decltype(b.const_view());
  const CopyObjects<B, ConstA> to_b{b.view(), a.const_view()};
  const CopyObjects<A, ConstB> to_a{a.view(), b.const_view()};
  check(
      "one by one", [&] { parallel_for(Host{}, n, lanes<1>(to_b)); }, [&] { parallel_for(Host{}, n, lanes<1>(to_a)); });
  check("in packs", [&] { parallel_for(Host{}, n, to_b); }, [&] { parallel_for(Host{}, n, to_a); });
  using Numbers = decltype(reversed.const_view());
  const GatherObjects<B, ConstA, Numbers> gather_b{b.view(), a.const_view(), reversed.const_view()};
  const GatherObjects<A, ConstB, Numbers> gather_a{a.view(), b.const_view(), reversed.const_view()};
  check("gathered", [&] { parallel_for(Host{}, n, gather_b); }, [&] { parallel_for(Host{}, n, gather_a); });
  Array<Object, Real, Host, Soa, Formats> other(n);
  move_objects(other, source);
  const SwapObjects<A> exchange{a.view(), other.view()};
  check(
      "exchanged", [&] { parallel_for(Host{}, n, lanes<1>(exchange)); },
      [&] { parallel_for(Host{}, n, lanes<1>(exchange)); });
  const auto tmp = local<Object, Real, Formats>();
  using Tmp = std::remove_const_t<decltype(tmp)>;
  const auto by_local = [&](const auto& view, const auto& from) {
    using To = std::remove_cvref_t<decltype(view)>;
    using From = std::remove_cvref_t<decltype(from)>;
    parallel_for(Host{}, n, fuse(locals(tmp), CopyObjects<Tmp, From>{tmp, from}, CopyObjects<To, Tmp>{view, tmp}));
  };
  check("through a local", [&] { by_local(b.view(), a.const_view()); }, [&] { by_local(a.view(), b.const_view()); });
}

TEST(StoredCopies, objects_of_every_format_nested_and_in_fixed_arrays_keep_their_bits) {
  check_copies_of_objects<tissue::model::StoredObject, float, FormatsOf<tissue::model::StoredObject, Host>>();
  check_copies_of_objects<tissue::model::StoredObject, double, FormatsOf<tissue::model::StoredObject, Cuda>>();
}

TEST(StoredCopies, objects_of_a_programs_own_formats_keep_their_bits) {
  check_copies_of_objects<elasticity::StressDerivativeObject, float, OwnDerivative>();
  check_copies_of_objects<elasticity::StressDerivativeObject, double, OwnDerivative>();
}

struct ShortSvd : elasticity::DeformationSvdFormats<Host> {
  using U = format::Quaternion<format::Half<>>;
  using V = format::Quaternion16;
  using s = format::Scaled<format::Half<>, format::Affine{.centre = 300}>;
};

TEST(StoredCopies, fields_that_are_assigned_from_fields_keep_their_bits) {
  constexpr index_t n = 203;
  std::mt19937 random(seed());
  Array<elasticity::DeformationSvdObject, float, Host, Aos, ShortSvd> source(n), back(n);
  fill_with_random_bits(source, random);
  Array<elasticity::DeformationSvdObject, float, Host, Soa, ShortSvd> a(n);
  Array<elasticity::DeformationSvdObject, float, Host, Aosoa<8>, ShortSvd> b(n);
  move_objects(a, source);
  for (int time = 0; time < 100; ++time) {
    parallel_for(Host{}, n, CopyFields<decltype(b.view()), decltype(a.const_view())>{b.view(), a.const_view()});
    parallel_for(Host{}, n,
                 lanes<1>(CopyFields<decltype(a.view()), decltype(b.const_view())>{a.view(), b.const_view()}));
  }
  move_objects(back, a);
  EXPECT_EQ(count_different(source, back), 0);
}

}  // namespace
}  // namespace physgen::test
