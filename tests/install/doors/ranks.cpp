// The ranks of a program, and the sum of their numbers.
#include <physgen/distributed/transport.h>

#include <cstdio>
#include <vector>

int main(int argc, char** argv) {
  const physgen::Ranks ranks(argc, argv);
  const auto transport = physgen::make_transport(ranks);
  const physgen::index_t mine = ranks.rank();
  std::vector<physgen::index_t> all(static_cast<std::size_t>(ranks.count()));
  const std::vector<physgen::index_t> sizes(all.size(), sizeof(mine));
  transport->gather(std::as_bytes(std::span(&mine, 1)), sizes, std::as_writable_bytes(std::span(all)));
  physgen::index_t sum = 0;
  for (const physgen::index_t one : all) sum += one;
  if (ranks.is_first()) std::printf("%d ranks, sum %lld\n", ranks.count(), static_cast<long long>(sum));
}
