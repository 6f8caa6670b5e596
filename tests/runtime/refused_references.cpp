// Uses of references that a compiler must refuse, with words that say what to do. refused.py compares them with what it
// reports.
#include <elasticity.physgen.h>
#include <physgen/parallel_for.h>

using namespace physgen;

namespace {

using Derivatives = elasticity::StressDerivativeArray<float>;
using Forces = elasticity::NodeForceArray<float>;
using Tets = elasticity::TetArray<float>;
using Svds = elasticity::DeformationSvdArray<float>;
constexpr int kWidth = native_lanes<float>;
using S = batch_t<float, kWidth>;
using Indices = batch_t<std::int32_t, kWidth>;

using ConstForces = Forces::ConstView;

struct Quaternions : elasticity::DeformationSvdFormats<Host> {
  using U = format::Quaternion16;
};
struct Halves : elasticity::StressDerivativeFormats<Host> {
  using x1111 = format::Half<>;
};
using HalfView = View<elasticity::StressDerivativeObject, float, Soa, Halves, Host>;
using ConstHalfView = View<elasticity::StressDerivativeObject, const float, Soa, Halves, Host>;

/// The arrays that the cases are given.
struct Given {
  Derivatives::View view;
  Derivatives::ConstView read_only;
  HalfView halves;
  ConstHalfView read_only_halves;
  Forces::View nodes;
  Tets::View tets;
  Pack<kWidth> i{0};
  Indices j;
  S m;
};

}  // namespace

// ---- Elements that have a name ----
/// refused reading_a_named_element: a_named_reference_is_read_later_than_it_looks
void reading_a_named_element(const Given& g) {
  const auto old = g.view[g.i].x1111();
  g.view[g.i].x2211() = old;
}
/// refused getting_a_named_element: a_named_reference_is_read_later_than_it_looks
S getting_a_named_element(const Given& g) {
  const auto old = g.view[g.i].x1111();
  return old.get();
}
/// refused at once converting_a_named_element: a_named_reference_is_read_later_than_it_looks
void converting_a_named_element(const Given& g) {
  const auto old = g.view[g.i].x1111();
  const S x = old;
  (void)x;
}
/// refused assigning_a_named_element: a_named_reference_is_not_assigned|NotAssigned
void assigning_a_named_element(const Given& g) {
  auto x = g.view[g.i].x1111();
  x = g.m;
}
/// refused assigning_one_named_element_to_another: deleted
void assigning_one_named_element_to_another(const Given& g) {
  auto x = g.view[g.i].x1111();
  const auto y = g.view[g.i].x2211();
  x = y;
}
/// refused adding_to_a_named_one: a_named_reference_is_not_assigned|NotAssigned
void adding_to_a_named_one(const Given& g) {
  auto x = g.view[g.i].x1111();
  x += g.m;
}
/// refused subtracting_from_a_named_one: a_named_reference_is_not_assigned|NotAssigned
void subtracting_from_a_named_one(const Given& g) {
  auto x = g.view[g.i].x1111();
  x -= g.m;
}
/// refused multiplying_a_named_one: a_named_reference_is_not_assigned|NotAssigned
void multiplying_a_named_one(const Given& g) {
  auto x = g.view[g.i].x1111();
  x *= g.m;
}
/// refused dividing_a_named_one: a_named_reference_is_not_assigned|NotAssigned
void dividing_a_named_one(const Given& g) {
  auto x = g.view[g.i].x1111();
  x /= g.m;
}

/// refused at once calculating_with_a_named_element: a_named_reference_is_read_later_than_it_looks
void calculating_with_a_named_element(const Given& g) {
  auto x = g.view[g.i].x1111();
  g.view[g.i].x2211() = x * g.m;
}
/// refused at once comparing_a_named_element: a_named_reference_is_read_later_than_it_looks
auto comparing_a_named_element(const Given& g) {
  auto x = g.view[g.i].x1111();
  return g.m < x;
}

