// Objects on their way between host code, which works on them chunk by chunk, and an array in CUDA memory: while one
// chunk is transferred, the next one is filled, or the one before is read. Chunks lie in pinned memory that is kept for
// later transfers.
#pragma once

#include <physgen/untyped_array.h>

#include <memory>

namespace physgen {

/// To CUDA memory: `while (upload.next()) fill objects upload.begin() + i = upload.chunk()'s object i`.
class ChunkedUpload {
 public:
  /// @param to in CUDA memory; @param begin, end which of its objects
  /// @throw Error when pinned memory cannot be had, without CUDA, and while `stream` is being captured
  ChunkedUpload(const UntypedArray& to, index_t begin, index_t end, Stream stream);
  ~ChunkedUpload();
  ChunkedUpload(const ChunkedUpload&) = delete;
  ChunkedUpload& operator=(const ChunkedUpload&) = delete;

  /// Sends the chunk that has been filled, in the order of the stream, and makes room for the next one.
  /// @return false when all have been sent; the transfers may still be under way
  bool next();
  /// Pinned memory in the form of the target: its formats and layout, for the objects begin() .. begin() + size - 1.
  [[nodiscard]] const UntypedArray& chunk() const;
  [[nodiscard]] index_t begin() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// From CUDA memory: `while (download.next()) read objects`.
class ChunkedDownload {
 public:
  /// @param from in CUDA memory; @param begin, end which of its objects
  /// @throw Error when pinned memory cannot be had, without CUDA, and while `stream` is being captured
  ChunkedDownload(const UntypedArray& from, index_t begin, index_t end, Stream stream);
  ~ChunkedDownload();
  ChunkedDownload(const ChunkedDownload&) = delete;
  ChunkedDownload& operator=(const ChunkedDownload&) = delete;

  /// Waits for the next chunk; the ones after it are on their way meanwhile. @return false when there is none
  bool next();
  [[nodiscard]] const UntypedArray& chunk() const;
  [[nodiscard]] index_t begin() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace physgen
