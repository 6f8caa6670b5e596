// Uses of loaded values that could refer to what is gone, or assign to a copy: a compiler must refuse them. refused.py
// compares them with what it reports.
#include <elasticity.physgen.h>
#include <physgen/parallel_for.h>
#include <physgen/rows.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <Eigen/QR>
#include <Eigen/SVD>

using namespace physgen;

namespace {

using Gradients = elasticity::DeformationGradientArray<float>;
using Ranges = elasticity::IncidenceRangeArray<float>;
using Entries = elasticity::IncidenceArray<float>;

struct Given {
  Gradients::View view;
  Rows<Ranges::ConstView, Entries::ConstView> rows;
};

// ---- What a temporary holds ----
/// refused the_memory_of_a_temporary: deleted
void the_memory_of_a_temporary(const Given& g) { (void)g.view[0].F().get().data(); }
/// refused an_iterator_of_a_temporary: deleted
void an_iterator_of_a_temporary(const Given& g) { (void)g.view.get(0).F.begin(); }
/// refused the_end_of_a_temporary: deleted
void the_end_of_a_temporary(const Given& g) { (void)g.view.get(0).F.end(); }
/// refused the_matrix_in_a_temporary: deleted
void the_matrix_in_a_temporary(const Given& g) { (void)g.view.get(0).F.plain(); }
/// refused an_entry_of_a_temporary: lvalue required|expression is not assignable
void an_entry_of_a_temporary(const Given& g) { g.view.get(0).F(0, 1) = 1.0F; }
/// refused assigning_a_temporary: discards qualifiers|no viable overloaded|no match for
void assigning_a_temporary(const Given& g) { g.view.get(0).F = Eigen::Matrix3f(); }

// ---- Copies ----
/// refused assigning_a_part_that_has_a_name: as ‘this’ argument discards qualifiers|no viable overloaded|no match for
void assigning_a_part_that_has_a_name(const Given& g) {
  auto value = g.view.get(0);
  auto part = value.F.col(0);
  part = Eigen::Vector3f();
}
/// refused assigning_a_transpose: THIS_EXPRESSION_IS_NOT_A_LVALUE__IT_IS_READ_ONLY|READ_ONLY
void assigning_a_transpose(const Given& g) {
  auto value = g.view.get(0);
  value.F.transpose() = Eigen::Matrix3f();
}
/// refused adding_to_an_array: READ_ONLY
void adding_to_an_array(const Given& g) {
  auto value = g.view.get(0);
  value.F.array() += 1.0F;
}
/// refused assigning_a_triangle: no match for|no viable overloaded
void assigning_a_triangle(const Given& g) {
  auto value = g.view.get(0);
  value.F.triangularView<Eigen::Upper>() = Eigen::Matrix3f();
}
/// refused adding_to_columns: no match for|discards qualifiers|no viable overloaded
void adding_to_columns(const Given& g) {
  auto value = g.view.get(0);
  value.F.colwise() += Eigen::Vector3f();
}
/// refused normalizing_columns: no match for|discards qualifiers|no viable overloaded
void normalizing_columns(const Given& g) {
  auto value = g.view.get(0);
  value.F.colwise().normalize();
}

// ---- What Eigen refers to ----
/// refused a_solution_of_a_view: a_solution_refers_to_its_decomposition|deleted
void a_solution_of_a_view(const Given& g) { (void)g.view[0].F().get().selfadjointView<Eigen::Lower>().ldlt(); }
/// refused singular_values: a_solution_refers_to_its_decomposition|deleted
void singular_values(const Given& g) { (void)g.view[0].F().get().jacobiSvd(); }
/// refused a_solution: a_solution_refers_to_its_decomposition|deleted
void a_solution(const Given& g) { (void)g.view[0].F().get().ldlt(); }
/// refused a_solution_of_a_difference: a_solution_refers_to_its_decomposition|deleted
void a_solution_of_a_difference(const Given& g) { (void)(g.view[0].F().get() - g.view.get(1).F).partialPivLu(); }
/// refused an_array_that_is_evaluated: an_array_that_is_evaluated|deleted
void an_array_that_is_evaluated(const Given& g) { (void)g.view[0].F().get().array().eval(); }
/// refused a_sum_over_rows_of_what_is_gone: refers to matrices of its own
void a_sum_over_rows_of_what_is_gone(const Given& g) {
  (void)g.rows.sum(index_t{0}, Eigen::Matrix3f(), [&](const auto& entry) {
    const Eigen::Matrix3f F = g.view[entry.element()].F();
    return F * 2.0F;
  });
}
/// refused a_fold_over_rows_of_what_is_gone: refers to matrices of its own
void a_fold_over_rows_of_what_is_gone(const Given& g) {
  (void)g.rows.fold(index_t{0}, Eigen::Matrix3f(), [&](const auto& total, const auto& entry) {
    const Eigen::Matrix3f F = g.view[entry.element()].F();
    return total - F;
  });
}

// ---- What is not refused ----
void accepted(const Given& g) {
  auto value = g.view.get(0);
  value.F.col(0) = value.F.col(1) * 2.0F;
  value.F.row(1) += value.F.row(0);
  value.F.diagonal().setZero();
  value.F.block<2, 2>(0, 1) -= Eigen::Matrix2f();
  value.F.col(1).swap(value.F.col(2));
  value.F << 1, 2, 3, 4, 5, 6, 7, 8, 9;
  value.F.noalias() = value.F * value.F;
  value.F.setIdentity();
  value.F *= value.F;
  const Eigen::Matrix3f& F = g.view[0].F().get();
  g.view[1].F() = Eigen::LDLT<Eigen::Matrix3f>(F).solve(value.F);
  (void)value.F.plain().data();
  (void)g.rows.sum(index_t{0}, value.F, [&](const auto& entry) { return g.view[entry.element()].F().get() * 2.0F; });
}

}  // namespace
