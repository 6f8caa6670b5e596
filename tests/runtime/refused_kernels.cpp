// Kernels that a compiler must refuse, with words that say what to do. refused.py compares them with what it reports.
#include <elasticity.physgen.h>
#include <physgen/distributed/kernel_members.h>
#include <physgen/parallel_for.h>
#include <physgen/parallel_reduce.h>
#include <physgen/rows.h>

using namespace physgen;
using namespace physgen::math;

namespace {

using Derivatives = elasticity::StressDerivativeArray<float>;
using Forces = elasticity::NodeForceArray<float>;
using Tets = elasticity::TetArray<float>;
constexpr int kWidth = native_lanes<float>;
using S = batch_t<float, kWidth>;
using Indices = batch_t<std::int32_t, kWidth>;
using Dynamic = Eigen::Matrix<float, Eigen::Dynamic, 1>;

struct Halves : elasticity::StressDerivativeFormats<Host> {
  using x1111 = format::Half<>;
};
using HalfView = View<elasticity::StressDerivativeObject, float, Soa, Halves, Host>;

/// The arrays that the cases are given.
struct Given {
  Derivatives::View view;
  HalfView halves;
  Forces::View nodes;
  Tets::View tets;
  Pack<kWidth> i{0};
  Indices j;
  S m;
  Rows<elasticity::IncidenceRangeArray<float>::ConstView, elasticity::IncidenceArray<float>::ConstView> rows;
};

}  // namespace

// ---- Conditions ----
/// refused at once if_on_a_mask: a_mask_is_no_bool_so_write_select_or_if_any_of_i_and_it
void if_on_a_mask(const Given& g) {
  if (g.m > S(4.0F)) g.view[g.i].x1111() = S(1.0F);
}
/// refused at once question_mark_on_a_mask: a_mask_is_no_bool_so_write_select_or_if_any_of_i_and_it
void question_mark_on_a_mask(const Given& g) { g.view[g.i].x1111() = g.m > S(4.0F) ? S(1.0F) : g.m; }
/// refused storing_to_a_named_element: write to view[i].m() itself
void storing_to_a_named_element(const Given& g) {
  auto element = g.view[g.i].x1111();
  store_where(g.m > S(0.0F), element, g.m);
}
/// refused any_of_other_lanes_than_the_index: any() and all(): the condition has as many lanes as the index
bool any_of_other_lanes_than_the_index(const Given& g) { return any(Pack<2 * kWidth>{0}, g.m > S(0.0F)); }
/// refused the_largest_of_other_lanes_than_the_index: largest() and smallest(): the value has as many lanes as the
/// index
float the_largest_of_other_lanes_than_the_index(const Given& g) { return largest(Pack<2 * kWidth>{0}, g.m); }
/// refused a_condition_of_other_lanes: condition and field have as many lanes
void a_condition_of_other_lanes(const Given& g, const batch_t<double, native_lanes<double>>& x) {
  store_where(x > batch_t<double, native_lanes<double>>(0.0), g.view[g.i].x1111(), g.m);
}

// ---- Functions of the standard library ----
/// refused at once a_root_by_std: std_has_no_functions_of_packs_so_write_the_call_without_std
void a_root_by_std(const Given& g) { g.view[g.i].x1111() = std::sqrt(g.m); }
/// refused at once a_root_by_std_of_a_loaded_value: std_has_no_functions_of_packs_so_write_the_call_without_std
void a_root_by_std_of_a_loaded_value(const Given& g) { (void)std::sqrt(g.view[g.i].x1111().get()); }
/// refused at once a_power_by_std: std_has_no_functions_of_packs_so_write_the_call_without_std
void a_power_by_std(const Given& g) { (void)std::pow(2.0F, g.m); }
/// refused at once a_root_by_std_of_a_reference: functions_of_packs_take_no_references_so_write_get_of_it_without_std
void a_root_by_std_of_a_reference(const Given& g) { (void)std::sqrt(g.view[g.i].x1111()); }
/// refused at once a_root_of_a_reference: functions_of_packs_take_no_references_so_write_get_of_it_without_std
void a_root_of_a_reference(const Given& g) { (void)sqrt(g.halves[g.i].x1111()); }

