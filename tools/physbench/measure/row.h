// The things that the program measures: a row is one kernel in one layout, storage and space; a case is a row with its
// data in place.
#pragma once

#include <fem/reference/distribution.h>
#include <physgen/config.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace physgen::bench {

/// The errors of a row's results against the reference. Rows of the Truth Cube give relative errors, |x - ref| /
/// max(|ref|, 1e-3 rms |ref|), and nothing else; rows of a set of inputs give errors in eps of their storage.
struct Accuracy {
  fem::reference::ErrorSummary errors;
  std::optional<fem::reference::ErrorSummary> orthogonality;  ///< of the rotations, where there are any [eps]
  std::int64_t failures = 0;                                  ///< results that are not finite, or off by a percent
  std::string worst;                                          ///< the command that runs the worst input again
  std::vector<std::pair<std::string, double>> more;  ///< numbers of this row alone, by their names in the results
  std::string note;                                  ///< of this row alone, for readers
};

/// A kernel with its inputs and output in place, ready to run again and again; the functions own what they need.
struct Case {
  double bytes = 0;              ///< that the kernel must read and write, whatever the layout
  std::function<double()> run;   ///< runs the kernel over all objects. @return its time [s]
  std::size_t fewest = 5;        ///< runs of which a median is taken
  std::function<double()> copy;  ///< copies as many bytes, half read, half written. @return its time [s]
  /// Runs the kernel on a poisoned output and compares all of it with the reference.
  /// @throws Error when an element was not written
  std::function<Accuracy()> check = [] { return Accuracy(); };
};

/// Numbers of a row that are computed, not measured, by their names in the results.
using Counters = std::vector<std::pair<std::string, double>>;

struct Row {
  std::string kernel;   ///< "dp_from_df"
  std::string layout;   ///< "aosoa32"; also "copy" and "eigen"
  std::string storage;  ///< "float" or "double"
  std::string space;    ///< "host" or "cuda"
  std::string set;      ///< "random", "near_rest", "hard"; or a numbering of nodes; empty: the Truth Cube as it is
  bool errors_in_eps = false;  ///< and more of Accuracy: rows of the sets of inputs
  index_t objects = 0;
  double host_bytes = 0, device_bytes = 0;  ///< memory that it takes, about
  std::function<Case()> make;
  std::function<Counters()> model = [] { return Counters(); };

  /// kernel/layout/storage/space/objects, and /set where there is one
  [[nodiscard]] std::string name() const {
    const std::string name = kernel + "/" + layout + "/" + storage + "/" + space + "/" + std::to_string(objects);
    return set.empty() ? name : name + "/" + set;
  }
};

template <class Real>
const char* storage_name() {
  return sizeof(Real) == sizeof(float) ? "float" : "double";
}

}  // namespace physgen::bench
