// The SVD over whole arrays, for users: svd(F, U, s, V). Include <physgen/parallel_for.h>, or in CUDA files
// <physgen/cuda/parallel_for.h>, before or after; that decides where it can run.
#pragma once

#include <fem/kernels/compute_svd.h>
#include <physgen/arrays/array.h>
#include <physgen/error.h>

#include <string>
#include <type_traits>

namespace physgen::fem {

namespace detail {

// The view of an output, Skip for none.
inline Skip view_of(const Skip& part) { return part; }
template <class Array>
auto view_of(Array& array) {
  return array.view();
}

inline void check_size(const Skip& /*part*/, const char* /*name*/, index_t /*expected*/) {}
template <class Array>
void check_size(const Array& array, const char* name, index_t expected) {
  if (array.size() == expected) return;
  throw Error("svd(F, U, s, V): " + std::string(name) + " has " + std::to_string(array.size()) + " objects, F has " +
              std::to_string(expected) + "; resize it first");
}

template <class Gradients, class Part>
constexpr bool goes_with() {
  using Plain = std::remove_cvref_t<Part>;
  if constexpr (std::is_same_v<Plain, Skip>) {
    return true;
  } else {
    return std::is_same_v<typename Plain::Space, typename Gradients::Space> &&
           std::is_same_v<typename Plain::Precision, typename Gradients::Precision>;
  }
}

}  // namespace detail

/// F = U diag(s) V^T for each object; see svd(A) for what is guaranteed. On CUDA it runs in the default stream and does
/// not wait; for another stream, run the kernel ComputeSvdParts.
/// @param F array of any generated type whose only field is a Matrix<3, 3>, in any layout and format
/// @param U, V arrays of types whose only field is a Rotation or Matrix<3, 3>, written; or `skip`
/// @param s array of a type whose only field is a Diagonal<3> or Vector<3>, written; or `skip`
/// @tparam kSweeps see svd(A)
/// @pre all four differ
/// @throw Error when sizes differ; nothing is written then
template <int kSweeps = 4, class Gradients, class Left, class Stretches, class Right>
void svd(const Gradients& F, Left&& U, Stretches&& s, Right&& V) {
  static_assert(detail::goes_with<Gradients, Left>() && detail::goes_with<Gradients, Stretches>() &&
                    detail::goes_with<Gradients, Right>(),
                "svd(F, U, s, V): all arrays have the space and the precision of F");
  using Space = typename Gradients::Space;
  using Where = std::conditional_t<Space::kind == SpaceKind::cuda, Cuda, Host>;
  detail::check_size(U, "U", F.size());
  detail::check_size(s, "s", F.size());
  detail::check_size(V, "V", F.size());
  parallel_for(
      Where{}, F.size(),
      ComputeSvdParts{F.view(), detail::view_of(U), detail::view_of(s), detail::view_of(V), Sweeps<kSweeps>{}});
}

}  // namespace physgen::fem
