// The member type Scalar of a kernel, for kernels that call another one.
#pragma once

namespace physgen::detail {

/// Has the member type Scalar where the kernel has.
template <class Kernel>
struct ScalarOf {};
template <class Kernel>
  requires requires { typename Kernel::Scalar; }
struct ScalarOf<Kernel> {
  using Scalar = typename Kernel::Scalar;
};

}  // namespace physgen::detail
