// A header that a schema includes, and that has no objects itself.
#pragma once

namespace network {
inline constexpr int dimensions = 3;
}
