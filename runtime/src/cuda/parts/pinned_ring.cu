// See pinned_ring.h.
#include <physgen/cuda/check.h>

#include <algorithm>
#include <exception>
#include <memory>
#include <mutex>
#include <vector>

#include "pinned_ring.h"

namespace physgen::cuda {

struct PinnedRing::Pieces {
  index_t bytes = 0;
  int device = 0;  // its events belong to one
  std::byte* memory[pieces] = {};
  cudaEvent_t done[pieces] = {};

  ~Pieces() {
    for (int k = 0; k < pieces; ++k) {
      if (memory[k] != nullptr) cudaFreeHost(memory[k]);
      if (done[k] != nullptr) cudaEventDestroy(done[k]);
    }
  }
};

namespace {

std::mutex mutex;
int rings_made = 0;

// Rings that no transfer uses at present. Never destroyed: CUDA may be gone before static objects are.
template <class T>
std::vector<std::unique_ptr<T>>& idle() {
  static auto* const rings = new std::vector<std::unique_ptr<T>>();
  return *rings;
}

}  // namespace

PinnedRing::PinnedRing(index_t bytes) : exceptions_(std::uncaught_exceptions()) {
  constexpr index_t step = index_t{16} << 20;  // so that few sizes occur
  bytes = std::max(align_up(bytes, step), step);
  int device = 0;
  check(cudaGetDevice(&device), "asking for the current device");
  {
    const std::lock_guard lock(mutex);
    auto& rings = idle<Pieces>();
    for (auto& ring : rings) {
      if (ring->bytes < bytes || ring->device != device) continue;
      pieces_ = ring.release();
      std::swap(ring, rings.back());
      rings.pop_back();
      return;
    }
  }
  auto made = std::make_unique<Pieces>();
  made->bytes = bytes;
  made->device = device;
  for (int k = 0; k < pieces; ++k) {
    void* memory = nullptr;
    check(cudaMallocHost(&memory, static_cast<std::size_t>(bytes)), "allocating pinned memory for a transfer");
    made->memory[k] = static_cast<std::byte*>(memory);
    check(cudaEventCreateWithFlags(&made->done[k], cudaEventDisableTiming), "preparing a transfer");
  }
  {
    const std::lock_guard lock(mutex);
    idle<Pieces>().reserve(static_cast<std::size_t>(++rings_made));
  }
  pieces_ = made.release();
}

PinnedRing::~PinnedRing() {
  constexpr index_t longest_kept = index_t{64} << 20;  // those of huge records would be kept for few
  for (int k = 0; k < pieces; ++k) cudaEventSynchronize(pieces_->done[k]);
  if (std::uncaught_exceptions() > exceptions_) cudaDeviceSynchronize();  // a transfer may not have been noted
  if (pieces_->bytes > longest_kept) {
    delete pieces_;
    return;
  }
  const std::lock_guard lock(mutex);
  idle<Pieces>().emplace_back(pieces_);  // which has room
}

std::byte* PinnedRing::piece(index_t k) const { return pieces_->memory[k % pieces]; }

void PinnedRing::used(index_t k, Stream stream) {
  check(cudaEventRecord(pieces_->done[k % pieces], stream), "noting a transfer");
}

void PinnedRing::wait(index_t k) { check(cudaEventSynchronize(pieces_->done[k % pieces]), "waiting for a transfer"); }

}  // namespace physgen::cuda
