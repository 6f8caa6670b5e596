// Doubles beside floats, which packs would round and one object would not: a compiler must refuse them, with words that
// say what to write. refused.py compares them with what it reports.
#include <elasticity.physgen.h>
#include <physgen/parallel_for.h>
#include <physgen/parallel_reduce.h>

using namespace physgen;
using namespace physgen::math;

namespace {

using Derivatives = elasticity::StressDerivativeArray<float>;
using DoubleDerivatives = elasticity::StressDerivativeArray<double>;
constexpr int kWidth = native_lanes<float>;
using S = batch_t<float, kWidth>;
using Doubles = batch_t<double, native_lanes<double>>;
using Integers = batch_t<std::int32_t, kWidth>;

struct Halves : elasticity::StressDerivativeFormats<Host> {
  using x1111 = format::Half<>;
};
using HalfView = View<elasticity::StressDerivativeObject, float, Soa, Halves, Host>;

/// What the cases are given.
struct Given {
  Derivatives::View view;
  HalfView halves;
  DoubleDerivatives::View doubles;
  Pack<kWidth> i{0};
  S r;
  Doubles x;
  Integers n;
  double step = 0.1;
};

}  // namespace

// ---- Packs ----
/// refused a_product_with_a_literal: so_write_S_of_it
S a_product_with_a_literal(const Given& g) { return g.r * 0.1; }
/// refused a_quotient_of_a_literal: so_write_S_of_it
S a_quotient_of_a_literal(const Given& g) { return 1.0 / g.r; }
/// refused a_sum_with_a_variable: so_write_S_of_it
S a_sum_with_a_variable(const Given& g) { return g.r + g.step; }
/// refused a_difference_from_a_variable: so_write_S_of_it
S a_difference_from_a_variable(const Given& g) { return g.step - g.r; }
/// refused a_comparison_with_a_literal: so_write_S_of_it
auto a_comparison_with_a_literal(const Given& g) { return g.r < 0.1; }
/// refused a_comparison_of_a_literal: so_write_S_of_it
auto a_comparison_of_a_literal(const Given& g) { return 0.1 >= g.r; }
/// refused equality_with_a_literal: so_write_S_of_it
auto equality_with_a_literal(const Given& g) { return g.r == 0.1; }
/// refused adding_a_literal: so_write_S_of_it
void adding_a_literal(S r) { r += 0.1; }
/// refused multiplying_by_a_variable: so_write_S_of_it
void multiplying_by_a_variable(S r, double step) { r *= step; }
/// refused a_long_double_beside_doubles: so_write_S_of_it
Doubles a_long_double_beside_doubles(const Given& g) { return g.x * 0.1L; }
/// refused an_entry_of_a_vector_times_a_literal: so_write_S_of_it
S an_entry_of_a_vector_times_a_literal(const Eigen::Matrix<S, 3, 1>& x) { return x[0] * 0.1; }
/// refused a_field_times_a_literal: so_write_S_of_it
S a_field_times_a_literal(const Given& g) { return g.view[g.i].x1111() * 0.1; }
/// refused a_literal_minus_a_field_of_halves: so_write_S_of_it
S a_literal_minus_a_field_of_halves(const Given& g) { return 1.0 - g.halves[g.i].x1111(); }
/// refused a_field_compared_with_a_literal: so_write_S_of_it
auto a_field_compared_with_a_literal(const Given& g) { return g.view[g.i].x1111() != 0.1; }
/// refused adding_a_literal_to_a_field: so_write_S_of_it
void adding_a_literal_to_a_field(const Given& g) { g.view[g.i].x1111() += 0.1; }
/// refused dividing_a_half_of_one_object: so_write_S_of_it
void dividing_a_half_of_one_object(const Given& g) { g.halves[0].x1111() /= 0.1; }
/// refused a_double_where_a_function_takes_two_packs: no matching function
S a_double_where_a_function_takes_two_packs(const Given& g) { return atan2(g.r, 0.1); }
/// refused multiplying_integers_by_a_float: integer_lanes_beside_a_number_they_cannot_hold
void multiplying_integers_by_a_float(Integers n) { n *= 0.5F; }
/// refused integers_modulo_an_unsigned_number: integer_lanes_beside_a_number_they_cannot_hold
Integers integers_modulo_an_unsigned_number(const Given& g) { return g.n % 3U; }
/// refused floats_times_integers: no match for|invalid operands
auto floats_times_integers(const Given& g) { return g.r * g.n; }
/// refused a_field_times_integers: no match for|invalid operands
auto a_field_times_integers(const Given& g) { return g.view[g.i].x1111() * g.n; }
/// refused integers_compared_with_floats: no match for|invalid operands
auto integers_compared_with_floats(const Given& g) { return g.n < g.r; }
/// refused floats_plus_doubles: no match for|invalid operands
auto floats_plus_doubles(const Given& g) { return g.r + g.x; }
/// refused floats_made_of_the_bits_of_integers: no matching function|no matching conversion
S floats_made_of_the_bits_of_integers(const Given& g) { return S(g.n); }
/// refused integers_made_of_the_bits_of_floats: no matching function|no matching conversion
Integers integers_made_of_the_bits_of_floats(const Given& g) { return Integers(g.r); }
/// refused a_mask_times_floats: no match for|invalid operands
auto a_mask_times_floats(const Given& g) { return (g.r > S(1)) * g.r; }
/// refused a_mask_plus_a_mask: no match for|invalid operands
auto a_mask_plus_a_mask(const Given& g) { return (g.r > S(1)) + (g.r < S(2)); }

