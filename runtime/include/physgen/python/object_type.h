// What Python modules know of an object type, as data: the fields in both precisions with their shapes, and the layouts
// that an array can be made in. So their functions are compiled once, whatever the number of types.
#pragma once

#include <physgen/detail/declared_array.h>
#include <physgen/error.h>
#include <physgen/fields/record.h>
#include <physgen/layout.h>

#include <array>
#include <span>
#include <string>
#include <string_view>

namespace physgen::python {

/// The shape in which NumPy sees a field of one object, without that of a fixed array: (), (rows) or (rows, columns).
struct FieldShape {
  int entries = 1;  ///< of a fixed array
  int rows = 0;     ///< 0: a number
  int columns = 0;  ///< 0: a vector, or the stored triangle of a symmetric or skew-symmetric matrix
};

namespace detail {

constexpr FieldShape shape_of(const shape::Scalar* /*shape*/) { return {}; }
template <int R, int C>
constexpr FieldShape shape_of(const shape::Matrix<R, C>* /*shape*/) {
  return {1, R, C == 1 ? 0 : C};
}
template <int N, bool kSkew>
constexpr FieldShape shape_of(const shape::Triangle<N, kSkew>* /*shape*/) {
  return {1, shape::Triangle<N, kSkew>::count, 0};
}

/// Appends the shapes of fields, in the order of physgen::detail::FieldInfos, to `out`.
struct FieldShapes {
  FieldShape* out;

  template <class Shape, class Format, class T>
  constexpr void add(StoredAs<Shape, Format, T> /*as*/, const Slot& slot) {
    *out = shape_of(static_cast<const Shape*>(nullptr));
    out++->entries = slot.entries;
  }
  template <class Object, class Formats, class Real>
  constexpr void add(NestedAs<Object, Formats, Real> /*as*/, const Slot& slot) {
    for (int entry = 0; entry < slot.entries; ++entry)
      add_all(typename Object::template Record<Real, Formats>::fields_());
  }
  template <class... Field>
  constexpr void add_all(RecordFields<Field...> /*fields*/) {
    const int added[] = {(add(Field(), Field::slot), 0)...};
    (void)added;
  }
};

template <class Record, std::size_t N>
constexpr std::array<FieldShape, N> field_shapes() {
  std::array<FieldShape, N> shapes{};
  FieldShapes{shapes.data()}.add_all(typename Record::fields_());
  return shapes;
}
template <class Object>
inline constexpr auto shapes_of =
    field_shapes<typename Object::template Record<float, FormatsOf<Object, Host>>, Object::texts.size()>();

}  // namespace detail

/// A layout as data.
struct LayoutRow {
  std::string_view name;  ///< as a schema writes it
  bool tiled;             ///< has tiles of several objects, and more than one
  index_t (*pitch)(index_t objects);
  index_t (*padded)(index_t objects);
  int (*record_bytes)(int bytes, int alignment);
};

namespace detail {
template <class Layout>
constexpr LayoutRow layout_row(std::string_view name) {
  return {name, requires { Layout::tile; }, Layout::pitch, Layout::padded, Layout::record_bytes};
}
}  // namespace detail

/// All layouts. "aosoa" alone is what the library takes for the host.
inline constexpr LayoutRow layouts[] = {
    detail::layout_row<Aos>("aos"),
    detail::layout_row<AosPadded>("aos_padded"),
    detail::layout_row<Soa>("soa"),
    detail::layout_row<Aosoa<16>>("aosoa"),
    detail::layout_row<Aosoa<2>>("aosoa(2)"),
    detail::layout_row<Aosoa<4>>("aosoa(4)"),
    detail::layout_row<Aosoa<8>>("aosoa(8)"),
    detail::layout_row<Aosoa<16>>("aosoa(16)"),
    detail::layout_row<Aosoa<32>>("aosoa(32)"),
    detail::layout_row<Aosoa<64>>("aosoa(64)"),
    detail::layout_row<Aosoa<128>>("aosoa(128)"),
    detail::layout_row<Aosoa<256>>("aosoa(256)"),
    detail::layout_row<Aosoa<512>>("aosoa(512)"),
    detail::layout_row<Aosoa<1024>>("aosoa(1024)"),
};

/// The row of the layout of a name; null: there is none.
[[nodiscard]] constexpr const LayoutRow* find_layout(std::string_view name) {
  for (const LayoutRow& row : layouts)
    if (row.name == name) return row.name == "aosoa" ? find_layout("aosoa(16)") : &row;
  return nullptr;
}

/// The row of a layout type. @throw Error when `layouts` lacks it
template <class Layout>
[[nodiscard]] const LayoutRow& row_of() {
  std::string name = Layout::name;
  if constexpr (requires { Layout::tile; }) name += "(" + std::to_string(Layout::tile) + ")";
  if (const LayoutRow* row = find_layout(name)) return *row;
  throw Error("Python modules do not know the layout " + name + "; add its row in physgen/python/object_type.h");
}

/// The record of an object type in one precision and in the formats of one space.
struct RecordInfo {
  std::span<const FieldInfo> fields;
  int bytes;
  int alignment;
};

/// What an object type is in a space.
struct SpaceInfo {
  RecordInfo with_float;
  RecordInfo with_double;
  const LayoutRow* layout;  ///< that of the schema
};

struct ObjectType {
  std::string_view name;  ///< qualified: "model::Stress"
  std::span<const FieldShape> shapes;
  SpaceInfo host, cuda;

  [[nodiscard]] const SpaceInfo& in(SpaceKind space) const { return space == SpaceKind::cuda ? cuda : host; }
  [[nodiscard]] const RecordInfo& record(SpaceKind space, bool in_double) const {
    return in_double ? in(space).with_double : in(space).with_float;
  }
};

namespace detail {

template <class Object, class Space, class Real>
[[nodiscard]] RecordInfo record_info() {
  using Record = typename Object::template Record<Real, FormatsOf<Object, Space>>;
  return {Object::template fields<Real, FormatsOf<Object, Space>>, Record::bytes, Record::alignment};
}
template <class Object, class Space, class Layout>
[[nodiscard]] SpaceInfo space_info() {
  return {record_info<Object, Space, float>(), record_info<Object, Space, double>(), &row_of<Layout>()};
}

}  // namespace detail

/// @tparam Object a generated tag such as model::StressObject
/// @tparam HostLayout, CudaLayout the schema's
template <class Object, class HostLayout, class CudaLayout>
[[nodiscard]] const ObjectType& object_type() {
  static const ObjectType type = {Object::name, detail::shapes_of<Object>,
                                  detail::space_info<Object, Host, HostLayout>(),
                                  detail::space_info<Object, Cuda, CudaLayout>()};
  return type;
}

}  // namespace physgen::python
