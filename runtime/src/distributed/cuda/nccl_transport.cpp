// Messages between devices by NCCL.
#include <physgen/cuda/check.h>
#include <physgen/distributed/cuda/transports.h>
#include <physgen/memory/buffer.h>

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <utility>
#include <vector>

#include "nccl_functions.h"

namespace physgen::cuda {

namespace {

const NcclFunctions& nccl() { return nccl_functions(); }

void check_nccl(ncclResult_t status, const char* asked) {
  if (status == ncclSuccess || status == ncclInProgress) return;
  const char* const more = nccl().last_error(nullptr);
  throw Error(std::string(asked) + ": NCCL: " + nccl().error_string(status) +
              (more != nullptr && *more != '\0' ? ": " + std::string(more) : "") +
              "; start the program with PHYSGEN_NCCL=none to go through pinned memory and MPI");
}

class Event {
 public:
  Event() { check(cudaEventCreateWithFlags(&event_, cudaEventDisableTiming), "making an event"); }
  Event(const Event&) = delete;
  Event& operator=(const Event&) = delete;
  ~Event() { cudaEventDestroy(event_); }
  /// What is ordered in `later` from now on waits for what is in `earlier`.
  void order(Stream earlier, Stream later) const {
    check(cudaEventRecord(event_, earlier), "ordering what crosses between ranks");
    check(cudaStreamWaitEvent(later, event_, 0), "ordering what crosses between ranks");
  }

 private:
  cudaEvent_t event_ = nullptr;
};

/// All operations of NCCL are in one stream, so that every rank has them in one order, also in graphs.
class NcclTransport final : public Transport {
 public:
  /// @param communicator belongs to this
  NcclTransport(Transport& host, Stream stream, ncclComm_t communicator)
      : Transport(host.traffic()), host_(host), stream_(stream), communicator_(communicator) {
    // Before kernels that are called while fields cross.
    int lowest = 0, highest = 0;
    check(cudaDeviceGetStreamPriorityRange(&lowest, &highest), "making a stream");
    check(cudaStreamCreateWithPriority(&crossing_, cudaStreamNonBlocking, highest), "making a stream");
  }
  /// NCCL makes connections when they are first used, which takes seconds: those of gathers, and to the ranks before
  /// and behind, which most fields cross to, are made now.
  void connect() {
    constexpr std::size_t size = 16;
    const auto ranks = static_cast<std::size_t>(count());
    const Buffer bytes(SpaceKind::cuda, static_cast<index_t>(size * (ranks + 3)), "first messages between ranks");
    const auto place = [&](std::size_t number) { return std::span(bytes.data() + size * number, size); };
    std::vector<Message> messages;
    if (rank() > 0) messages.push_back({rank() - 1, place(ranks), place(ranks + 1)});
    if (rank() + 1 < count()) messages.push_back({rank() + 1, place(ranks), place(ranks + 2)});
    begin_messages(messages);
    gather_bytes(place(ranks), std::vector<index_t>(ranks, index_t{size}), {bytes.data(), size * ranks});
    check(cudaStreamSynchronize(crossing_), "connecting ranks by NCCL");
  }
  NcclTransport(const NcclTransport&) = delete;
  NcclTransport& operator=(const NcclTransport&) = delete;
  ~NcclTransport() override {
    // A rank that is on its way out with an exception must not wait for the others.
    if (std::uncaught_exceptions() > 0) {
      (void)nccl().abort(communicator_);
    } else {
      cudaStreamSynchronize(crossing_);
      (void)nccl().destroy(communicator_);
    }
    cudaStreamDestroy(crossing_);
  }

  [[nodiscard]] int rank() const override { return host_.rank(); }
  [[nodiscard]] int count() const override { return host_.count(); }
  [[nodiscard]] std::vector<index_t> all_to_all(std::span<const index_t> given) override {
    return host_.all_to_all(given);
  }

  [[nodiscard]] bool can_be_captured() const override { return true; }

  void end() override { arrived_.order(crossing_, stream_); }

 private:
  void begin_messages(std::span<const Message> messages) override {
    packed_.order(stream_, crossing_);
    check_nccl(nccl().group_start(), "exchanging fields of ghosts");
    for (const Message& message : messages) {
      if (!message.sent.empty()) {
        check_nccl(
            nccl().send(message.sent.data(), message.sent.size(), ncclUint8, message.peer, communicator_, crossing_),
            "sending fields of ghosts");
      }
      if (!message.received.empty()) {
        check_nccl(nccl().receive(message.received.data(), message.received.size(), ncclUint8, message.peer,
                                  communicator_, crossing_),
                   "receiving fields of ghosts");
      }
    }
    check_nccl(nccl().group_end(), "exchanging fields of ghosts");
  }

  void gather_bytes(std::span<const std::byte> mine, std::span<const index_t> sizes,
                    std::span<std::byte> all) override {
    if (std::ranges::any_of(sizes, [&](index_t size) { return size != static_cast<index_t>(mine.size()); })) {
      throw Error("NCCL gathers as many bytes of each rank, and their numbers differ; pad them to the largest");
    }
    packed_.order(stream_, crossing_);
    check_nccl(nccl().all_gather(mine.data(), all.data(), mine.size(), ncclUint8, communicator_, crossing_),
               "gathering the values of a reduction's blocks");
    arrived_.order(crossing_, stream_);
  }

  Transport& host_;
  Stream stream_;
  ncclComm_t communicator_;
  cudaStream_t crossing_ = nullptr;
  Event packed_, arrived_;
};

}  // namespace

std::unique_ptr<Transport> make_nccl_transport(Transport& host, Stream stream, std::string& why_not) {
  why_not = reason_of_all(find_nccl().why_not, host);
  if (!why_not.empty()) return nullptr;

  // Of one program that orders all of it in one stream. Otherwise NCCL adds nodes to graphs that the body of a loop, on
  // whose rounds the device decides, cannot have.
  setenv("NCCL_GRAPH_MIXING_SUPPORT", "0", 0);
  ncclUniqueId id{};
  std::string mine;
  const auto note = [&](ncclResult_t status, const char* what) {
    if (status == ncclSuccess) return;
    const char* const more = nccl().last_error(nullptr);
    mine = std::string(what) + ": " + nccl().error_string(status) + (more != nullptr ? ": " + std::string(more) : "");
  };
  if (host.rank() == 0) note(nccl().get_unique_id(&id), "ncclGetUniqueId");
  why_not = reason_of_all(mine, host);
  if (!why_not.empty()) return nullptr;
  std::vector<ncclUniqueId> ids(static_cast<std::size_t>(host.count()));
  const std::vector<index_t> sizes(ids.size(), index_t{sizeof id});
  host.gather(std::as_bytes(std::span(&id, 1)), sizes, std::as_writable_bytes(std::span(ids)));

  ncclComm_t communicator = nullptr;
  note(nccl().init_rank(&communicator, host.count(), ids[0], host.rank()), "ncclCommInitRank");
  why_not = reason_of_all(mine, host);
  if (why_not.empty()) {
    auto transport = std::make_unique<NcclTransport>(host, stream, communicator);
    transport->connect();
    return transport;
  }
  if (communicator != nullptr) (void)nccl().abort(communicator);
  return nullptr;
}

}  // namespace physgen::cuda
