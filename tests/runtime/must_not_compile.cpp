// Programs that a compiler must refuse, with words that say what to do: one per CASE_..., which CMakeLists.txt defines.
#include <elasticity.physgen.h>
#include <physgen/fuse.h>
#include <physgen/parallel_for.h>
#include <physgen/parallel_reduce.h>
#include <physgen/rows.h>

using namespace physgen;

namespace {

using Derivatives = elasticity::StressDerivativeArray<float>;
using S = batch_t<float, native_lanes<float>>;
using Indices = batch_t<std::int32_t, native_lanes<float>>;

struct Halves : elasticity::StressDerivativeFormats<Host> {
  using x1111 = format::Half<>;
};

const auto kept = local<elasticity::StressDerivativeObject, float>();

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

void refused(const Derivatives::View& view, Pack<native_lanes<float>> i, const Indices& j,
             const elasticity::NodeForceArray<float>::View& nodes) {
  const S m = view[i].x1111();
#if defined(CASE_if_on_a_mask)
  if (m > S(4.0F)) view[i].x1111() = S(1.0F);
#elif defined(CASE_question_mark_on_a_mask)
  view[i].x1111() = m > S(4.0F) ? S(1.0F) : m;
#elif defined(CASE_reading_a_named_reference)
  const auto old = view[i].x1111();
  view[i].x1111() = m * S(2.0F);
  view[i].x2211() = old;
#elif defined(CASE_assigning_a_named_reference)
  auto x = nodes[0].f();
  x = Eigen::Vector3f(1, 2, 3);
#elif defined(CASE_swapping_named_references)
  auto x = nodes[0].f(), y = nodes[1].f();
  std::swap(x, y);
#elif defined(CASE_calculating_with_a_field)
  const Eigen::Vector3f sum = nodes[0].f() + nodes[1].f();
  (void)sum;
#elif defined(CASE_changing_what_get_returns)
  nodes[0].f().get() += Eigen::Vector3f(1, 2, 3);
#elif defined(CASE_adding_through_gathered_indices)
  view[j].x1111() += m;
#elif defined(CASE_adding_to_a_half)
  Array<elasticity::StressDerivativeObject, float, Host, Soa, Halves> halves(3);
  add(i, halves.view()[j].x1111(), m);
#elif defined(CASE_adding_a_pack_to_one_object)
  add(i, nodes[0].f(), Eigen::Vector3f(1, 2, 3));
#elif defined(CASE_a_sum_of_one_number_for_a_pack)
  (void)sum(Host{}, 5, over<float>([](auto) { return 1.0F; }));
#elif defined(CASE_a_sum_of_references)
  (void)sum(Host{}, 5, over<float>([&](auto k) { return view[k].x1111(); }));
#elif defined(CASE_adding_to_a_named_element)
  auto element = view[j].x1111();
  add(i, element, m);
#elif defined(CASE_storing_to_a_named_element)
  auto element = view[i].x1111();
  store_where(m > S(0.0F), element, m);
#elif defined(CASE_an_unsigned_number_beside_integer_lanes)
  (void)(j < 3U);
#elif defined(CASE_a_neighbour_of_a_pack)
  view[i].x1111() = view[i + 1].x1111();
#elif defined(CASE_a_sum_over_rows_of_another_type)
  const Rows rows(elasticity::IncidenceRangeArray<float>::ConstView(), elasticity::IncidenceArray<float>::ConstView(),
                  0);
  (void)rows.sum(index_t{0}, 0, [&](const auto&) { return 0.5F; });
#elif defined(CASE_a_fold_over_rows_of_another_type)
  const Rows rows(elasticity::IncidenceRangeArray<float>::ConstView(), elasticity::IncidenceArray<float>::ConstView(),
                  0);
  (void)rows.fold(index_t{0}, 0.0F, [&](float total, const auto&) { return total + 0.5; });
#elif defined(CASE_a_gather_from_a_local)
  fused([](auto k) { kept[k].x1111() = kept[numbers(k)].x2211().get(); });
#elif defined(CASE_a_local_outside_of_a_fused_kernel)
  parallel_for(Host{}, 5, over<float>([](auto k) { kept[k].x1111() = S(1.0F); }));
#elif defined(CASE_a_masked_store_to_a_local)
  fused([](auto k) { store_where(wanted<float>(k), kept[k].x1111(), lanes_t<float, decltype(k)>(1.0F)); });
#elif defined(CASE_a_masked_store_to_a_local_of_one_object)
  parallel_for<1>(Host{}, 5, fuse(locals(kept), over<float>([](auto k) { store_where(true, kept[k].x1111(), 1.0F); })));
#elif defined(CASE_a_masked_store_to_a_field_of_a_local)
  const auto forces = local<elasticity::NodeForceObject, float>();
  parallel_for(Host{}, 5, fuse(locals(forces), over<float>([=](auto k) {
                                 using Number = lanes_t<float, decltype(k)>;
                                 store_where(wanted<float>(k), forces[k].f(), Eigen::Matrix<Number, 3, 1>());
                               })));
#elif defined(CASE_a_sum_at_a_local)
  fused([](auto k) { add(k, kept[k].x1111(), lanes_t<float, decltype(k)>(1.0F)); });
#elif defined(CASE_a_local_that_is_not_named)
  const auto other = local<elasticity::StressDerivativeObject, float, FormatsOfSpace, struct Other>();
  fused([=](auto k) { kept[k].x1111() = other[k].x1111().get(); });
#elif defined(CASE_a_local_of_an_outer_group_in_an_inner_one)
  const auto inner = fuse(locals(kept), over<float>([=](auto k) { kept[k].x1111() = kept[k].x2222().get(); }));
  parallel_for(Host{}, 5, fuse(locals(kept), over<float>([=](auto k) { kept[k].x2222() = 1.0F; }), inner));
#elif defined(CASE_a_local_of_an_outermost_group_in_an_innermost_one)
  const auto inner = fuse(locals(kept), over<float>([=](auto k) { kept[k].x1111() = kept[k].x2222().get(); }));
  parallel_for(Host{}, 5, fuse(locals(kept), fuse(locals(), inner)));
#elif defined(CASE_two_locals_of_one_type)
  const auto other = local<elasticity::StressDerivativeObject, float>();
  (void)fuse(locals(kept, other), over<float>([](auto) {}));
#elif defined(CASE_a_fused_step_of_single_objects)
  parallel_for(Host{}, 5, fuse(locals(kept), over<float>([](auto) {}), OneObject{}));
#elif defined(CASE_a_term_of_a_step_in_the_middle)
  parallel_for(Host{}, 5,
               fuse(locals(kept), over<float>([](auto k) { return lanes_t<float, decltype(k)>(1.0F); }),
                    over<float>([](auto) {})));
#elif defined(CASE_a_fused_lambda_without_a_width)
  (void)fuse(locals(kept), [](auto) {});
#elif defined(CASE_a_neighbour_in_a_fused_kernel)
  fused([](auto k) { kept[k].x1111() = kept[k + 1].x1111().get(); });
#elif defined(CASE_a_lambda_without_a_width)
  parallel_for(Host{}, 5, [](auto) {});
#else
  (void)m, (void)j, (void)nodes;
  fused([](auto k) { kept[k].x1111() = lanes_t<float, decltype(k)>(1.0F); });
  view[i].x1111() = m;
#endif
}
