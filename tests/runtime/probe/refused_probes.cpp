// Programs under probes that a compiler must refuse, since reads or writes would hide. refused.py compares them with
// what it reports.
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
using FirstProbe = ProbeOf<Derivatives, First>;
using SecondProbe = ProbeOf<Derivatives, Second>;

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
using WithoutOneArray = elasticity::StressDerivativeArray<float, Host, Soa, WithoutOne>;

struct Halves : elasticity::StressDerivativeFormats<Host> {
  using x1111 = format::Half<>;
};
using ProbeOfHalves =
    ProbeArray<elasticity::StressDerivativeObject, float, Soa, elasticity::StressDerivativeProbe<First, Halves>>;

}  // namespace

/// refused a_reference_to_a_probed_scalar: cannot bind non-const lvalue reference|cannot bind to a temporary
void a_reference_to_a_probed_scalar(FirstProbe& first) {
  auto& x = first.view()[0].x1111();
  x = 1.0F;
}
/// refused a_probed_scalar_that_is_read_later: deleted
void a_probed_scalar_that_is_read_later(FirstProbe& first, SecondProbe& second) {
  const auto x = first.view()[0].x1111();
  second.view()[0].x1111() = x;
}
/// refused raw_memory_of_a_probed_view: a probed array has no raw memory
void raw_memory_of_a_probed_view(FirstProbe& first) { (void)reinterpret_cast<float*>(first.view().data()); }
/// refused raw_memory_of_a_view_with_a_pruned_field: what lies in its memory depends on the scene
void raw_memory_of_a_view_with_a_pruned_field(WithoutOneArray& pruned) { (void)pruned.view().data(); }
/// refused raw_memory_of_a_probed_array: untyped
void raw_memory_of_a_probed_array(FirstProbe& first) { (void)first.untyped(); }
/// refused copying_bytes_from_a_probed_field: address of
void copying_bytes_from_a_probed_field(ProbeOf<elasticity::StressArray<float>, First>& stress) {
  float x[9];
  std::memcpy(&x, &stress.view()[0].P(), sizeof x);
}
/// refused a_kernel_over_a_concrete_view: write_it_as_a_template_over_its_views|invokes a deleted function
void a_kernel_over_a_concrete_view(ProbeExecutor<Host>& on, FirstProbe& first) {
  on.run(1, OverConcreteViews{first.view()});
}
/// refused either_of_two_probed_arrays: operands to|incompatible operand types
void either_of_two_probed_arrays(FirstProbe& first, SecondProbe& second, index_t i) {
  (i % 2 == 0 ? first.view() : second.view())[i].x1111() = 1.0F;
}
/// refused writing_to_a_read_only_probe: this array is read-only here
void writing_to_a_read_only_probe(FirstProbe& first) { first.const_view()[0].x1111() = 1.0F; }
/// refused the_address_of_a_half: only an element that is stored as it is computed has an address
void the_address_of_a_half(ProbeOfHalves& halves) { (void)&halves.view()[0].x1111(); }
/// refused an_array_that_is_no_probe: a ProbeArray has the formats XProbe<ArrayTag, Base> of its object
const ProbeArray<elasticity::StressDerivativeObject, float, Soa, Halves> an_array_that_is_no_probe;

// ---- What is not refused ----
void accepted(ProbeExecutor<Host>& on, FirstProbe& first, Derivatives& plain, WithoutOneArray& pruned) {
  // A question whether code compiles has the same answer for every view: code that does not compile is a use.
  static_assert(requires { first.view().data(); } && requires { plain.view().data(); });
  static_assert(requires { pruned.view().data(); });
  on.run(1, OverAnyViews{first.view()});
}
