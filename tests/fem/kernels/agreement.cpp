// Inputs, files and comparison of results; and the CPU's run, in packs.
#include "agreement.h"

#include <fem/reference/matrix_families.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "reference.h"
#include "run_case.h"

namespace physgen::fem::agreement {

namespace {

template <class Real>
using Packs = RunCase<Real, Host, Aosoa<16>>;

template <class Real>
constexpr const char* magic() {
  return sizeof(Real) == 4 ? "physgen results of float\n" : "physgen results of double\n";
}

[[noreturn]] void fail(const std::string& path, const std::string& what) {
  throw std::runtime_error(path + ": " + what);
}

// s and U diag(s) V^T of object i, from the 21 numbers in the order of elasticity::DeformationSvd.
template <class Real>
std::pair<Eigen::Vector3d, Eigen::Matrix3d> observed(const std::vector<Real>& svd, std::size_t i) {
  using Map = Eigen::Map<const Matrix3<Real>>;
  const Real* at = svd.data() + 21 * i;
  const Eigen::Matrix3d U = Map(at).template cast<double>(), V = Map(at + 9).template cast<double>();
  const Eigen::Vector3d s = Eigen::Map<const Vector3<Real>>(at + 18).template cast<double>();
  return {s, U * s.asDiagonal() * V.transpose()};
}

std::size_t elements_of(const std::string& name) {
  if (name == "svd") return 21;
  return name[0] == 'x' ? 12 : 9;
}

}  // namespace

template <class Real>
Results<Real> make_inputs() {
  reference::Random random(400 + sizeof(Real));
  std::vector<Eigen::Matrix3d> matrices;
  for (int k = 0; k < 1000; ++k) matrices.push_back(reference::random_deformation(random));
  for (int k = 0; k < 300; ++k) matrices.push_back(reference::deformation_near_rest(random, 1e-4));
  for (const auto& family : reference::hard_matrices(reference::Precision::of<Real>())) {
    for (int k = 0; k < 8; ++k) {
      const Eigen::Matrix3d m = family.make(random);
      if (m.norm() > 1e-2 && m.norm() < 1e2) matrices.push_back(m);
    }
  }
  Results<Real> inputs;
  const auto append = [](std::vector<Real>& to, const Eigen::Matrix3d& m) {
    for (int k = 0; k < 9; ++k) to.push_back(static_cast<Real>(m.data()[k]));
  };
  for (const Eigen::Matrix3d& m : matrices) append(inputs["F"], m), append(inputs["dF"], random.gaussian());
  return inputs;
}

template <class Real>
void write(const std::string& path, const Results<Real>& results) {
  // Under another name first: a reader never sees half a file.
  const std::string unfinished = path + "." + std::to_string(::getpid());
  std::ofstream file(unfinished, std::ios::binary);
  file << magic<Real>();
  for (const auto& [name, numbers] : results) {
    file << name << "\n" << numbers.size() << "\n";
    file.write(reinterpret_cast<const char*>(numbers.data()),
               static_cast<std::streamsize>(numbers.size() * sizeof(Real)));
  }
  file.close();
  if (!file) fail(unfinished, "cannot be written");
  std::filesystem::rename(unfinished, path);
}

template <class Real>
Results<Real> read(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) fail(path, "cannot be opened");
  std::string line;
  if (!std::getline(file, line) || line + "\n" != magic<Real>())
    fail(path, "does not begin with: " + std::string(magic<Real>()));
  const std::uintmax_t size = std::filesystem::file_size(path);
  Results<Real> results;
  for (std::string name; std::getline(file, name);) {
    std::size_t count = 0;
    std::getline(file, line);
    const auto [end, status] = std::from_chars(line.data(), line.data() + line.size(), count);
    if (!file || status != std::errc() || end != line.data() + line.size() || count > size) {
      fail(path, "has no count of '" + name + "'");
    }
    std::vector<Real>& numbers = results[name];
    numbers.resize(count);
    file.read(reinterpret_cast<char*>(numbers.data()), static_cast<std::streamsize>(numbers.size() * sizeof(Real)));
    if (!file) fail(path, "ends within '" + name + "'");
  }
  return results;
}

template <class Real>
std::map<std::string, Difference> compare(const Results<Real>& expected, const Results<Real>& got) {
  const double eps = std::numeric_limits<Real>::epsilon();
  std::map<std::string, Difference> differences;
  for (const auto& [name, numbers] : expected) {
    const std::vector<Real>& others = got.at(name);
    if (others.size() != numbers.size() || numbers.size() % elements_of(name) != 0)
      throw std::runtime_error("the runs have different sizes: " + name);
    Difference& d = differences[name];
    const std::size_t elements = elements_of(name);
    d.objects = numbers.size() / elements;
    for (std::size_t i = 0; i < d.objects; ++i) {
      const Real *a = numbers.data() + i * elements, *b = others.data() + i * elements;
      if (std::memcmp(a, b, elements * sizeof(Real)) == 0) continue;
      ++d.differing;
      double largest = 0, difference = 0;
      const auto add = [&](double x, double y) {
        if (std::isnan(x) && std::isnan(y)) return;
        largest = std::max(largest, std::abs(x));
        const double gap = std::abs(x - y);
        if (!std::isnan(difference) && !(gap <= difference)) difference = gap;  // NaN on one side only is kept
      };
      if (name == "svd") {
        const auto [s, F] = observed(numbers, i);
        const auto [t, G] = observed(others, i);
        for (int k = 0; k < 3; ++k) add(s[k], t[k]);
        for (int k = 0; k < 9; ++k) add(F.data()[k], G.data()[k]);
      } else {
        for (std::size_t k = 0; k < elements; ++k) add(static_cast<double>(a[k]), static_cast<double>(b[k]));
      }
      const double error = difference / (largest > 0 ? largest : 1) / eps;
      if (!std::isnan(d.worst) && !(error <= d.worst)) d.worst = error;
    }
  }
  return differences;
}

void print(const std::string& title, const std::map<std::string, Difference>& differences) {
  std::printf("%s\n", title.c_str());
  for (const auto& [name, d] : differences) {
    std::printf("  %-28s %6zu of %zu objects differ, by at most %.3g eps\n", name.c_str(), d.differing, d.objects,
                d.worst);
  }
}

template <class Real>
Results<Real> results_of_a_cpu_run() {
  const std::string name = sizeof(Real) == 4 ? "float.results" : "double.results";
  const char* const kept = std::getenv("PHYSGEN_CPU_RESULTS");
  const std::filesystem::path folder =
      kept != nullptr ? std::filesystem::path(kept)
                      : std::filesystem::temp_directory_path() / ("physgen_" + std::to_string(::getpid()));
  std::filesystem::create_directories(folder);
  const std::string path = (folder / name).string();
  if (kept == nullptr || !std::filesystem::exists(path)) write<Real>(path, run<Packs<Real>>(make_inputs<Real>()));
  Results<Real> results = read<Real>(path);
  if (kept == nullptr) std::filesystem::remove_all(folder);
  return results;
}

template Results<float> make_inputs<float>();
template Results<double> make_inputs<double>();
template void write<float>(const std::string&, const Results<float>&);
template void write<double>(const std::string&, const Results<double>&);
template Results<float> read<float>(const std::string&);
template Results<double> read<double>(const std::string&);
template std::map<std::string, Difference> compare<float>(const Results<float>&, const Results<float>&);
template std::map<std::string, Difference> compare<double>(const Results<double>&, const Results<double>&);
template Results<float> results_of_a_cpu_run<float>();
template Results<double> results_of_a_cpu_run<double>();

}  // namespace physgen::fem::agreement
