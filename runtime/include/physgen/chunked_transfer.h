// Objects on their way between host code, which works on them chunk by chunk, and an array in CUDA memory: while one
// chunk is transferred, the next one is filled, or the one before is read. Chunks lie in pinned memory that is kept for
// later transfers.
#pragma once

#include <physgen/untyped_array.h>

#include <memory>

namespace physgen {

/// A transfer in either direction.
class ChunkedTransfer {
 public:
  ChunkedTransfer(const ChunkedTransfer&) = delete;
  ChunkedTransfer& operator=(const ChunkedTransfer&) = delete;

  /// The chunk that next() has reached, in pinned memory, in the form of the array: its formats and layout. Object i of
  /// it is object begin() + i of the array.
  [[nodiscard]] const UntypedArray& chunk() const;
  [[nodiscard]] index_t begin() const;

 protected:
  /// @param array in CUDA memory; @param begin, end which of its objects
  /// @throw Error when pinned memory cannot be had, without CUDA, and while `stream` is being captured
  ChunkedTransfer(const UntypedArray& array, index_t begin, index_t end, Stream stream);
  ~ChunkedTransfer();

  struct State;
  std::unique_ptr<State> state_;
};

/// To CUDA memory: `while (upload.next()) fill objects upload.begin() + i = upload.chunk()'s object i`.
class ChunkedUpload : public ChunkedTransfer {
 public:
  /// As ChunkedTransfer.
  ChunkedUpload(const UntypedArray& to, index_t begin, index_t end, Stream stream)
      : ChunkedTransfer(to, begin, end, stream) {}
  /// Sends the chunk that has been filled, in the order of the stream, and makes room for the next one.
  /// @return false when all have been sent; the transfers may still be under way
  bool next();
};

/// From CUDA memory: `while (download.next()) read objects`.
class ChunkedDownload : public ChunkedTransfer {
 public:
  /// As ChunkedTransfer.
  ChunkedDownload(const UntypedArray& from, index_t begin, index_t end, Stream stream)
      : ChunkedTransfer(from, begin, end, stream) {}
  /// Waits for the next chunk; the ones after it are on their way meanwhile. @return false when there is none
  bool next();
};

}  // namespace physgen
