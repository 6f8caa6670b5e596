// What the program measures: a row is one kernel in one layout, storage and space; a case is a row with its data in
// place.
#pragma once

#include <fem/reference/distribution.h>
#include <physgen/config.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace physgen::bench {

class Dataset;

/// How far the results of a row are from the reference. Rows of the Truth Cube give relative errors, |x - ref| /
/// max(|ref|, 1e-3 rms |ref|), and nothing else; rows of a set of inputs give errors in eps of their storage.
struct Accuracy {
  fem::reference::ErrorSummary errors;
  std::optional<fem::reference::ErrorSummary> orthogonality;  ///< of the rotations, where there are any [eps]
  std::int64_t failures = 0;                                  ///< results that are not finite, or off by a percent
  std::string worst;                                          ///< the command that runs the worst input again
};

/// A kernel with its inputs and output in one layout, storage and space, ready to run again and again.
class Case {
 public:
  Case() = default;
  Case(const Case&) = delete;
  Case& operator=(const Case&) = delete;
  virtual ~Case() = default;

  /// Runs the kernel over all objects. @return its time [s]
  virtual double run() = 0;
  /// Copies as many bytes as the kernel must move (half read, half written). @return its time [s]
  virtual double copy() = 0;
  /// Runs the kernel on a poisoned output and compares all of it with the reference.
  /// @throws Error when an element was not written
  virtual Accuracy check() = 0;
};

struct Row {
  std::string kernel;   ///< "dp_from_df"
  std::string layout;   ///< "aosoa32"; also "copy" and "eigen"
  std::string storage;  ///< "float" or "double"
  std::string space;    ///< "host" or "cuda"
  std::string set;      ///< "random", "near_rest", "hard"; or a numbering of nodes; empty: the Truth Cube as it is
  bool errors_in_eps = false;  ///< and more of Accuracy: rows of the sets of inputs
  index_t objects = 0;
  double bytes_per_object = 0;  ///< what the kernel must read and write, whatever the layout
  std::function<std::unique_ptr<Case>()> make;

  /// kernel/layout/storage/space/objects, and /set where there is one
  [[nodiscard]] std::string name() const {
    const std::string name = kernel + "/" + layout + "/" + storage + "/" + space + "/" + std::to_string(objects);
    return set.empty() ? name : name + "/" + set;
  }
};

}  // namespace physgen::bench