// ---- Numbers beside packs ----
/// refused an_unsigned_number_beside_integer_lanes: integer_lanes_beside_a_number_they_cannot_hold
void an_unsigned_number_beside_integer_lanes(const Given& g) { (void)(g.j < 3U); }
/// refused a_float_before_integer_lanes: integer_lanes_beside_a_number_they_cannot_hold
void a_float_before_integer_lanes(const Given& g) { (void)(0.5F * g.j); }
/// refused a_cast_of_what_is_no_number: cast() and to_real() take numbers
void a_cast_of_what_is_no_number() { (void)to_real<float>(nullptr); }
/// refused a_cast_of_a_dynamic_vector: vectors and matrices of kernels have fixed sizes
void a_cast_of_a_dynamic_vector(const Dynamic& x) { (void)cast<double>(x); }
/// refused to_real_of_a_float: to_real() takes integers
void to_real_of_a_float() { (void)to_real<double>(0.5F); }
/// refused to_index_of_an_integer: to_index() takes floating numbers
void to_index_of_an_integer(const Given& g) { (void)to_index(g.j); }

// ---- Neighbours ----
/// refused a_neighbour_of_a_pack: name_neighbours_by_numbers_of_i_plus_one
void a_neighbour_of_a_pack(const Given& g) { g.view[g.i].x1111() = g.view[g.i + 1].x1111(); }
/// refused a_neighbour_before_a_pack: name_neighbours_by_numbers_of_i_plus_one
void a_neighbour_before_a_pack(const Given& g) { g.view[g.i].x1111() = g.view[g.i - 1].x1111(); }
/// refused objects_named_by_floats: objects are named by integers: convert the batch first
void objects_named_by_floats(const Given& g) { (void)g.view[g.m]; }

// ---- Sums at other objects ----
/// refused adding_to_a_half: stored as it is computed
void adding_to_a_half(const Given& g) { add(g.i, g.halves[g.j].x1111(), g.m); }
/// refused adding_to_a_half_of_one_object: stored as it is computed
void adding_to_a_half_of_one_object(const Given& g) { add(index_t{0}, g.halves[0].x1111(), 1.0F); }
/// refused adding_a_pack_to_one_object: there is one sum for W values
void adding_a_pack_to_one_object(const Given& g) { add(g.i, g.nodes[0].f(), Eigen::Vector3f(1, 2, 3)); }
/// refused adding_a_pack_to_one_element: there is one sum for W values
void adding_a_pack_to_one_element(const Given& g) { add(g.i, g.view[0].x1111(), 1.0F); }
/// refused adding_a_pack_to_one_half: there is one sum for W values
void adding_a_pack_to_one_half(const Given& g) { add(g.i, g.halves[0].x1111(), 1.0F); }
/// refused adding_a_float_to_an_integer: the field holds integers, the value is not an integer
void adding_a_float_to_an_integer(const Given& g) { add(index_t{0}, g.tets[0].nodes()[0], 0.5F); }
/// refused adding_to_a_named_element: a_named_reference_is_not_assigned|NotAssigned
void adding_to_a_named_element(const Given& g) {
  auto element = g.view[g.j].x1111();
  add(g.i, element, g.m);
}
/// refused adding_by_a_gathered_index: a gathered index does not know its range
void adding_by_a_gathered_index(const Given& g) { add(g.j, g.view[g.j].x1111(), g.m); }

