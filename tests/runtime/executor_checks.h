// Programs over an executor: one source for the CPU and for CUDA. Included behind executor.h or cuda/executor.h.
#pragma once

#include <elasticity.physgen.h>
#include <gtest/gtest.h>
#include <physgen/launch/reduce.h>

#include <cmath>

namespace physgen {

/// x = x / 2 + 1, component by component: what is left to the limit 2 is halved.
template <class View>
struct ComeHalfway {
  using Scalar = typename View::Precision;
  View positions;  ///< elasticity::NodePosition
  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    using S = lanes_t<Scalar, I>;
    using Vector = Eigen::Matrix<S, 3, 1>;
    const Vector x = positions[i].x();
    positions[i].x() = Vector(x * S(Scalar(0.5)) + Vector::Constant(S(Scalar(1))));
  }
};
template <class View>
ComeHalfway(View) -> ComeHalfway<View>;

/// Sum of (x - 2)^2 over all components.
template <class View>
struct SquaredWay {
  using Scalar = typename View::Precision;
  View positions;  ///< elasticity::NodePosition
  template <class I>
  PHYSGEN_FUNCTION auto operator()(I i) const -> lanes_t<Scalar, I> {
    using S = lanes_t<Scalar, I>;
    S sum(Scalar(0));
    for (int k = 0; k < 3; ++k) {
      const S x = positions[i].x()[k], way = x - S(Scalar(2));
      sum = sum + way * way;
    }
    return sum;
  }
};
template <class View>
SquaredWay(View) -> SquaredWay<View>;

/// f = (square, rounds so far, 0)
template <class View>
struct CountRound {
  View state;  ///< elasticity::NodeForce, one
  PHYSGEN_FUNCTION void operator()(double square) const {
    const auto f = state[index_t{0}].f();
    f[0] = square;
    f[1] += 1.0;
  }
};
template <class View>
CountRound(View) -> CountRound<View>;

template <class View>
struct IsNear {
  View state;
  double most;
  PHYSGEN_FUNCTION bool operator()() const { return double(state[index_t{0}].f()[0]) <= most; }
};
template <class View>
IsNear(View, double) -> IsNear<View>;

template <class On>
class Executors {
 public:
  using Space = typename On::Space;
  using Positions = elasticity::NodePositionArray<double, Space>;
  using State = elasticity::NodeForceArray<double, Space>;

  explicit Executors(On& on, index_t n) : on_(on), positions_(n), state_(1) {}

  /// Positions that are 2 + 2^k away, k = 0 .. 2, and no rounds yet.
  void begin() {
    elasticity::NodePositionArray<double> host(positions_.size());
    for (index_t i = 0; i < host.size(); ++i) {
      for (int k = 0; k < 3; ++k) host.view()[i].x()[k] = 2 + std::ldexp(i % 2 == 0 ? 1.0 : -1.0, k);
    }
    elasticity::NodeForceArray<double> none(1);
    none.view()[0].f() = Eigen::Vector3d(-1, 0, 0);
    on_.wait();
    copy(positions_, host);
    copy(state_, none);
    synchronize();
  }
  void run(typename On::Loop& loop, int most, double near) {
    on_.repeat(
        loop, most,
        [&] {
          on_.run(positions_.size(), ComeHalfway{positions_.view()});
          on_.reduce(positions_.size(), SquaredWay{positions_.const_view()}, Sum{}, CountRound{state_.view()});
        },
        IsNear{state_.const_view(), near});
  }
  /// Expects so many rounds, and positions and their sum to be what that many rounds make of them.
  void expect(int rounds, const char* what) {
    const auto state = on_.value(state_);
    const auto n = static_cast<double>(positions_.size());
    EXPECT_EQ(state.f[1], rounds) << what;
    EXPECT_EQ(state.f[0], rounds == 0 ? -1 : n * 21 * std::ldexp(1.0, -2 * rounds)) << what;
    elasticity::NodePositionArray<double> host(positions_.size());
    copy(host, positions_);
    synchronize();
    for (index_t i = 0; i < host.size(); ++i) {
      for (int k = 0; k < 3; ++k) {
        const double way = std::ldexp(i % 2 == 0 ? 1.0 : -1.0, k - rounds);
        ASSERT_EQ(double(host.const_view()[i].x()[k]), 2 + way) << what << ", object " << i;
      }
    }
  }

 private:
  On& on_;
  Positions positions_;
  State state_;
};

/// A loop ends when it is done or has had its rounds; it can be run again, with other rounds and other values.
template <class On>
void check_loops(On& on) {
  for (const index_t n : {1, 37, 5000}) {
    Executors<On> program(on, n);
    typename On::Loop loop;
    const double near = double(n) * 21 * std::ldexp(1.0, -2 * 9);  // after nine rounds
    program.begin();
    program.run(loop, 100, near);
    program.expect(9, "until it is done");
    program.begin();
    program.run(loop, 4, near);
    program.expect(4, "at most four rounds");
    program.run(loop, 100, near);
    program.expect(9, "and on from there");
    program.run(loop, 100, near);
    program.expect(10, "one round, before it is asked whether it is done");
    program.begin();
    program.run(loop, 0, near);
    program.expect(0, "no round");
    program.run(loop, 1, near);
    program.expect(1, "one round");
  }
}

/// value() is of one object.
template <class On>
void check_values(On& on) {
  elasticity::NodeForceArray<double, typename On::Space> two(2);
  try {
    (void)on.value(two);
    FAIL() << "the value of two objects";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("value() is of an array of one object; this one has 2"), std::string::npos)
        << error.what();
  }
}

}  // namespace physgen
