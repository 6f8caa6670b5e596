// Springs that pull nodes together, on as many ranks as the program is started with. Prints a digest of the positions.
#include <physgen/row_arrays.h>
#include <relax.distributed.h>

#include <array>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <exception>
#include <vector>

namespace {

using physgen::index_t;
using EndsOfNodes = physgen::RowArrays<elasticity::IncidenceRangeArray<float>, elasticity::IncidenceArray<float>>;

/// A ladder of nodes: each is tied to the next, and to the one that lies 40 ahead.
struct Mesh {
  index_t nodes = 9000, edges = 2 * nodes - 41;
  EndsOfNodes node_edges = ends();

  [[nodiscard]] std::array<index_t, 2> edge(index_t e) const {
    return e < nodes - 1 ? std::array{e, e + 1} : std::array{e - nodes + 1, e - nodes + 41};
  }
  [[nodiscard]] elasticity::NodePosition<float> position(index_t node) const {
    elasticity::NodePosition<float> value{};
    for (int k = 0; k < 3; ++k) value.x[k] = static_cast<float>(node * (k + 3) % 11) * 0.1F;
    return value;
  }

 private:
  [[nodiscard]] EndsOfNodes ends() const {
    std::vector<std::pair<index_t, elasticity::Incidence<float>>> pairs;
    for (index_t e = 0; e < edges; ++e) {
      for (int k = 0; k < 2; ++k) {
        elasticity::Incidence<float> end{};
        end.element = static_cast<std::int32_t>(e);
        end.local = k;
        pairs.emplace_back(edge(e)[static_cast<std::size_t>(k)], end);
      }
    }
    return EndsOfNodes::from_pairs({"element", edges}, nodes, pairs);
  }
};

void relax(const physgen::Ranks& ranks) {
  const Mesh mesh;
  scenes::relax_scene::Distributed<physgen::Host> body(ranks,
                                                       {.node = mesh.nodes, .edge = mesh.edges, .end = 2 * mesh.edges});
  body.connect(body.edges, [&](index_t e) { return mesh.edge(e); });
  body.connect(body.ranges, body.ends, mesh.node_edges);
  body.cut();
  body.fill(body.positions, [&](index_t node) { return mesh.position(node); });
  physgen::DistributedExecutor<physgen::HostExecutor> on(ranks, body);
  scenes::relax_scene::program(on, body, 30);
  std::uint64_t digest = 0xcbf29ce484222325;
  index_t expected = 0;
  body.each_block(
      body.positions,
      [&](index_t first, auto view) {
        if (first != expected) throw physgen::Error("blocks are not in order");
        for (index_t i = 0; i < view.size(); ++i) {
          for (int k = 0; k < 3; ++k) {
            const float x = view[i].x()[k];
            std::uint32_t bits = 0;
            std::memcpy(&bits, &x, sizeof bits);
            digest = (digest ^ bits) * 0x100000001b3;
          }
        }
        expected = first + view.size();
      },
      1 << 16);
  if (ranks.is_first()) {
    std::printf("digest %016llx of %lld nodes\n", static_cast<unsigned long long>(digest),
                static_cast<long long>(expected));
  }
  std::fprintf(stderr, "%d of %d: %lld owned, %lld exchanges\n", ranks.rank(), ranks.count(),
               static_cast<long long>(body.objects_of(body.positions).owned()),
               static_cast<long long>(on.traffic().exchanges));
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const physgen::Ranks ranks(argc, argv);
    ranks.guard([&] { relax(ranks); });
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
