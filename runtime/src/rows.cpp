// Rows without the types of their arrays: what they must obey, and what is said where they do not.
#include <physgen/error.h>
#include <physgen/rows.h>

#include <string>

namespace physgen::detail {

void require_rows(const char* of, index_t rows, index_t row_targets, index_t size, index_t targets) {
  if (rows == size && row_targets == targets) return;
  const auto text = [](index_t count) { return std::to_string(count); };
  throw Error(std::string(of) + ": these are " + text(rows) + " rows of entries that name " + text(row_targets) +
              " objects, and the kernel runs over " + text(size) + " objects with entries that name " + text(targets) +
              "; give it the rows of this set");
}

}  // namespace physgen::detail
