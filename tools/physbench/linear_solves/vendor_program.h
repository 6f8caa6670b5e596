// The vendor's method as a program over an executor, so that its logic is tested where there is no GPU: conjugate
// gradients with block Jacobi over a product that somebody else makes.
#pragma once

#include <fem/solver/assembled_stiffness.h>
#include <fem/solver/linear/conjugate_gradients.h>
#include <fem/solver/solvers/measure_linear.h>

#include <cmath>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "linear_solves/vendor_measurement.h"
#include "linear_solves/vendor_steps.h"

namespace physgen::bench {

/// Solves K dx = -force in float.
/// @tparam Product y = K x of the vectors that it is made for, in the stream of the executor: run(), name(), bytes(),
/// `seconds` of one, and forget_error() after one that could not be recorded
template <class On, class Product>
class VendorProgram {
 public:
  using Space = typename On::Space;

  /// @param on lives as long as this
  /// @param make (x, y, stream) -> std::unique_ptr<Product>; the vectors have three floats a node without gaps
  template <class Make>
  VendorProgram(On& on, const fem::AssembledStiffness& stiffness, std::span<const std::uint8_t> fixed,
                std::span<const fem::Point> force, const Make& make)
      : nodes_(static_cast<index_t>(stiffness.nodes.size())),
        on_(on),
        force_(nodes_),
        step_(nodes_),
        residual_(nodes_),
        correction_(nodes_),
        direction_(nodes_),
        product_of_direction_(nodes_),
        inverse_(nodes_),
        product_(make(reinterpret_cast<float*>(direction_.untyped().base),
                      reinterpret_cast<float*>(product_of_direction_.untyped().base), on_.stream())) {
    store_blocks(stiffness, fixed);
    store_force(fixed, force);
  }

  VendorMeasurement measure(const fem::LinearTask& task) {
    const bool by_length = task.norm == fem::LinearNorm::euclidean;
    std::vector<double> preparation, solution;
    for (int k = 0; k <= task.repeats; ++k) {
      const double prepared = fem::detail::seconds_of(on_, [&] { invert_blocks(); });
      const double solved = fem::detail::seconds_of(on_, [&] {
        on_.run(1, fem::SetTolerance{numbers_.state.view(), task.tolerance});
        on_.reduce(nodes_,
                   BeginVendorSolve{force_.const_view(), inverse_.const_view(), step_.view(), residual_.view(),
                                    correction_.view(), direction_.view()},
                   Sum{}, fem::SetFirstNorm{numbers_.state.view()});
        iterate(by_length ? task.tolerance * force_length_ : 0.0);
      });
      if (k == 0) continue;  // the loop was recorded in it
      preparation.push_back(prepared);
      solution.push_back(solved);
    }
    VendorMeasurement result;
    result.measured.result = fem::linear_result(on_, numbers_);
    result.measured.preconditioner_seconds = fem::median(preparation);
    result.measured.solve_seconds = fem::median(solution);
    result.measured.product_seconds = product_->seconds;
    result.measured.product_bytes = product_->bytes();
    result.measured.iteration_bytes = iteration_bytes();
    result.product = product_->name();
    result.note = note_;
    return result;
  }

  void read_step(std::vector<fem::Point>& step) const { fem::detail::read_step(on_, step_, step); }

 private:
  using Vector = elasticity::NodeDisplacementArray<float, Space, Aos>;
  using Force = elasticity::NodeForceDifferentialArray<float, Space, Aos>;
  static_assert(Vector::record_bytes == 12 && Force::record_bytes == 12, "libraries' vectors have no gaps");
  /// Checks of convergence are a kernel each: one for so many iterations. What is done behind the end changes nothing.
  static constexpr int iterations_per_check = 4;
  static constexpr int most_iterations = 200000;

  /// As linear_result() wants it.
  struct Numbers {
    quasistatic::LinearSolveArray<double, Space> state{1};
  };

