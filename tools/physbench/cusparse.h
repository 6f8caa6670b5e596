// cuSPARSE's product of a block sparse matrix, for comparison. The library is loaded when it is first used.
#pragma once

#include <physgen/config.h>

#include <memory>
#include <string>
#include <vector>

namespace physgen::bench {

/// Why there is no cuSPARSE; empty if there is.
[[nodiscard]] std::string cusparse_missing();

/// How the entries of a block follow each other.
enum class BlockOrder { rows, columns };

/// 3x3 blocks by rows: row r has the blocks begin[r] .. begin[r + 1] - 1 with ascending columns.
struct BlockMatrix {
  BlockOrder order = BlockOrder::columns;
  std::vector<int> begin;
  std::vector<int> column;
  std::vector<float> blocks;
};

/// y = A x in device memory, through cusparseSpMV over BSR.
class BlockProduct {
 public:
  /// @throw Error when cuSPARSE or memory cannot be had
  BlockProduct(const BlockMatrix& matrix, const std::vector<float>& x);
  ~BlockProduct();
  BlockProduct(const BlockProduct&) = delete;
  BlockProduct& operator=(const BlockProduct&) = delete;

  /// Orders a product in the default stream.
  void run();
  /// Fills y with NaN.
  void poison();
  [[nodiscard]] std::vector<float> result() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace physgen::bench
