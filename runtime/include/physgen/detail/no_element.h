// The parts of formats that store nothing.
#pragma once

namespace physgen::format::detail {

/// In place of a number. C++ gives it a byte, which no record has.
struct NoElement {};

/// False for every type: the condition of static_asserts that refuse code which reads.
template <class>
inline constexpr bool is_kept = false;

}  // namespace physgen::format::detail