// ---- Fields that have a name ----
/// refused getting_a_named_field: a_named_reference_is_read_later_than_it_looks
Eigen::Vector3f getting_a_named_field(const Given& g) {
  const auto x = g.nodes[0].f();
  return x.get();
}
/// refused converting_a_named_field: a_named_reference_is_read_later_than_it_looks
void converting_a_named_field(const Given& g) {
  const auto x = g.nodes[0].f();
  const Eigen::Vector3f y = x;
  (void)y;
}
/// refused storing_a_named_field: a_named_reference_is_read_later_than_it_looks
void storing_a_named_field(const Given& g) {
  const auto x = g.nodes[0].f();
  g.nodes[1].f() = x;
}
/// refused assigning_a_named_field: a_named_reference_is_not_assigned|NotAssigned
void assigning_a_named_field(const Given& g) {
  auto x = g.nodes[0].f();
  x = Eigen::Vector3f(1, 2, 3);
}
/// refused adding_to_a_named_field: a_named_reference_is_not_assigned|NotAssigned
void adding_to_a_named_field(const Given& g) {
  auto x = g.nodes[0].f();
  x += Eigen::Vector3f(1, 2, 3);
}
/// refused subtracting_from_a_named_field: a_named_reference_is_not_assigned|NotAssigned
void subtracting_from_a_named_field(const Given& g) {
  auto x = g.nodes[0].f();
  x -= Eigen::Vector3f(1, 2, 3);
}
/// refused multiplying_a_named_field: a_named_reference_is_not_assigned|NotAssigned
void multiplying_a_named_field(const Given& g) {
  auto x = g.nodes[0].f();
  x *= 2.0F;
}
/// refused dividing_a_named_field: a_named_reference_is_not_assigned|NotAssigned
void dividing_a_named_field(const Given& g) {
  auto x = g.nodes[0].f();
  x /= 2.0F;
}
/// refused swapping_named_references: no matching function for call to
void swapping_named_references(const Given& g) {
  auto x = g.nodes[0].f(), y = g.nodes[1].f();
  std::swap(x, y);
}

// ---- Fields in place of their values ----
/// refused adding_fields: calculate_with_what_its_get_returns
void adding_fields(const Given& g) { (void)(g.nodes[0].f() + g.nodes[1].f()); }
/// refused subtracting_fields: calculate_with_what_its_get_returns
void subtracting_fields(const Given& g) { (void)(g.nodes[0].f() - g.nodes[1].f()); }
/// refused multiplying_a_field: calculate_with_what_its_get_returns
void multiplying_a_field(const Given& g) { (void)(2.0F * g.nodes[0].f()); }
/// refused dividing_a_field: calculate_with_what_its_get_returns
void dividing_a_field(const Given& g) { (void)(g.nodes[0].f() / 2.0F); }
/// refused the_negative_of_a_field: calculate_with_what_its_get_returns
void the_negative_of_a_field(const Given& g) { (void)(-g.nodes[0].f()); }
/// refused changing_what_get_returns: no match for |no viable overloaded
void changing_what_get_returns(const Given& g) { g.nodes[0].f().get() += Eigen::Vector3f(1, 2, 3); }
/// refused an_empty_value: an_empty_value_so_use_setZero
void an_empty_value(const Given& g) { g.nodes[0].f() = {}; }
/// refused an_element_of_a_quaternion: a rotation stored as a quaternion has no single elements
float an_element_of_a_quaternion(const View<elasticity::DeformationSvdObject, float, Soa, Quaternions, Host>& svds) {
  return svds[0].U()[0];
}
/// refused a_sum_of_rotations: the sum of two rotations is not a rotation
void a_sum_of_rotations(const Svds::View& svds) { add(index_t{0}, svds[0].U(), Eigen::Matrix3f()); }

// ---- Integers ----
/// refused a_float_added_to_a_field_of_integers: integers_calculate_with_integers_so_convert_first
void a_float_added_to_a_field_of_integers(const Given& g) { g.tets[g.i].nodes() += 0.5F; }
/// refused a_float_subtracted_from_a_field_of_integers: integers_calculate_with_integers_so_convert_first
void a_float_subtracted_from_a_field_of_integers(const Given& g) { g.tets[g.i].nodes() -= 0.5F; }
/// refused a_field_of_integers_times_a_float: integers_calculate_with_integers_so_convert_first
void a_field_of_integers_times_a_float(const Given& g) { g.tets[g.i].nodes() *= 0.5F; }
/// refused a_field_of_integers_over_a_float: integers_calculate_with_integers_so_convert_first
void a_field_of_integers_over_a_float(const Given& g) { g.tets[g.i].nodes() /= 0.5F; }
/// refused a_float_added_to_an_integer: integers_calculate_with_integers_so_convert_first
void a_float_added_to_an_integer(const Given& g) { g.tets[g.i].nodes()[0] += 0.5F; }
/// refused a_float_subtracted_from_an_integer: integers_calculate_with_integers_so_convert_first
void a_float_subtracted_from_an_integer(const Given& g) { g.tets[g.i].nodes()[0] -= 0.5F; }
/// refused an_integer_times_a_float: integers_calculate_with_integers_so_convert_first
void an_integer_times_a_float(const Given& g) { g.tets[g.i].nodes()[0] *= 0.5F; }
/// refused an_integer_over_a_float: integers_calculate_with_integers_so_convert_first
void an_integer_over_a_float(const Given& g) { g.tets[g.i].nodes()[0] /= 0.5F; }

