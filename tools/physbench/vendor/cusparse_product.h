// cuSPARSE's product of a block sparse matrix, in the fastest of the ways in which it has one.
#pragma once

#include <cuda_runtime_api.h>
#include <physgen/memory/buffer.h>

#include <memory>
#include <string>

#include "vendor/block_matrix.h"

namespace physgen::bench {

/// Why cuSPARSE cannot be used here; empty where it can. It is looked for when the program runs, so that the program
/// starts without it.
[[nodiscard]] std::string missing_cusparse();

/// y = A x of float vectors in device memory, three scalars a node without gaps.
class CusparseProduct {
 public:
  /// Measures cusparseSpMV() over block sparse rows and cusparseSbsrmv(), each with blocks by columns and by rows, and
  /// keeps the fastest that the library has.
  /// @param stream in which products are ordered
  /// @pre missing_cusparse() is empty; x and y live as long as this
  /// @throw Error when none of them works
  [[nodiscard]] static std::unique_ptr<CusparseProduct> fastest(const fem::AssembledStiffness& stiffness,
                                                                std::span<const std::uint8_t> fixed, float* x, float* y,
                                                                cudaStream_t stream);

  /// cusparseSpMV() over block sparse rows. @pre and @throw as for fastest()
  /// @param order the one that the matrix was made in
  [[nodiscard]] static std::unique_ptr<CusparseProduct> make(const BlockMatrix& matrix, BlockOrder order, float* x,
                                                             float* y, cudaStream_t stream);

  virtual ~CusparseProduct() = default;
  /// Orders a product; does not wait, and may be recorded in a graph. @throw Error when cuSPARSE refuses
  virtual void run() = 0;
  /// Where a product could not be recorded: so that nobody sees CUDA's error again.
  void forget_error();
  /// Such as "cusparseSpMV, blocks by columns".
  [[nodiscard]] virtual std::string name() const = 0;
  /// Bytes of the matrix and of both vectors.
  [[nodiscard]] virtual index_t bytes() const = 0;
  /// The measured time of one product [s].
  double seconds = 0;
};

}  // namespace physgen::bench
