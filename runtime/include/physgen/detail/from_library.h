// Tells the library's own formats, which copies know by their numbers alone.
#pragma once

#include <type_traits>

namespace physgen::format {

/// Whether copies, on the host and on the device, convert elements of this format by its type, scale and centre.
/// For every other format, a program's own, they call its functions. A struct that derives from one of the library's is
/// a format of its own.
template <class Format>
concept FromLibrary = requires { typename Format::Library; } && std::is_same_v<typename Format::Library, Format>;

}  // namespace physgen::format
