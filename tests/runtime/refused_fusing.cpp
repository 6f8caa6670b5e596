// Fused kernels that a compiler must refuse, with words that say what to do. refused.py compares them with what it
// reports.
#include <elasticity.physgen.h>
#include <physgen/fuse.h>
#include <physgen/parallel_for.h>

using namespace physgen;

namespace {

const auto kept = local<elasticity::StressDerivativeObject, float>();

/// As in scenes, where a local's tag says which array it stands for.
namespace tags {
struct svds;
}
const auto svds = local<elasticity::DeformationSvdObject, float, FormatsOfSpace, tags::svds>();

/// A step that looks at other objects: at a number, or at one that an array holds.
template <class View, class Tets>
struct Neighbours {
  using Scalar = float;
  View from;
  Tets tets;
  template <class I>
  void operator()(I i) const {
    (void)from[tets[i].nodes()[1]].s().get();
  }
};
template <class View, class Tets>
Neighbours(View, Tets) -> Neighbours<View, Tets>;

/// A step that stores some objects alone.
template <class View>
struct Masks {
  using Scalar = float;
  View to;
  template <class I>
  void operator()(I i) const {
    store_where(wanted<float>(i), to[i].V()[2], lanes_t<float, I>(1.0F));
  }
};
template <class View>
Masks(View) -> Masks<View>;

/// A step that adds.
template <class View>
struct Sums {
  using Scalar = float;
  View to;
  template <class I>
  void operator()(I i) const {
    add(i, to[i].s(), Eigen::Matrix<lanes_t<float, I>, 3, 1>());
  }
};
template <class View>
Sums(View) -> Sums<View>;

/// A step of a fused kernel, with a body.
template <class Body>
void fused(const Body& body) {
  parallel_for(Host{}, 5, fuse(locals(kept), over<float>(body)));
}

/// A kernel that takes one object at a time.
struct OneObject {
  using Scalar = float;
  void operator()(index_t /*i*/) const {}
};

}  // namespace