  void store_blocks(const fem::AssembledStiffness& stiffness, std::span<const std::uint8_t> fixed) {
    elasticity::NodeStiffnessArray<float> blocks(nodes_);
    quasistatic::NodeConstraintArray<float> constraints(nodes_);
    for (index_t n = 0; n < nodes_; ++n) {
      const auto node = static_cast<std::size_t>(n);
      Eigen::Matrix3f K;
      for (int k = 0; k < 9; ++k) K.data()[k] = static_cast<float>(stiffness.nodes[node][static_cast<std::size_t>(k)]);
      blocks.view()[n].K() = K;
      constraints.view()[n].fixed() = fixed[node];
    }
    blocks_ = fem::moved_to<decltype(blocks_)>(blocks);
    constraints_ = fem::moved_to<decltype(constraints_)>(constraints);
    scales_ = decltype(scales_)(nodes_);
    scaled_ = decltype(scaled_)(nodes_);
  }
  void store_force(std::span<const std::uint8_t> fixed, std::span<const fem::Point> force) {
    if (static_cast<index_t>(force.size()) != nodes_) {
      throw Error("a right-hand side of " + std::to_string(force.size()) + " nodes for a stiffness of " +
                  std::to_string(nodes_));
    }
    elasticity::NodeForceDifferentialArray<float, Host, Aos> host(nodes_);
    double square = 0;
    for (index_t n = 0; n < nodes_; ++n) {
      const auto node = static_cast<std::size_t>(n);
      for (int k = 0; k < 3; ++k) {
        const bool is_free = (fixed[node] >> k & 1) == 0;
        const double f = is_free ? force[node][static_cast<std::size_t>(k)] : 0.0;
        host.view()[n].df()[k] = static_cast<float>(f);
        square += f * f;
      }
    }
    copy(force_, host);
    synchronize();
    force_length_ = std::sqrt(square);
  }

  /// The inverses that the solver's block Jacobi has, in unknowns that are not scaled.
  void invert_blocks() {
    on_.run(nodes_, fem::ComputeNodeScale{true, blocks_.const_view(), scales_.view()});
    on_.run(nodes_, fem::ScaleNodes{blocks_.const_view(), constraints_.const_view(), scales_.const_view(),
                                    scaled_.view(), inverse_.view()});
  }

  void iterate_once(double length) {
    on_.run(nodes_, TurnVendorDirection{numbers_.state.const_view(), correction_.const_view(), direction_.view()});
    product_->run();
    on_.reduce(nodes_, fem::Curvature{direction_.const_view(), product_of_direction_.const_view()}, Sum{},
               fem::SetLength{numbers_.state.view()});
    on_.reduce(nodes_,
               TakeVendorStep{numbers_.state.const_view(), direction_.const_view(), product_of_direction_.const_view(),
                              inverse_.const_view(), step_.view(), residual_.view(), correction_.view()},
               Sum{}, SetVendorNorms{numbers_.state.view(), length});
  }

  /// Until the state says that it has ended: in a graph whose rounds the device decides on, as the solver's, so that
  /// nothing waits for the host; or, where the library cannot be recorded, by launches, of which enough are under way.
  void iterate(double length) {
    if (note_.empty()) {
      try {
        on_.repeat(
            loop_, most_iterations / iterations_per_check,
            [&] {
              for (int k = 0; k < iterations_per_check; ++k) iterate_once(length);
            },
            fem::HasEnded{numbers_.state.const_view()});
        is_recorded_ = true;
        return;
      } catch (const Error& error) {
        if (is_recorded_) throw;
        product_->forget_error();
        note_ = std::string("launched one by one, since the loop cannot be recorded: ") + error.what();
      }
    }
    constexpr int iterations_per_wait = 32;
    for (int done = 0; done < most_iterations; done += iterations_per_wait) {
      for (int k = 0; k < iterations_per_wait; ++k) iterate_once(length);
      if (int{on_.value(numbers_.state).status} != static_cast<int>(fem::LinearStatus::running)) return;
    }
  }

  /// As count_bytes.h counts them.
  [[nodiscard]] index_t iteration_bytes() {
    fem::ByteCounter<Space> counter;
    counter.run(nodes_, TurnVendorDirection{numbers_.state.const_view(), correction_.const_view(), direction_.view()});
    counter.add(product_->bytes());
    counter.run(nodes_, fem::Curvature{direction_.const_view(), product_of_direction_.const_view()});
    counter.run(nodes_,
                TakeVendorStep{numbers_.state.const_view(), direction_.const_view(), product_of_direction_.const_view(),
                               inverse_.const_view(), step_.view(), residual_.view(), correction_.view()});
    return counter.bytes();
  }

  index_t nodes_;
  On& on_;
  Force force_;
  Vector step_;
  Force residual_;
  Vector correction_, direction_;
  Force product_of_direction_;
  elasticity::NodeStiffnessArray<float, Space> blocks_, scaled_;
  quasistatic::NodeConstraintArray<float, Space> constraints_;
  quasistatic::NodeScaleArray<float, Space> scales_;
  quasistatic::NodeInverseArray<float, Space> inverse_;
  Numbers numbers_;
  std::unique_ptr<Product> product_;
  typename On::Loop loop_;
  double force_length_ = 0;  ///< over free components [N]
  bool is_recorded_ = false;
  std::string note_;
};

}  // namespace physgen::bench
