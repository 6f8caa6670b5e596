// All storage formats: how the elements of a field lie in memory, apart from the type they are computed with.
//
// The library's are Native, Float32, Float64, Half<k>, Bfloat16, Snorm16<Interval{low, high}>, Scaled<Base,
// Affine{scale, centre}>, and Quaternion<Component> for rotations. Their meaning is data, so that they are converted
// everywhere: by accessors, packs, kernels and copies, on the host and on the device. Nothing and Pruned<Scene, Array,
// Field> store no bytes: for fields that a program does not read. A unit or an offset needs no more:
//
//   using Kilometres = physgen::format::Scaled<physgen::format::Float32, physgen::format::Affine{.scale = 1000}>;
//
// A format of your own is a struct with the members of format::Native except Library, by which the library knows its
// own. For lengths, say, that lie close to each other near zero:
//
//   struct Rooted {                                                   // keeps the square root, in a half
//     static constexpr const char* name = "rooted";
//     template <class Real> using Stored = std::uint16_t;             // of 2, 4 or 8 bytes
//     template <class Real> static constexpr physgen::ElementType type = physgen::ElementType::half;
//     static constexpr double scale = 1, centre = 0;
//     template <class Real> PHYSGEN_FUNCTION static Real decode(std::uint16_t stored) {
//       const Real root = physgen::format::Half<>::decode<Real>(stored);
//       return root * root;
//     }
//     template <class Real> PHYSGEN_FUNCTION static std::uint16_t encode(Real value) {
//       return physgen::format::Half<>::encode<Real>(std::sqrt(value));
//     }
//   };
//   struct Compact : model::RodFormats<physgen::Host> { using length = Rooted; };
//   model::RodArray<float, physgen::Host, physgen::Soa, Compact> rods(n);
//
// Only its two functions count: accessors, packs and kernels call them, on the device too where they are
// marked PHYSGEN_FUNCTION; copies between host arrays, to the device and from there, getdata(), putdata() and initial
// values call them on the host. Only a copy from one array in CUDA memory to another that must change such a field is
// refused, by an Error that names the field. `type` gives the size of what is stored, and the precision that checked
// builds expect of it (of snorm16: to scale / 32767).
#pragma once

#include <physgen/detail/from_library.h>
#include <physgen/format/bfloat16.h>
#include <physgen/format/half.h>
#include <physgen/format/native.h>
#include <physgen/format/nothing.h>
#include <physgen/format/probe_traits.h>
#include <physgen/format/quaternion.h>
#include <physgen/format/scaled.h>
#include <physgen/format/snorm16.h>
