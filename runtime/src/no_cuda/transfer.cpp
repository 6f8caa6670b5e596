// Transfers in chunks in a build without CUDA: there is nowhere to transfer to.
#include <physgen/chunked_transfer.h>
#include <physgen/error.h>

#include "reason.h"

namespace physgen {

struct ChunkedUpload::State {
  UntypedArray chunk;
};
ChunkedUpload::ChunkedUpload(const UntypedArray& /*to*/, index_t /*begin*/, index_t /*end*/, Stream /*stream*/) {
  throw Error(backend::reason);
}
ChunkedUpload::~ChunkedUpload() = default;
bool ChunkedUpload::next() { return false; }
const UntypedArray& ChunkedUpload::chunk() const { return state_->chunk; }
index_t ChunkedUpload::begin() const { return 0; }

struct ChunkedDownload::State {
  UntypedArray chunk;
};
ChunkedDownload::ChunkedDownload(const UntypedArray& /*from*/, index_t /*begin*/, index_t /*end*/, Stream /*stream*/) {
  throw Error(backend::reason);
}
ChunkedDownload::~ChunkedDownload() = default;
bool ChunkedDownload::next() { return false; }
const UntypedArray& ChunkedDownload::chunk() const { return state_->chunk; }
index_t ChunkedDownload::begin() const { return 0; }

}  // namespace physgen
