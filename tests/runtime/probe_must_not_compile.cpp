// Programs under probes that a compiler must refuse, since reads or writes would hide: one per CASE_..., which
// CMakeLists.txt defines.
#include <elasticity.physgen.h>
#include <physgen/probe.h>

#include <cstring>

using namespace physgen;

namespace {

struct First {
  static constexpr const char* name = "first";
};
struct Second {
  static constexpr const char* name = "second";
};
using Derivatives = elasticity::StressDerivativeArray<float>;

struct OverConcreteViews {
  using Scalar = float;
  Derivatives::View view;
  template <class I>
  void operator()(I i) const {
    view[i].x1111() = lanes_t<float, I>(1.0F);
  }
};
template <class View>
struct OverAnyViews {
  using Scalar = float;
  View view;
  template <class I>
  void operator()(I i) const {
    view[i].x1111() = lanes_t<float, I>(1.0F);
  }
};
template <class View>
OverAnyViews(View) -> OverAnyViews<View>;

struct WithoutOne : elasticity::StressDerivativeFormats<Host> {
  using x1111 = format::Pruned<First, First, First>;
};
struct IndicesInHalf : elasticity::TetFormats<Host> {
  using nodes = format::Half<>;
};

}  // namespace

void refused(ProbeExecutor<Host>& on, ProbeOf<Derivatives, First>& first, ProbeOf<Derivatives, Second>& second,
             index_t i) {
  const auto v = first.view();
  const auto w = second.view();
#if defined(CASE_a_reference_to_a_probed_scalar)
  auto& x = v[i].x1111();
  x = 1.0F;
#elif defined(CASE_a_probed_scalar_that_is_read_later)
  const auto x = v[i].x1111();
  w[i].x1111() = x;
#elif defined(CASE_raw_memory_of_a_probed_view)
  (void)reinterpret_cast<float*>(v.data());
#elif defined(CASE_raw_memory_of_a_view_with_a_pruned_field)
  elasticity::StressDerivativeArray<float, Host, Soa, WithoutOne> pruned(1);
  (void)pruned.view().data();
#elif defined(CASE_raw_memory_of_a_probed_array)
  (void)first.untyped();
#elif defined(CASE_copying_bytes_from_a_probed_field)
  float x[9];
  std::memcpy(&x, &ProbeOf<elasticity::StressArray<float>, First>().view()[i].P(), sizeof x);
#elif defined(CASE_a_kernel_over_a_concrete_view)
  on.run(1, OverConcreteViews{v});
#elif defined(CASE_either_of_two_probed_arrays)
  (i % 2 == 0 ? v : w)[i].x1111() = 1.0F;
#elif defined(CASE_writing_to_a_read_only_probe)
  first.const_view()[i].x1111() = 1.0F;
#elif defined(CASE_indices_in_half)
  elasticity::TetArray<float, Host, Soa, IndicesInHalf> tets(1);
  (void)tets;
#else
  // What asks whether it compiles finds the same of every view: what does not compile is a use.
  static_assert(requires { v.data(); } && requires { Derivatives(1).view().data(); });
  static_assert(requires { elasticity::StressDerivativeArray<float, Host, Soa, WithoutOne>(1).view().data(); });
  (void)w, (void)i;
  on.run(1, OverAnyViews{v});
#endif
}
