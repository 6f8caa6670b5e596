// What all transports count, and that of one rank.
#include <physgen/distributed/transport.h>

#include <algorithm>

namespace physgen {

Traffic& Traffic::operator+=(const Traffic& other) {
  exchanges += other.exchanges;
  messages += other.messages;
  bytes += other.bytes;
  gathers += other.gathers;
  gathered_bytes += other.gathered_bytes;
  overlapped += other.overlapped;
  return *this;
}

Traffic Traffic::operator-(const Traffic& other) const {
  return {
      exchanges - other.exchanges,           messages - other.messages,    bytes - other.bytes, gathers - other.gathers,
      gathered_bytes - other.gathered_bytes, overlapped - other.overlapped};
}

Traffic Traffic::operator*(index_t times) const {
  return {times * exchanges, times * messages,       times * bytes,
          times * gathers,   times * gathered_bytes, times * overlapped};
}

void Transport::begin(std::span<const Message> messages) {
  ++traffic_.exchanges;
  for (const Message& message : messages) {
    traffic_.messages += message.sent.empty() ? 0 : 1;
    traffic_.bytes += static_cast<index_t>(message.sent.size());
  }
  begin_messages(messages);
}

void Transport::gather(std::span<const std::byte> mine, std::span<const index_t> sizes, std::span<std::byte> all) {
  ++traffic_.gathers;
  traffic_.gathered_bytes += static_cast<index_t>(mine.size());
  gather_bytes(mine, sizes, all);
}

void SelfTransport::begin_messages(std::span<const Message> messages) {
  if (!messages.empty()) throw Error("one rank has nobody to send messages to; give none");
}

void SelfTransport::gather_bytes(std::span<const std::byte> mine, std::span<const index_t> /*sizes*/,
                                 std::span<std::byte> all) {
  std::ranges::copy(mine, all.begin());
}

std::vector<index_t> SelfTransport::all_to_all(std::span<const index_t> given) { return {given.begin(), given.end()}; }

}  // namespace physgen