/// refused a_gather_from_a_local: has the objects at the kernel's own index alone
void a_gather_from_a_local() {
  fused([](auto k) { kept[k].x1111() = kept[numbers(k)].x2211().get(); });
}
/// refused a_local_outside_of_a_fused_kernel: what other objects or other kernels read needs an array
void a_local_outside_of_a_fused_kernel() {
  parallel_for(Host{}, 5, over<float>([](auto k) { kept[k].x1111() = lanes_t<float, decltype(k)>(1.0F); }));
}
/// refused a_gather_of_an_arrays_local: has the objects at the kernel's own index alone
/// naming Neighbours<; tags::svds; {"s"}
void a_gather_of_an_arrays_local(const elasticity::TetView<const float, Aosoa<16>>& tets) {
  parallel_for(Host{}, 5, fuse(locals(svds), Neighbours{svds, tets}));
}
/// refused a_masked_store_to_an_arrays_local: store_where() to a local of fuse
/// naming Masks<; tags::svds; {"V"}
void a_masked_store_to_an_arrays_local() { parallel_for(Host{}, 5, fuse(locals(svds), Masks{svds})); }
/// refused a_sum_at_an_arrays_local: add() to a local of fuse
/// naming Sums<; tags::svds; {"s"}
void a_sum_at_an_arrays_local() { parallel_for(Host{}, 5, fuse(locals(svds), Sums{svds})); }
/// refused a_masked_store_to_a_local: store_where() to a local of fuse
void a_masked_store_to_a_local() {
  fused([](auto k) { store_where(wanted<float>(k), kept[k].x1111(), lanes_t<float, decltype(k)>(1.0F)); });
}
/// refused a_step_that_states_its_lanes: lanes<W>(fuse(...))
void a_step_that_states_its_lanes() {
  parallel_for(Host{}, 5, fuse(locals(kept), lanes<1>(over<float>([](auto k) { kept[k].x1111() = 1.0F; }))));
}
/// refused a_masked_store_to_a_local_of_one_object: store_where() to a local of fuse
void a_masked_store_to_a_local_of_one_object() {
  parallel_for(Host{}, 5,
               lanes<1>(fuse(locals(kept), over<float>([](auto k) { store_where(true, kept[k].x1111(), 1.0F); }))));
}
/// refused a_masked_store_to_a_field_of_a_local: store_where() to a local of fuse
void a_masked_store_to_a_field_of_a_local() {
  const auto forces = local<elasticity::NodeForceObject, float>();
  parallel_for(Host{}, 5, fuse(locals(forces), over<float>([=](auto k) {
                                 using Number = lanes_t<float, decltype(k)>;
                                 store_where(wanted<float>(k), forces[k].f(), Eigen::Matrix<Number, 3, 1>());
                               })));
}
/// refused a_sum_at_a_local: add() to a local of fuse
void a_sum_at_a_local() {
  fused([](auto k) { add(k, kept[k].x1111(), lanes_t<float, decltype(k)>(1.0F)); });
}
/// refused a_local_that_is_not_named: this local is not among those that locals(...) names
/// naming StressDerivativeObject; Other
void a_local_that_is_not_named() {
  const auto other = local<elasticity::StressDerivativeObject, float, FormatsOfSpace, struct Other>();
  fused([=](auto k) { kept[k].x1111() = other[k].x1111().get(); });
}
/// refused a_local_of_an_outer_group_in_an_inner_one: name it in the outer locals(...) alone
void a_local_of_an_outer_group_in_an_inner_one() {
  const auto inner = fuse(locals(kept), over<float>([=](auto k) { kept[k].x1111() = kept[k].x2222().get(); }));
  parallel_for(Host{}, 5, fuse(locals(kept), over<float>([=](auto k) { kept[k].x2222() = 1.0F; }), inner));
}
/// refused a_local_of_an_outermost_group_in_an_innermost_one: name it in the outer locals(...) alone
void a_local_of_an_outermost_group_in_an_innermost_one() {
  const auto inner = fuse(locals(kept), over<float>([=](auto k) { kept[k].x1111() = kept[k].x2222().get(); }));
  parallel_for(Host{}, 5, fuse(locals(kept), fuse(locals(), inner)));
}
/// refused two_locals_of_one_type: two locals have one type
void two_locals_of_one_type() {
  const auto other = local<elasticity::StressDerivativeObject, float>();
  (void)fuse(locals(kept, other), over<float>([](auto) {}));
}
/// refused a_fused_step_of_single_objects: takes no packs, since its call operator is not a template over the index
/// naming OneObject
void a_fused_step_of_single_objects() {
  parallel_for(Host{}, 5, fuse(locals(kept), over<float>([](auto) {}), OneObject{}));
}
/// refused a_term_of_a_step_in_the_middle: a step before the last one returns a term
void a_term_of_a_step_in_the_middle() {
  parallel_for(Host{}, 5,
               fuse(locals(kept), over<float>([](auto k) { return lanes_t<float, decltype(k)>(1.0F); }),
                    over<float>([](auto) {})));
}
/// refused a_fused_lambda_without_a_width: or over<float>(lambda
void a_fused_lambda_without_a_width() {
  (void)fuse(locals(kept), [](auto) {});
}
/// refused a_neighbour_in_a_fused_kernel: name_neighbours_by_numbers_of_i_plus_one
void a_neighbour_in_a_fused_kernel() {
  fused([](auto k) { kept[k].x1111() = kept[k + 1].x1111().get(); });
}
/// refused a_neighbour_before_a_fused_kernels: name_neighbours_by_numbers_of_i_plus_one
void a_neighbour_before_a_fused_kernels() {
  fused([](auto k) { kept[k].x1111() = kept[k - 1].x1111().get(); });
}
/// refused no_steps: fuse(): there are no steps
void no_steps() { (void)fuse(locals(kept)); }

// ---- What is not refused ----
void accepted() {
  fused([](auto k) { kept[k].x1111() = lanes_t<float, decltype(k)>(1.0F); });
}