// ---- Reductions ----
/// refused a_sum_of_one_number_for_a_pack: returned one plain number for W objects
void a_sum_of_one_number_for_a_pack() {
  (void)sum(Host{}, 5, over<float>([](auto) { return 1.0F; }));
}
/// refused a_sum_of_references: returns its term by value
void a_sum_of_references(const Given& g) {
  (void)sum(Host{}, 5, over<float>([&](auto k) { return g.view[k].x1111(); }));
}
/// refused a_sum_of_dynamic_vectors: returns matrices of fixed size
void a_sum_of_dynamic_vectors() {
  (void)sum(Host{}, 5, over<float>([](auto) { return Dynamic(3); }));
}
/// refused packs_of_three: lanes<W>(kernel): packs have 1, 2, 4, 8, 16 or 32 lanes
void packs_of_three() {
  parallel_for(Host{}, 5, lanes<3>(over<float>([](auto) {})));
}
/// refused a_sum_over_packs_of_64_doubles: lanes<W>(kernel): packs have 1, 2, 4, 8, 16 or 32 lanes
void a_sum_over_packs_of_64_doubles() {
  (void)sum(Host{}, 5, lanes<64>(over<double>([](auto) { return 1.0; })));
}
/// refused packs_of_32_doubles: this CPU has no register of W lanes of the kernel's Scalar
void packs_of_32_doubles() {
  parallel_for(Host{}, 5, lanes<32>(over<double>([](auto) {})));
}
/// refused packs_of_a_kernel_of_single_objects: this kernel takes single objects alone
void packs_of_a_kernel_of_single_objects() {
  parallel_for(Host{}, 5, lanes<4>([](index_t) {}));
}
/// refused a_sum_over_packs_of_a_kernel_of_single_objects: this kernel takes single objects alone
void a_sum_over_packs_of_a_kernel_of_single_objects() {
  (void)sum(Host{}, 5, lanes<4>([](index_t) { return 1.0; }));
}
/// refused packs_of_bool: packs hold no field of bool: run the kernel that reads it on single objects, lanes<1>(kernel)
void packs_of_bool(const Given& /*given*/) { const lanes_t<bool, Pack<kWidth>> flags; }
/// refused packs_wider_than_registers: this CPU has no SIMD register of W lanes of T
using packs_wider_than_registers = lanes_t<float, Pack<1024>>;
const packs_wider_than_registers* const wide = nullptr;
/// refused a_lambda_without_a_width: over<float>(lambda)
void a_lambda_without_a_width() {
  parallel_for(Host{}, 5, [](auto) {});
}

/// refused a_lambda_on_several_ranks: write the kernel as a struct of views, Rows and numbers
void a_lambda_on_several_ranks() {
  for_each_view([step = 0.5F](auto) { (void)step; }, [](const KernelView&) {});
}

// ---- Rows ----
/// refused a_sum_over_rows_of_another_type: `total` has another type than the terms
void a_sum_over_rows_of_another_type(const Given& g) {
  (void)g.rows.sum(index_t{0}, 0, [&](const auto&) { return 0.5F; });
}
/// refused a_fold_over_rows_of_another_type: `step` returns another type than that of `total`
void a_fold_over_rows_of_another_type(const Given& g) {
  (void)g.rows.fold(index_t{0}, 0.0F, [&](float total, const auto&) { return total + 0.5; });
}
/// refused rows_of_a_gathered_index: a gathered index has no rows
void rows_of_a_gathered_index(const Given& g) {
  (void)g.rows.sum(g.j, S(0.0F), [&](const auto&) { return S(1.0F); });
}

// ---- What is not refused ----
void accepted(const Given& g) {
  store_where(g.m > S(0.0F), g.view[g.i].x1111(), g.m);
  add(g.i, g.view[g.j].x1111(), g.m);
  parallel_for(Host{}, 5, over<float>([](auto) {}));
  using std::fabs, std::sqrt;  // as code that is written for plain numbers, too
  g.view[g.i].x1111() = sqrt(g.m) + fabs(g.m);
  g.view[0].x1111() = std::sqrt(g.halves[0].x1111());
}
