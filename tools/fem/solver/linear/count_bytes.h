// An executor that runs nothing and counts bytes: those of the arrays that the steps of a program are given, once for
// each kernel that has them. What a kernel reads and writes again counts once, so this is the least that moves.
#pragma once

#include <fem/kernels/symmetric_product.h>
#include <fem/solver/preconditioners/multigrid/cycle.h>
#include <physgen/arrays/view.h>
#include <physgen/rows.h>

#include <tuple>
#include <type_traits>

namespace physgen::fem {

namespace detail {

/// Stands for a member of any type where members are counted.
struct AnyMember {
  template <class T>
  operator T() const;  // NOLINT(google-explicit-constructor): never called
};

template <class Struct, class... Counted>
consteval int member_count() {
  if constexpr (requires { Struct{Counted{}..., AnyMember{}}; }) {
    return member_count<Struct, Counted..., AnyMember>();
  } else {
    return static_cast<int>(sizeof...(Counted));
  }
}

/// References to the members of a struct that has up to sixteen.
template <class Struct>
auto members_of(const Struct& s) {
  constexpr int count = member_count<Struct>();
  static_assert(count <= 16, "a kernel of more members needs its own line here");
  // clang-format off
  if constexpr (count == 0) { return std::tie(); }
  else if constexpr (count == 1) { const auto& [a] = s; return std::tie(a); }
  else if constexpr (count == 2) { const auto& [a, b] = s; return std::tie(a, b); }
  else if constexpr (count == 3) { const auto& [a, b, c] = s; return std::tie(a, b, c); }
  else if constexpr (count == 4) { const auto& [a, b, c, d] = s; return std::tie(a, b, c, d); }
  else if constexpr (count == 5) { const auto& [a, b, c, d, e] = s; return std::tie(a, b, c, d, e); }
  else if constexpr (count == 6) { const auto& [a, b, c, d, e, f] = s; return std::tie(a, b, c, d, e, f); }
  else if constexpr (count == 7) { const auto& [a, b, c, d, e, f, g] = s; return std::tie(a, b, c, d, e, f, g); }
  else if constexpr (count == 8) { const auto& [a, b, c, d, e, f, g, h] = s; return std::tie(a, b, c, d, e, f, g, h); }
  else if constexpr (count == 9) { const auto& [a, b, c, d, e, f, g, h, i] = s; return std::tie(a, b, c, d, e, f, g, h, i); }
  else if constexpr (count == 10) { const auto& [a, b, c, d, e, f, g, h, i, j] = s; return std::tie(a, b, c, d, e, f, g, h, i, j); }
  else if constexpr (count == 11) { const auto& [a, b, c, d, e, f, g, h, i, j, k] = s; return std::tie(a, b, c, d, e, f, g, h, i, j, k); }
  else if constexpr (count == 12) { const auto& [a, b, c, d, e, f, g, h, i, j, k, l] = s; return std::tie(a, b, c, d, e, f, g, h, i, j, k, l); }
  else if constexpr (count == 13) { const auto& [a, b, c, d, e, f, g, h, i, j, k, l, m] = s; return std::tie(a, b, c, d, e, f, g, h, i, j, k, l, m); }
  else if constexpr (count == 14) { const auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n] = s; return std::tie(a, b, c, d, e, f, g, h, i, j, k, l, m, n); }
  else if constexpr (count == 15) { const auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o] = s; return std::tie(a, b, c, d, e, f, g, h, i, j, k, l, m, n, o); }
  else { const auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p] = s; return std::tie(a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p); }
  // clang-format on
}

template <class Object, class Real, class Layout, class Formats, class Space>
[[nodiscard]] index_t bytes_of_views(const View<Object, Real, Layout, Formats, Space>& view) {
  return view.size() * view.record_bytes;
}
template <class Ranges, class Entries>
[[nodiscard]] index_t bytes_of_views(const Rows<Ranges, Entries>& rows) {
  return bytes_of_views(rows.ranges()) + bytes_of_views(rows.entries());
}
/// Counts the bytes of the views and rows among the members of a kernel.
template <class Kernel>
[[nodiscard]] index_t bytes_of_views(const Kernel& kernel) {
  if constexpr (std::is_arithmetic_v<Kernel> || std::is_enum_v<Kernel>) {
    return 0;
  } else {
    static_assert(std::is_aggregate_v<Kernel>, "the members of this type cannot be looked at");
    return std::apply([](const auto&... member) { return (index_t{0} + ... + bytes_of_views(member)); },
                      members_of(kernel));
  }
}

}  // namespace detail

/// @tparam Space_ of the arrays
template <class Space_>
class ByteCounter {
 public:
  using Space = Space_;
  static constexpr bool only_counts = true;
  /// Counts one round of a loop.
  struct Loop {
    index_t bytes = 0;
  };

  /// Since this was made; of loops one round.
  [[nodiscard]] index_t bytes() const { return bytes_; }
  void add(index_t bytes) { bytes_ += bytes; }
  template <class Kernel>
  void count(const Kernel& kernel) {
    add(detail::bytes_of_views(kernel));
  }

  template <class Kernel>
  void run(index_t n, const Kernel& kernel) {
    if (n > 0) count(kernel);
  }
  template <class Kernel, class Fold, class Then>
  void reduce(index_t n, const Kernel& kernel, Fold /*fold*/, const Then& /*then*/) {
    run(n, kernel);
  }
  template <class Body, class Done>
  void repeat(Loop& loop, int /*most*/, const Body& body, const Done& /*done*/) {
    const index_t before = bytes_;
    body();
    loop.bytes = bytes_ - before;
  }

 private:
  index_t bytes_ = 0;
};

template <class Space, class... Views>
void multiply(ByteCounter<Space>& on, const SymmetricProduct<Views...>& product, const EdgeSums& /*sums*/) {
  on.add(detail::bytes_of_views(product));
}
template <class Space, class... Views>
void add_edges(ByteCounter<Space>& on, const SymmetricProduct<Views...>& product, const EdgeSums& /*sums*/) {
  on.add(detail::bytes_of_views(product) - detail::bytes_of_views(product.node_stiffness));
}

template <class Space, class Level>
void add_scaled_edges(ByteCounter<Space>& on, Level& level) {
  const auto product = scaled_product(level, level.direction.const_view(), level.residual.view());
  if (level.rows.is_empty()) {
    add_edges(on, product, level.sums);
  } else {
    on.add(detail::bytes_of_views(product.edge_stiffness) + detail::bytes_of_views(product.displacements) +
           detail::bytes_of_views(product.differentials) + level.rows.bytes());
  }
}

}  // namespace physgen::fem
