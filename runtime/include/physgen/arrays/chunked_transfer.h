// Objects on their way between host code, which works on them chunk by chunk, and an array in CUDA memory: while one
// chunk is transferred, the next one is filled, or the one before is read. Chunks lie in pinned memory that is kept for
// later transfers.
#pragma once

#include <physgen/arrays/untyped_array.h>

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

  /// Goes on to the next chunk. On the way up this sends the chunk that has been filled, in the order of the stream,
  /// and makes room for this one; on the way down it waits for this one, while those after it are on their way.
  /// @return false behind the last chunk; transfers on the way up may then still be under way
  bool next();

 protected:
  /// @param up to CUDA memory, or else from there
  /// @param array in CUDA memory
  /// @param begin, end which of its objects
  /// @throw Error when pinned memory cannot be had, without CUDA, and while `stream` is being captured
  ChunkedTransfer(bool up, const UntypedArray& array, index_t begin, index_t end, Stream stream);
  ~ChunkedTransfer();

  struct State;
  std::unique_ptr<State> state_;
};

/// To CUDA memory: `while (upload.next()) fill objects upload.begin() + i = upload.chunk()'s object i`.
struct ChunkedUpload : ChunkedTransfer {
  /// As ChunkedTransfer.
  ChunkedUpload(const UntypedArray& to, index_t begin, index_t end, Stream stream)
      : ChunkedTransfer(true, to, begin, end, stream) {}
};

/// From CUDA memory: `while (download.next()) read objects`.
struct ChunkedDownload : ChunkedTransfer {
  /// As ChunkedTransfer.
  ChunkedDownload(const UntypedArray& from, index_t begin, index_t end, Stream stream)
      : ChunkedTransfer(false, from, begin, end, stream) {}
};

}  // namespace physgen
