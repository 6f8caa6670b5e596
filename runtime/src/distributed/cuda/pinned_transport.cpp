// Messages of devices through pinned memory and the transport of the host.
#include <physgen/cuda/check.h>
#include <physgen/device.h>
#include <physgen/distributed/cuda/transports.h>
#include <physgen/memory/buffer.h>

#include <vector>

namespace physgen::cuda {

namespace {

void copy(std::byte* to, const std::byte* from, std::size_t bytes, Stream stream) {
  if (bytes > 0)
    check(cudaMemcpyAsync(to, from, bytes, cudaMemcpyDefault, stream), "copying what crosses between ranks");
}

class PinnedTransport final : public Transport {
 public:
  PinnedTransport(Transport& host, Stream stream) : Transport(host.traffic()), host_(host), stream_(stream) {}

  [[nodiscard]] int rank() const override { return host_.rank(); }
  [[nodiscard]] int count() const override { return host_.count(); }
  [[nodiscard]] std::vector<index_t> all_to_all(std::span<const index_t> given) override {
    return host_.all_to_all(given);
  }

  void end() override {
    host_.end();
    for (const Message& message : messages_) {
      copy(message.received.data(), place_of_received(message), message.received.size(), stream_);
    }
    messages_.clear();
  }

 private:
  void begin_messages(std::span<const Message> messages) override {
    messages_.assign(messages.begin(), messages.end());
    places_.assign(static_cast<std::size_t>(count()), {});
    std::size_t sent = 0, received = 0;
    for (const Message& message : messages) {
      places_[static_cast<std::size_t>(message.peer)] = {sent, received};
      sent += message.sent.size();
      received += message.received.size();
    }
    reserve(sent_, sent);
    reserve(received_, received);
    std::vector<Message> on_host;
    for (const Message& message : messages) {
      std::byte* const mine = sent_.data() + places_[static_cast<std::size_t>(message.peer)].sent;
      copy(mine, message.sent.data(), message.sent.size(), stream_);
      on_host.push_back(
          {message.peer, {mine, message.sent.size()}, {place_of_received(message), message.received.size()}});
    }
    synchronize(stream_);  // also with what was received before
    host_.begin(on_host);
  }

  void gather_bytes(std::span<const std::byte> mine, std::span<const index_t> sizes,
                    std::span<std::byte> all) override {
    reserve(sent_, mine.size());
    reserve(received_, all.size());
    copy(sent_.data(), mine.data(), mine.size(), stream_);
    synchronize(stream_);
    host_.gather({sent_.data(), mine.size()}, sizes, {received_.data(), all.size()});
    copy(all.data(), received_.data(), all.size(), stream_);
  }

  struct Place {
    std::size_t sent, received;
  };
  [[nodiscard]] std::byte* place_of_received(const Message& message) const {
    return received_.data() + places_[static_cast<std::size_t>(message.peer)].received;
  }
  void reserve(Buffer& buffer, std::size_t bytes) const {
    if (static_cast<std::size_t>(buffer.bytes()) >= bytes) return;
    synchronize(stream_);  // with what still reads it
    buffer = Buffer(SpaceKind::pinned, static_cast<index_t>(bytes), "what crosses between ranks");
  }

  Transport& host_;
  Stream stream_;
  Buffer sent_, received_;
  std::vector<Message> messages_;
  std::vector<Place> places_;  ///< by rank
};

}  // namespace

std::unique_ptr<Transport> make_pinned_transport(Transport& host, Stream stream) {
  return std::make_unique<PinnedTransport>(host, stream);
}

}  // namespace physgen::cuda
