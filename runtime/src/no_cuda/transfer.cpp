// Transfers in a build without CUDA: there is nowhere to transfer to.
#include "../backend/transfer.h"

#include <physgen/chunked_transfer.h>
#include <physgen/error.h>

#include "parts/reason.h"

namespace physgen {

index_t backend::convert(const UntypedArray& /*to*/, const UntypedArray& /*from*/, index_t /*begin*/, index_t /*end*/,
                         Stream /*stream*/) {
  throw Error(backend::reason);
}

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