// ---- One object, in a kernel that packs could be given to ----
/// refused one_product_with_a_literal: so_write_S_of_it
template <class View>
struct OneProductWithALiteral {
  using Scalar = typename View::Precision;
  View view;
  template <class I>
  void operator()(I i) const {
    const lanes_t<Scalar, I> r = view[i].x1111();
    view[i].x2211() = lanes_t<Scalar, I>(r * 0.1);
  }
};
void one_product_with_a_literal(const Given& g) {
  parallel_for(Host{}, 5, lanes<1>(OneProductWithALiteral<Derivatives::View>{g.view}));
}
/// refused one_field_compared_with_a_variable: so_write_S_of_it
template <class View>
struct OneFieldComparedWithAVariable {
  using Scalar = typename View::Precision;
  View view;
  double least;
  template <class I>
  auto operator()(I i) const {
    return view[i].x1111() < least;
  }
};
void one_field_compared_with_a_variable(const Given& g) {
  (void)parallel_reduce(Host{}, 5, lanes<1>(OneFieldComparedWithAVariable<Derivatives::View>{g.view, 0.1}), All{});
}
/// refused adding_a_literal_to_one_field: so_write_S_of_it
void adding_a_literal_to_one_field(const Given& g) {
  parallel_for(Host{}, 5, lanes<1>(over<float>([view = g.view](auto i) { view[i].x1111() += 0.1; })));
}
/// refused one_half_times_a_literal: so_write_S_of_it
void one_half_times_a_literal(const Given& g) {
  parallel_for(Host{}, 5,
               lanes<1>(over<float>([view = g.halves](auto i) { view[i].x2211() = view[i].x1111() * 0.1; })));
}
/// refused a_neighbour_times_a_literal: so_write_S_of_it
void a_neighbour_times_a_literal(const Given& g) {
  parallel_for(Host{}, 5, lanes<1>(over<float>([view = g.view](auto i) {
                 const lanes_t<std::int32_t, decltype(i)> next = numbers(i) + 1;
                 view[i].x2211() = static_cast<float>(view[next].x1111() * 0.1);
               })));
}

// ---- What is not refused ----
void accepted(const Given& g, S r, Doubles x) {
  g.view[g.i].x1111() = max(r * 2 + 3U, 0.0);
  g.view[g.i].x2211() += 1;
  g.view[g.i].x2211() = select(r < 2, clamp(r, 0.0, 1.0), 0.1);
  g.doubles[Pack<native_lanes<double>>{0}].x1111() = 0.1 * x + x * 0.1F;
  const Eigen::Matrix<S, 3, 1> y = Eigen::Matrix<S, 3, 1>::Constant(r) * 0.1;
  g.view[g.i].x3311() = y.sum() * 0.5F;
  // A kernel over index_t computes with plain numbers, a generic one with those of S.
  parallel_for(Host{}, 5,
               lanes<1>([view = g.view](index_t i) { view[i].x1111() = static_cast<float>(view[i].x1111() * 0.1); }));
  parallel_for(Host{}, 5, lanes<1>(over<double>([view = g.doubles](auto i) { view[i].x1111() *= 0.1; })));
  parallel_for(Host{}, 5, lanes<1>(over<float>([view = g.view](auto i) {
                 using T = lanes_t<float, decltype(i)>;
                 auto& element = view[i].x1111();
                 const auto value = view[i].x2211();
                 element = max(value, 0.0) * 2 + T(0.1);
                 if (value > 4 || std::sqrt(value) < 2.0F) element = pow(value, 2.0);
                 const float plain = value;
                 view[i].x3311() = value > T(1) ? T(plain) : value;
               })));
}
