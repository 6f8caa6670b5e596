#include "row.h"

#include <truthcube/output/disk.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

namespace physgen::truthcube {

namespace {

using Json = nlohmann::ordered_json;

template <class... Arguments>
std::string formatted(const char* format, const Arguments&... arguments) {
  std::array<char, 256> text{};
  const int length = std::snprintf(text.data(), text.size(), format, arguments...);
  return {text.data(), static_cast<std::size_t>(length)};
}

/// In milliseconds, or a dash.
std::string milliseconds(double seconds) {
  return std::isfinite(seconds) ? formatted("%11.4f", seconds * 1e3) : formatted("%11s", "-");
}

/// How fast a device moves bytes beside its copy of as many.
std::string share_of_copy(double copy, double seconds) {
  const double share = copy / seconds;
  return std::isfinite(share) ? formatted("%9.2f", share) : formatted("%9s", "-");
}

}  // namespace

std::string status_of(const LinearRow& row) {
  switch (row.measured.result.status) {
    case fem::LinearStatus::converged:
      return "converged";
    case fem::LinearStatus::running:
      return "iterations used up";
    case fem::LinearStatus::negative_curvature:
      return "negative curvature";
    case fem::LinearStatus::not_finite:
      break;
  }
  return "not finite";
}

std::string table_head(bool copies) {
  std::string text =
      formatted("%5s %7s %-8s %-13s %-6s %-14s %11s %11s %11s %6s %11s %9s", "cells", "nu", "volume", "method", "in",
                "norm", "assembly", "set-up", "solve [ms]", "PCG", "iteration", "residual");
  if (copies) text += formatted(" %11s %9s %9s", "product", "of copy", "iteration");
  return text;
}

std::string table_line(const LinearRow& row, bool copies) {
  const fem::LinearMeasurement& m = row.measured;
  std::string text =
      formatted("%5d %7g %-8s %-13s %-6s %-14s", row.cells, row.poissons_ratio, name_of(row.volume).c_str(),
                name_of(row.method).c_str(), name_of(row.precision).c_str(), name_of(row.norm).c_str());
  for (const double seconds : {m.assembly_seconds, m.preconditioner_seconds, m.solve_seconds}) {
    text += " " + milliseconds(seconds);
  }
  text += formatted(" %6d ", m.result.iterations) + milliseconds(row.seconds_per_iteration());
  text += formatted(" %9.2e", row.residual);
  if (copies) {
    text += " " + milliseconds(m.product_seconds) + " " + share_of_copy(row.product_copy_seconds, m.product_seconds) +
            " " + share_of_copy(row.iteration_copy_seconds, row.seconds_per_iteration());
  }
  if (m.result.status != fem::LinearStatus::converged) text += "  " + status_of(row);
  return text;
}

void write_rows(const std::filesystem::path& file, const std::vector<LinearRow>& rows) {
  Json json;
  json["rows"] = Json::array();
  for (const LinearRow& row : rows) {
    const fem::LinearMeasurement& m = row.measured;
    Json entry;
    entry["cells"] = row.cells;
    entry["nodes"] = row.nodes;
    entry["tets"] = row.tets;
    entry["poisson"] = row.poissons_ratio;
    entry["volume"] = name_of(row.volume);
    entry["compression"] = row.compression;
    entry["method"] = name_of(row.method);
    entry["precision"] = name_of(row.precision);
    entry["norm"] = name_of(row.norm);
    entry["tolerance"] = row.tolerance;
    entry["status"] = status_of(row);
    entry["iterations"] = m.result.iterations;
    entry["residual"] = row.residual;
    entry["assembly_seconds"] = m.assembly_seconds;
    entry["setup_seconds"] = m.preconditioner_seconds;
    entry["solve_seconds"] = m.solve_seconds;
    entry["seconds_per_iteration"] = row.seconds_per_iteration();
    entry["product_seconds"] = m.product_seconds;
    entry["product_bytes"] = m.product_bytes;
    entry["product_copy_seconds"] = row.product_copy_seconds;
    entry["iteration_bytes"] = m.iteration_bytes;
    entry["iteration_copy_seconds"] = row.iteration_copy_seconds;
    if (row.method == Method::vendor) {
      entry["vendor_product"] = row.vendor_product;
      entry["note"] = row.note;
    }
    entry["device"] = row.device;
    entry["command"] = row.command;
    json["rows"].push_back(entry);
  }
  write_text(file, json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n");
}

}  // namespace physgen::truthcube
