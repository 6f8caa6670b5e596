// Chooses how many objects the CPU calls a kernel with at once, for speed. Results have the same bits either way,
// except for what in_lanes.h names.
//
// Packs gain where arithmetic is done and fields are loaded as registers. They lose where records are collected lane by
// lane, while a loop over single objects reads each as it lies. When a kernel is compiled its type alone is known: the
// views and rows that are arguments of its template. Of them follows
//
// - over rows: one lane. But packs where an entry is one number and all views are of one type of object: there lanes
//   that lie together name neighbours that do.
// - over views of AoS alone: one lane, since packs collect every field of every object.
// - over all else, and where no views are known: packs.
//
// runtime/README.md has the measurement that the rule comes from.
#pragma once

#include <physgen/fields/object_info.h>
#include <physgen/launch/in_lanes.h>
#include <physgen/layout.h>
#include <physgen/rows.h>

#include <string_view>
#include <type_traits>

namespace physgen {
template <class Object, class Real, class Formats, class Tag, class Layout>
struct Local;  // fuse.h
}  // namespace physgen

namespace physgen::detail {

/// The views and rows that a kernel is made over.
template <class... Part>
struct Parts {
  template <class... Other>
  friend constexpr Parts<Part..., Other...> operator+(Parts, Parts<Other...>) {
    return {};
  }
};

template <class T>
constexpr Parts<> part_of(std::type_identity<T> /*argument*/) {
  return {};
}
template <class Object, class Real, class Layout, class Formats, class Space>
constexpr Parts<View<Object, Real, Layout, Formats, Space>> part_of(
    std::type_identity<View<Object, Real, Layout, Formats, Space>> /*argument*/) {
  return {};
}
template <class Ranges, class Entries>
constexpr Parts<Rows<Ranges, Entries>> part_of(std::type_identity<Rows<Ranges, Entries>> /*argument*/) {
  return {};
}

/// A local of a fused kernel tells what the array tells that it is in the place of.
template <class Object, class Real, class Formats, class Tag, class Layout>
constexpr auto part_of(std::type_identity<Local<Object, Real, Formats, Tag, Layout>> /*argument*/) {
  using Stored = typename Local<Object, Real, Formats, Tag, Layout>::template FormatsIn<Host>;
  return Parts<View<Object, Real, Layout, Stored, Host>>();
}

template <class Kernel>
struct PartsOf {
  static constexpr Parts<> parts{};
};
template <template <class...> class Kernel, class... Argument>
struct PartsOf<Kernel<Argument...>> {
  static constexpr auto parts = (Parts<>() + ... + part_of(std::type_identity<std::remove_cv_t<Argument>>()));
};

/// Fields of the objects of a view.
template <class View>
inline constexpr auto fields_of = View::Object::template fields<typename View::Precision, typename View::Formats>;

/// What the rule asks of a part: of a view, or of rows. A view of ranges, `Index begin, end`, tells of rows, too.
template <class Part>
struct PartFacts {
  using Object = typename Part::Object;
  static constexpr bool has(std::string_view name) {
    for (const FieldInfo& field : fields_of<Part>) {
      if (field.name == name && field.type == ElementType::int32) return true;
    }
    return false;
  }
  static constexpr bool in_one_piece = std::is_same_v<typename Part::Layout::Pitch, StaticPitch<1>>;
  static constexpr bool rows = has("begin") && has("end");
  static constexpr bool of_numbers_alone = false;
};
template <class Ranges, class Entries>
struct PartFacts<Rows<Ranges, Entries>> {
  using Object = void;
  static constexpr bool in_one_piece = true, rows = true;
  static constexpr bool of_numbers_alone = fields_of<Entries>.size() == 1 && fields_of<Entries>[0].count == 1 &&
                                           fields_of<Entries>[0].type == ElementType::int32;
};

/// Whether all views are of the first's type of object.
template <class First, class... Rest>
constexpr bool of_one_object(Parts<First, Rest...> /*parts*/) {
  using Object = typename PartFacts<First>::Object;
  if constexpr (std::is_void_v<Object>) {
    return of_one_object(Parts<Rest...>());
  } else {
    return ((std::is_void_v<typename PartFacts<Rest>::Object> ||
             std::is_same_v<typename PartFacts<Rest>::Object, Object>) &&
            ...);
  }
}
constexpr bool of_one_object(Parts<> /*parts*/) { return true; }

/// Whether the rule above gives one lane.
template <class... Part>
constexpr bool suits_one_lane(Parts<Part...> parts) {
  if constexpr ((PartFacts<Part>::rows || ...)) {
    return !((!PartFacts<Part>::rows || PartFacts<Part>::of_numbers_alone) && ...) || !of_one_object(parts);
  } else {
    return sizeof...(Part) > 0 && (PartFacts<Part>::in_one_piece && ...);
  }
}

template <class Kernel>
inline constexpr bool kernel_suits_one_lane = suits_one_lane(PartsOf<Kernel>::parts);

}  // namespace physgen::detail
