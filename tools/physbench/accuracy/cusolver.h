// The SVD of cuSOLVER, as a comparison: gesvdjBatched with its default tolerance and its default limit of 100 sweeps.
// The library is looked for when the program runs, so that the program starts without it.
#pragma once

#include <string>
#include <vector>

#include "input_sets.h"
#include "set_rows.h"

namespace physgen::bench {

/// What is missing for cuSOLVER; empty: it can be called.
[[nodiscard]] const std::string& cusolver_missing();

/// Rows `svd/cusolver/...`: matrices as structs, by columns. @pre there is a CUDA device, cusolver_missing() is empty
void add_cusolver_rows(std::vector<Row>& rows, InputSets& sets);

/// The SVDs of F, in our convention: cuSOLVER's rotations may have det -1, and its s3 is >= 0.
/// @pre as for add_cusolver_rows()
template <class Real>
[[nodiscard]] typename HostVariant<SvdVariant<4>, Real>::Outputs cusolver_svd(
    const typename HostVariant<SvdVariant<4>, Real>::Inputs& gradients);

}  // namespace physgen::bench
