// A row of linear_solves: one method on one cube.
#pragma once

#include <fem/solver/linear_measurement.h>

#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "options.h"

namespace physgen::truthcube {

struct LinearRow {
  static constexpr double none = std::numeric_limits<double>::quiet_NaN();
  int cells = 0;
  index_t nodes = 0, tets = 0;
  double poissons_ratio = 0;
  VolumeTreatment volume = VolumeTreatment::patches;
  double compression = 0;
  Method method = Method::multigrid;
  fem::TangentPrecision precision = fem::TangentPrecision::half;
  fem::LinearNorm norm = fem::LinearNorm::euclidean;
  double tolerance = 0;
  fem::LinearMeasurement measured;
  double residual = 0;  ///< |f + K dx| / |f| of free components, in double from the step and the blocks of K
  /// Times of the device's own copies that read and write product_bytes and iteration_bytes together; none: not
  /// measured.
  double product_copy_seconds = none, iteration_copy_seconds = none;
  std::string vendor_product, note;  ///< of Method::vendor
  std::string device, command;

  [[nodiscard]] double seconds_per_iteration() const {
    return measured.result.iterations > 0 ? measured.solve_seconds / measured.result.iterations : none;
  }
};

/// "converged", "iterations used up", "negative curvature" or "not finite".
[[nodiscard]] std::string status_of(const LinearRow& row);

/// The table's head, and a row of it. @param copies whether there are columns for copies
[[nodiscard]] std::string table_head(bool copies);
[[nodiscard]] std::string table_line(const LinearRow& row, bool copies);

/// {"rows": [...]}; what was not measured is null. @throw Error when the file cannot be written
void write_rows(const std::filesystem::path& file, const std::vector<LinearRow>& rows);

}  // namespace physgen::truthcube
