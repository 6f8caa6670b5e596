// A build without CUDA has nowhere to transfer objects to.
#include "../backend/transfer.h"

#include <physgen/arrays/chunked_transfer.h>
#include <physgen/error.h>

#include "parts/reason.h"

namespace physgen {

index_t backend::convert(const UntypedArray& /*to*/, const UntypedArray& /*from*/, index_t /*begin*/, index_t /*end*/,
                         Stream /*stream*/) {
  throw Error(backend::reason);
}

struct ChunkedTransfer::State {
  UntypedArray chunk;
};
ChunkedTransfer::ChunkedTransfer(bool /*up*/, const UntypedArray& /*array*/, index_t /*begin*/, index_t /*end*/,
                                 Stream /*stream*/) {
  throw Error(backend::reason);
}
ChunkedTransfer::~ChunkedTransfer() = default;
const UntypedArray& ChunkedTransfer::chunk() const { return state_->chunk; }
index_t ChunkedTransfer::begin() const { return 0; }
bool ChunkedTransfer::next() { return false; }

}  // namespace physgen
