// What the program measures: a row is one kernel in one layout, storage and space; a case is a row with its data in
// place.
#pragma once

#include <physgen/config.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace physgen::bench {

class Dataset;

/// Relative errors of all objects of a result against the reference, |x - ref| / max(|ref|, 1e-3 rms |ref|).
struct ErrorStats {
  double p50 = 0, p99 = 0, max = 0;
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
  virtual ErrorStats check() = 0;
};

struct Row {
  std::string kernel;   ///< "dp_from_df"
  std::string layout;   ///< "aosoa32"; also "copy" and "eigen"
  std::string storage;  ///< "float" or "double"
  std::string space;    ///< "host" or "cuda"
  index_t objects = 0;
  double bytes_per_object = 0;  ///< what the kernel must read and write, whatever the layout
  std::function<std::unique_ptr<Case>()> make;

  /// kernel/layout/storage/space/objects
  [[nodiscard]] std::string name() const {
    return kernel + "/" + layout + "/" + storage + "/" + space + "/" + std::to_string(objects);
  }
};

}  // namespace physgen::bench
