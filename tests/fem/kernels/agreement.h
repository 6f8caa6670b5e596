// One set of inputs through SVD, stress, stress derivatives and dP, in any space: the results as numbers, as a file,
// and compared. So a CUDA run can be held against the file that a CPU run wrote. Each kernel gets the file's inputs,
// not its own predecessor's output, so that differences are of one kernel each.
#pragma once

#include <elasticity.physgen.h>
#include <fem/kernels/compute_svd.h>
#include <fem/kernels/stress.h>
#include <fem/kernels/stress_derivative.h>
#include <fem/kernels/stress_differential.h>
#include <fem/materials/materials.h>
#include <physgen/launch/in_lanes.h>
#ifdef __CUDACC__
#include <physgen/cuda/parallel_for.h>
#else
#include <physgen/parallel_for.h>
#endif

#include <map>
#include <string>
#include <vector>

namespace physgen::fem::agreement {

/// Numbers of all objects, object after object, by the name of what they are.
template <class Real>
using Results = std::map<std::string, std::vector<Real>>;

/// "F" and "dF": deformation gradients from I + 0.3 N(0,1), near rest, and hard but of ordinary size; with their
/// differentials. From the test's seed.
template <class Real>
[[nodiscard]] Results<Real> make_inputs();

/// @throw std::runtime_error when the file cannot be written, or read, or is none of these
template <class Real>
void write(const std::string& path, const Results<Real>& results);
template <class Real>
[[nodiscard]] Results<Real> read(const std::string& path);

/// How far two runs are apart, for one name.
struct Difference {
  std::size_t objects = 0, differing = 0;  ///< differing: not bit for bit the same
  double worst = 0;                        ///< largest difference over the object's largest number [eps]
};
/// For "svd" s, relative to s1, and U diag(s) V^T, relative to |F|, are compared: U and V are not unique.
/// NaN agrees with NaN.
template <class Real>
[[nodiscard]] std::map<std::string, Difference> compare(const Results<Real>& expected, const Results<Real>& got);
/// Prints them, one line each.
void print(const std::string& title, const std::map<std::string, Difference>& differences);

/// Results of a CPU run in packs, read from the file that it wrote: from the folder $PHYSGEN_CPU_RESULTS, where the run
/// of another CPU may have left it and where it stays; else from one that is written now, and removed.
template <class Real>
[[nodiscard]] Results<Real> results_of_a_cpu_run();

namespace detail {

template <class Case>
class Run {
  using Real = typename Case::Real;
  using Space = typename Case::Space;
  template <class Object, class Where = Space>
  using Array = physgen::Array<Object, Real, Where, typename Case::Layout>;

 public:
  explicit Run(const Results<Real>& given) : results_(given), given_(given) {}

  Results<Real> all() {
    const auto gradients = filled<elasticity::DeformationGradientObject>("F");
    Array<elasticity::DeformationSvdObject> svds(gradients.size());
    run(ComputeSvd{gradients.const_view(), svds.view()}, svds, "svd");
    materials(AllMaterials<Real>{});
    const auto stiff = NeoHookean<Real>::from(1, 0.45);
    derivative(stiff, ClampEigenvalues{}, "x clamped");
    derivative(stiff, AbsoluteEigenvalues{}, "x absolute");
    const auto decomposition = filled<elasticity::DeformationSvdObject>("svd");
    const auto x = filled<elasticity::StressDerivativeObject>("x Neo-Hookean");
    const auto differentials = filled<elasticity::DeformationGradientDifferentialObject>("dF");
    Array<elasticity::StressDifferentialObject> dP(x.size());
    run(ComputeStressDifferential{decomposition.const_view(), x.const_view(), differentials.const_view(), dP.view()},
        dP, "dP");
    return results_;
  }

 private:
  template <class... Model>
  void materials(MaterialList<Model...> /*list*/) {
    (material(Model::from(1, 0.45)), ...);
  }
  template <class Model>
  void material(const Model& model) {
    const auto decomposition = filled<elasticity::DeformationSvdObject>("svd");
    Array<elasticity::StressObject> stress(decomposition.size());
    run(ComputeStress{model, decomposition.const_view(), stress.view()}, stress, std::string("P ") + Model::name);
    derivative(model, Unfiltered{}, std::string("x ") + Model::name);
  }
  template <class Model, class Filter>
  void derivative(const Model& model, const Filter& filter, const std::string& name) {
    const auto decomposition = filled<elasticity::DeformationSvdObject>("svd");
    Array<elasticity::StressDerivativeObject> x(decomposition.size());
    run(ComputeStressDerivative{model, decomposition.const_view(), x.view(), filter}, x, name);
  }

  template <class Kernel, class Output>
  void run(const Kernel& kernel, Output& output, const std::string& name) {
    if constexpr (Space::kind == SpaceKind::cuda) {
      parallel_for(Space{}, output.size(), kernel);
    } else {
      parallel_for(Space{}, output.size(), lanes<Case::lanes>(kernel));
    }
    std::vector<Real>& numbers = results_[name];
    numbers = flattened(output);
  }
  template <class Object>
  Array<Object> filled(const std::string& name) {
    // Given results come first, also where this run has made its own since.
    const auto at = given_.find(name);
    const std::vector<Real>& numbers = at != given_.end() ? at->second : results_.at(name);
    constexpr int elements = Array<Object>::elements;
    Array<Object, Host> host(static_cast<index_t>(numbers.size()) / elements);
    for (index_t i = 0; i < host.size(); ++i) {
      for (int k = 0; k < elements; ++k) {
        host.putdata(i, k, static_cast<double>(numbers[static_cast<std::size_t>(i * elements + k)]));
      }
    }
    Array<Object> array(host.size());
    copy(array, host);
    synchronize();
    return array;
  }
  template <class Object>
  static std::vector<Real> flattened(const Array<Object>& array) {
    Array<Object, Host> host(array.size());
    copy(host, array);
    synchronize();
    std::vector<Real> numbers;
    for (index_t i = 0; i < host.size(); ++i) {
      for (int k = 0; k < Array<Object>::elements; ++k) numbers.push_back(static_cast<Real>(host.getdata(i, k)));
    }
    return numbers;
  }

  Results<Real> results_;
  const Results<Real>& given_;
};

}  // namespace detail

/// Runs all kernels. @param given "F" and "dF"; results of another run among them are inputs of what follows.
/// @tparam Case as RunCase: Real, Space, Layout, lanes
template <class Case>
Results<typename Case::Real> run(const Results<typename Case::Real>& given) {
  return detail::Run<Case>(given).all();
}

}  // namespace physgen::fem::agreement
