// Groups of rows beside those of the kernels, each a subcommand of its own.
#pragma once

#include <vector>

#include "row.h"

namespace physgen::bench {

class Dataset;

/// dP from dF in every storage scheme: speed against error.
void add_host_storage_rows(std::vector<Row>& rows, Dataset& data);
void add_cuda_storage_rows(std::vector<Row>& rows, Dataset& data);

/// Copies between layouts, and between host and device.
void add_host_conversion_rows(std::vector<Row>& rows, index_t objects);
void add_cuda_conversion_rows(std::vector<Row>& rows, index_t objects);

/// Nodes gathered by the tets of an ordered, a randomly numbered and a renumbered mesh, in every layout of the nodes.
void add_host_gather_rows(std::vector<Row>& rows, Dataset& data);
void add_cuda_gather_rows(std::vector<Row>& rows, Dataset& data);

/// The product with the assembled stiffness: its symmetric half, and cuSPARSE's full blocks.
void add_host_force_rows(std::vector<Row>& rows, Dataset& data);
void add_cuda_force_rows(std::vector<Row>& rows, Dataset& data);

/// Dot products, beside a pass that only reads as many bytes.
void add_host_dot_rows(std::vector<Row>& rows);
void add_cuda_dot_rows(std::vector<Row>& rows);

}  // namespace physgen::bench