// ---- Sums through gathered indices ----
/// refused adding_through_gathered_indices: use_add_of_the_kernels_own_index|UseAdd
void adding_through_gathered_indices(const Given& g) { g.view[g.j].x1111() += g.m; }
/// refused subtracting_through_gathered_indices: use_add_of_the_kernels_own_index|UseAdd
void subtracting_through_gathered_indices(const Given& g) { g.view[g.j].x1111() -= g.m; }
/// refused multiplying_through_gathered_indices: use_add_of_the_kernels_own_index|UseAdd
void multiplying_through_gathered_indices(const Given& g) { g.view[g.j].x1111() *= g.m; }
/// refused dividing_through_gathered_indices: use_add_of_the_kernels_own_index|UseAdd
void dividing_through_gathered_indices(const Given& g) { g.view[g.j].x1111() /= g.m; }
/// refused adding_a_field_through_gathered_indices: use_add_of_the_kernels_own_index|UseAdd
void adding_a_field_through_gathered_indices(const Given& g) { g.nodes[g.j].f() += Eigen::Matrix<S, 3, 1>(); }
/// refused subtracting_a_field_through_gathered_indices: use_add_of_the_kernels_own_index|UseAdd
void subtracting_a_field_through_gathered_indices(const Given& g) { g.nodes[g.j].f() -= Eigen::Matrix<S, 3, 1>(); }
/// refused multiplying_a_field_through_gathered_indices: use_add_of_the_kernels_own_index|UseAdd
void multiplying_a_field_through_gathered_indices(const Given& g) { g.nodes[g.j].f() *= g.m; }
/// refused dividing_a_field_through_gathered_indices: use_add_of_the_kernels_own_index|UseAdd
void dividing_a_field_through_gathered_indices(const Given& g) { g.nodes[g.j].f() /= g.m; }

// ---- Arrays that are read only ----
/// refused storing_to_a_read_only_element: assignment of read-only location|cannot assign to return value
void storing_to_a_read_only_element(const Given& g) { g.read_only[0].x1111() = 1.0F; }
/// refused storing_a_pack_to_a_read_only_array: this array is read-only here
void storing_a_pack_to_a_read_only_array(const Given& g) { g.read_only[g.i].x1111() = g.m; }
/// refused storing_to_gathered_objects_of_a_read_only_array: this array is read-only here
void storing_to_gathered_objects_of_a_read_only_array(const Given& g) { g.read_only[g.j].x2211() = g.m; }
/// refused storing_to_a_read_only_half: this array is read-only here
void storing_to_a_read_only_half(const Given& g) { g.read_only_halves[0].x1111() = 1.0F; }
/// refused storing_a_pack_to_a_read_only_array_of_halves: this array is read-only here
void storing_a_pack_to_a_read_only_array_of_halves(const Given& g) { g.read_only_halves[g.i].x1111() = g.m; }
/// refused adding_to_a_read_only_vector: this array is read-only here
void adding_to_a_read_only_vector(const ConstForces& forces) {
  add(index_t{0}, forces[0].f(), Eigen::Vector3f(1, 2, 3));
}
/// refused storing_where_an_array_is_read_only: this array is read-only here
void storing_where_an_array_is_read_only(const Given& g) { store_where(g.m > S(0.0F), g.read_only[g.i].x3311(), g.m); }
/// refused adding_where_an_array_is_read_only: this array is read-only here
void adding_where_an_array_is_read_only(const Given& g) { add(g.i, g.read_only[g.j].x2222(), g.m); }

// ---- Names that are not there ----
/// refused at once a_misspelt_field: has no member named ‘x1112’; did you mean|no member named 'x1112' in
/// 'physgen::ObjectRef<
void a_misspelt_field(const Given& g) { g.view[g.i].x1112() = g.m; }

// ---- What is not refused ----
void accepted(const Given& g) {
  g.view[g.i].x1111() = g.m;
  g.halves[g.i].x1111() = g.view[g.i].x1111().get();
  add(g.i, g.view[g.j].x1111(), g.m);
  g.nodes[0].f().setZero();
}

// ---- Structured bindings ----
/// refused binding_names_to_the_fields_of_a_reference: write auto [x, v] = view[i].get(), whose names are values
void binding_names_to_the_fields_of_a_reference(Svds& array) {
  auto [U, V, s] = array[3];
  (void)s;
}
/// refused binding_names_in_a_loop: write auto [x, v] = view[i].get(), whose names are values
void binding_names_in_a_loop(const Svds& array) {
  for (const auto& [U, V, s] : array) (void)s;
}
