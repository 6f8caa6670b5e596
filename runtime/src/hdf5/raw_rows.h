// Rows of datasets in one piece, moved as they are stored, whatever their type, by any number of threads at once:
// HDF5's library says where in the file they lie, and the system moves them, since that library is for one thread at a
// time.
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <string>
#include <vector>

#include "h5.h"

namespace physgen::h5 {

/// The rows of one dataset of an open file, which must live longer. All members throw Error.
class RawRows {
 public:
  /// @param type of an element in memory, the same as in the file
  RawRows(const File& file, const std::string& dataset, hid_t type);

  /// Rows from and to memory, side by side.
  void read(hsize_t first_row, hsize_t rows, void* values) const;
  /// @pre make_fixed() made the dataset
  void write(hsize_t first_row, hsize_t rows, const void* values) const;
  /// Tells the system that these rows, or those of them that there are, are read soon, so that the disk is at work
  /// while the program is.
  void read_ahead(hsize_t first_row, hsize_t rows) const;
  [[nodiscard]] std::size_t bytes_of_row() const { return bytes_of_row_; }

 private:
  // Of a dataset that another program has stored in pieces: by HDF5's library, one thread after the other.
  void read_pieces(hsize_t first_row, hsize_t rows, void* values) const;
  [[noreturn]] void fail(const char* asked, const std::string& why) const;
  [[nodiscard]] int descriptor() const;
  [[nodiscard]] off_t place_of(hsize_t row) const { return static_cast<off_t>(begin_ + row * bytes_of_row_); }

  std::string file_, name_;  // for messages
  Handle dataset_, type_;
  std::vector<hsize_t> shape_;
  std::size_t bytes_of_row_;
  int descriptor_;  // of the file that the dataset lies in, which is another one behind an external link
  haddr_t begin_;   // of the rows in the file; HADDR_UNDEF where they are not in one piece, or not there yet
};

}  // namespace physgen::h5
