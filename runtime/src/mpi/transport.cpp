// Messages of MPI. A message of more bytes than MPI's counts have goes in pieces.
#include <mpi.h>
#include <physgen/distributed/transport.h>

#include <algorithm>
#include <limits>
#include <string>

namespace physgen {

namespace {

constexpr std::size_t most_bytes = std::size_t{1} << 30;
constexpr int tag = 2048;

class MpiTransport final : public Transport {
 public:
  explicit MpiTransport(const Ranks& ranks) : rank_(ranks.rank()), count_(ranks.count()) {
    MPI_Comm_dup(MPI_COMM_WORLD, &communicator_);
  }
  MpiTransport(const MpiTransport&) = delete;
  MpiTransport& operator=(const MpiTransport&) = delete;
  ~MpiTransport() override {
    int is_ended = 0;
    MPI_Finalized(&is_ended);
    // A rank that is on its way out with an exception must not wait for the others.
    if (is_ended == 0 && std::uncaught_exceptions() == 0) MPI_Comm_free(&communicator_);
  }

  [[nodiscard]] int rank() const override { return rank_; }
  [[nodiscard]] int count() const override { return count_; }

  void end() override {
    MPI_Waitall(static_cast<int>(requests_.size()), requests_.data(), MPI_STATUSES_IGNORE);
    requests_.clear();
  }

  [[nodiscard]] std::vector<index_t> all_to_all(std::span<const index_t> given) override {
    static_assert(sizeof(index_t) == sizeof(std::int64_t));
    std::vector<index_t> got(given.size());
    MPI_Alltoall(given.data(), 1, MPI_INT64_T, got.data(), 1, MPI_INT64_T, communicator_);
    return got;
  }

 private:
  void begin_messages(std::span<const Message> messages) override {
    for (const Message& message : messages) {
      for (std::size_t at = 0; at < message.received.size(); at += most_bytes) {
        const std::span<std::byte> piece =
            message.received.subspan(at).first(std::min(most_bytes, message.received.size() - at));
        MPI_Irecv(piece.data(), static_cast<int>(piece.size()), MPI_BYTE, message.peer, tag, communicator_,
                  &requests_.emplace_back());
      }
    }
    for (const Message& message : messages) {
      for (std::size_t at = 0; at < message.sent.size(); at += most_bytes) {
        const std::span<const std::byte> piece =
            message.sent.subspan(at).first(std::min(most_bytes, message.sent.size() - at));
        MPI_Isend(piece.data(), static_cast<int>(piece.size()), MPI_BYTE, message.peer, tag, communicator_,
                  &requests_.emplace_back());
      }
    }
  }

  void gather_bytes(std::span<const std::byte> mine, std::span<const index_t> sizes,
                    std::span<std::byte> all) override {
    if (all.size() > static_cast<std::size_t>(std::numeric_limits<int>::max())) {
      throw Error("what ranks gather, such as the values of a reduction's blocks, has " + std::to_string(all.size()) +
                  " bytes, and MPI gathers 2147483647 at most; reduce fewer terms in one kernel");
    }
    std::vector<int> lengths(sizes.size()), begins(sizes.size(), 0);
    for (std::size_t r = 0; r < sizes.size(); ++r) {
      lengths[r] = static_cast<int>(sizes[r]);
      if (r > 0) begins[r] = begins[r - 1] + lengths[r - 1];
    }
    MPI_Allgatherv(mine.data(), static_cast<int>(mine.size()), MPI_BYTE, all.data(), lengths.data(), begins.data(),
                   MPI_BYTE, communicator_);
  }

  int rank_, count_;
  MPI_Comm communicator_ = MPI_COMM_NULL;
  std::vector<MPI_Request> requests_;
};

}  // namespace

std::unique_ptr<Transport> make_transport(const Ranks& ranks) {
  if (ranks.count() == 1) return std::make_unique<SelfTransport>();
  return std::make_unique<MpiTransport>(ranks);
}

}  // namespace physgen
