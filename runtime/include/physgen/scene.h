// The words in which a scene is declared: the arrays of a program, those that it is given and those that are wanted.
// physgen instantiates the program, finds which fields of which arrays it reads and writes, and writes a header with
// exactly those. To other compilers the macros are empty and arrays are plain markers.
//
//   #include <physgen/scene.h>
//   #include <elasticity.physgen.h>
//   #include <fem/kernels/compute_svd.h>
//   namespace scenes {
//   using namespace physgen::scene;
//
//   /// Principal stretches of given deformation gradients.               (doc comments reach the generated header)
//   struct PHYSGEN_SCENE() stretches {
//     using Real = float;                                                 // the precision is a choice of the scene
//     struct Body {                                                       // a group of arrays
//       PHYSGEN_ARRAY(per("tet"), input()) Array<elasticity::DeformationGradientObject, Real> gradients;
//       PHYSGEN_ARRAY(per("tet"), output("s")) Array<elasticity::DeformationSvdObject, Real> svds;
//     };
//     template <class On, class Body>                                     // one reference per group, in order
//     static void program(On& on, Body& body) {
//       on.run(body.gradients.size(), physgen::fem::ComputeSvd{body.gradients.view(), body.svds.view()});
//     }
//   };
//   }
//
// A file declares one scene, which has the file's name: stretches.h. Behind its groups, program may take further
// parameters, of types that are no templates' parameters: numbers and structs that the caller chooses at run time.
#pragma once

#include <physgen/detail/declared_array.h>

#if defined(__clang__) && !defined(__CUDACC__)
/// Marks a struct as a scene: `struct PHYSGEN_SCENE() name { ... };`.
#define PHYSGEN_SCENE() [[clang::annotate("physgen.scene")]]
/// Marks the arrays of a group, before their type. Options: per(...), and where they hold, input(...), output(...),
/// uniform(), names(...), no_index(...) and follows(...).
#define PHYSGEN_ARRAY(...) [[clang::annotate("physgen.array" __VA_OPT__(, ) __VA_ARGS__)]]
#else
#define PHYSGEN_SCENE()
#define PHYSGEN_ARRAY(...)
#endif

namespace physgen::scene {

using physgen::Array;

namespace detail {
inline constexpr int most_names = 32;
struct Names {
  const char* names[most_names] = {};
  int count = 0;  // 0: all fields
};
struct Per {
  const char* set = nullptr;
  int count = 0;
};
struct Input {
  Names fields;
};
struct Output {
  Names fields;
};
struct Uniform {
  int records = 1;
};
struct Shift {
  int bits = 0;
};
/// No set: the field is no index.
struct NamesObjects {
  const char* field = nullptr;
  const char* set = nullptr;
  Shift shift;
};
struct Follows {
  const char* set = nullptr;
};

template <class... Text>
[[nodiscard]] constexpr Names names(Text... text) {
  static_assert(sizeof...(text) <= most_names, "no array has more than 32 fields named one by one; name none for all");
  return {{text...}, int{sizeof...(text)}};
}
}  // namespace detail

/// As many objects as the set has that the text names, such as "tet" or "node". Whoever allocates the group says how
/// many these are.
[[nodiscard]] constexpr detail::Per per(const char* set) { return {set, 0}; }
/// The same number always: per(1) is for the numbers that a program keeps once.
[[nodiscard]] constexpr detail::Per per(int count) { return {nullptr, count}; }

/// Fields that the caller fills before the program runs: all, or those named. One that the program never reads is
/// pruned.
template <class... Text>
[[nodiscard]] constexpr detail::Input input(Text... fields) {
  return {detail::names(fields...)};
}

/// Fields that are wanted of the program: all, or those named.
template <class... Text>
[[nodiscard]] constexpr detail::Output output(Text... fields) {
  return {detail::names(fields...)};
}

/// One record for all objects, which are all the same. The program only reads it.
[[nodiscard]] constexpr detail::Uniform uniform() { return {}; }

/// An index field that names objects of a set by their numbers: names("nodes", "node"). Of a field that names objects
/// of several sets, which are counted alike, each is said by a names() of its own.
/// @param shift of a number that lies above others in the same field: names("code", "tet", shifted(2))
[[nodiscard]] constexpr detail::NamesObjects names(const char* field, const char* set, detail::Shift shift = {}) {
  return {field, set, shift};
}
/// The number is field >> bits.
[[nodiscard]] constexpr detail::Shift shifted(int bits) { return {bits}; }

/// An integer field that names no objects: bits, kinds, counts.
[[nodiscard]] constexpr detail::NamesObjects no_index(const char* field) { return {field, "", {}}; }

/// Where the objects of a set are divided among ranks, an object of this array's set is computed on each rank that owns
/// one of the objects of `set` that it names: an edge or a tet that follows("node").
[[nodiscard]] constexpr detail::Follows follows(const char* set) { return {set}; }

}  // namespace physgen::scene
