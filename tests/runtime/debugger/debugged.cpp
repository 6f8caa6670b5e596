// A program to be looked at in a debugger: arrays in every layout and format, what refers to them, and broken ones. It
// prints lines "expression = text" of what gdb should show, and stops in stop(). With an argument, it prints the law of
// addresses.
#include <elasticity.physgen.h>
#include <everything.physgen.h>
#include <physgen/parallel_for.h>
#include <physgen/row_arrays.h>
#include <physgen/scenes/scene_arrays.h>

#include <Eigen/Geometry>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <new>

#include "shown.h"

namespace {

using namespace physgen;
namespace model = tissue::model;

/// A breakpoint is set here; what is kept is not optimised away.
[[gnu::noinline]] void stop(const void* const* kept) { asm volatile("" : : "r"(kept) : "memory"); }

/// Keeps the square root, in a half.
struct Rooted {
  static constexpr const char* name = "rooted";
  template <class Real>
  using Stored = std::uint16_t;
  template <class Real>
  static constexpr ElementType type = ElementType::half;
  static constexpr double scale = 1, centre = 0;
  template <class Real>
  static Real decode(std::uint16_t stored) {
    const Real root = format::Half<>::decode<Real>(stored);
    return root * root;
  }
  template <class Real>
  static std::uint16_t encode(Real value) {
    return format::Half<>::encode<Real>(std::sqrt(value));
  }
};
struct Odd : model::FrameFormats<Host> {
  using turn = format::Nothing;
  using origin = format::Scaled<format::Half<>, format::Affine{.scale = 0.1, .centre = 300.1}>;
  using weight = Rooted;
};

template <class Array>
Array shapes() {
  Array array(std::is_same_v<typename Array::Layout, Soa> ? 512 : 70);
  for (index_t i = 0; i < array.size(); ++i) {
    typename Array::Value value;
    const auto at = static_cast<typename Array::Precision>(i);
    value.a = at / 8;
    value.v = {at, at + 1, -at};
    value.nodes = Eigen::Vector4i(static_cast<int>(i), 1, 2, -3);
    value.F.col(0) = value.v * 2;
    value.F(1, 2) = at / 3;
    value.B(1, 2) = 7;
    value.row(0, 3) = -at;
    value.K = value.F + value.F.transpose();
    value.C2(1, 0) = value.C2(0, 1) = static_cast<double>(i) / 3;
    value.s = {3, 2, at};
    value.W(1, 0) = at;
    value.W(0, 1) = -at;
    value.W(2, 1) = 5;
    value.W(1, 2) = -5;
    value.count = Eigen::Vector2i(4, static_cast<int>(i));
    value.M(1, 0) = 0.1;
    array.view().put(i, value);
  }
  return array;
}

template <class Array>
Array stored() {
  Array array(20);
  const auto view = array.view();
  for (index_t i = 0; i < array.size(); ++i) {
    auto value = view.get(i);
    const auto at = static_cast<typename Array::Precision>(i);
    value.single = at / 3;
    value.twice = at / 7;
    value.narrowed = static_cast<double>(i) / 7;
    value.plain_half = value.wide = value.angle = at / 9;
    value.load = 1000 * at;
    value.temperature = 300 + at;
    value.stress(1, 0) = value.stress(0, 1) = 1e5F * at;
    value.F(0, 2) = at;
    value.spin(2, 0) = at / 3;
    value.spin(0, 2) = -value.spin(2, 0);
    for (int k = 0; k < 5; ++k) value.halves[k] = at + static_cast<typename Array::Precision>(k);
    value.frames[1].origin = {at, 1, 2};
    value.frames[1].weight = at / 40;
    view.put(i, value);
  }
  return array;
}

/// Looked at from within: a pack, and references to its objects.
template <class View>
struct Inside {
  View view;
  template <class I>
  [[gnu::noinline]] void operator()(I i) const {
    [[maybe_unused]] const auto of_pack = view[i];
    const auto gathered_at = numbers(i);
    [[maybe_unused]] const auto gathered = view[gathered_at];
    const void* const kept[] = {&i, &of_pack, &gathered, &gathered_at, this};
    stop(static_cast<const void* const*>(kept));
  }
};

template <class Entries>
auto neighbours() {
  using Ranges = elasticity::IncidenceRangeArray<float, Host, typename Entries::Layout>;
  const std::vector<std::vector<typename Entries::Value>> lists = {{{4, 0}, {2, 1}}, {}, {{3, 2}}};
  return RowArrays<Ranges, Entries>::from_lists({"element", 5}, lists);
}

int look() {
  auto aos = shapes<model::ShapesArray<float, Host, Aos>>();
  auto aos_padded = shapes<model::ShapesArray<float, Host, AosPadded>>();
  auto soa = shapes<model::ShapesArray<float, Host, Soa>>();
  auto soa_in_double = shapes<model::ShapesArray<double, Host, Soa>>();
  auto tiles_of_2 = shapes<model::ShapesArray<float, Host, Aosoa<2>>>();
  auto tiles_of_8 = shapes<model::ShapesArray<double, Host, Aosoa<8>>>();
  auto tiles_of_64 = shapes<model::ShapesArray<float, Host, Aosoa<64>>>();
  test::expect("aos", aos, 3);
  test::expect("aos_padded", aos_padded, 69);
  test::expect("soa", soa, 3);
  test::expect("soa_in_double", soa_in_double, 69);
  test::expect("tiles_of_2", tiles_of_2, 3);
  test::expect("tiles_of_8", tiles_of_8, 69);
  test::expect("tiles_of_64", tiles_of_64, 68);

  auto formats = stored<model::StoredArray<float>>();
  auto formats_in_double = stored<model::StoredArray<double, Host, AosPadded>>();
  test::expect("formats", formats, 13);
  test::expect("formats_in_double", formats_in_double, 5);

  Array<model::FrameObject, float, Host, Soa, Odd> odd(40);
  odd.view()[7].origin() = Eigen::Vector3f(300, 301, 299);
  odd.view()[7].weight() = 0.25F;
  test::expect("odd.view()[7].origin()", odd.view()[7].origin().get());
  model::OptionsArray<float, Host, Aos> aligned(3);  // records of a multiple of 32 bytes
  aligned.view()[2].density() = 7;
  test::expect("aligned[2].density()", 7.0F);
  tissue::other::PatchArray<float> nested(5);
  nested.view()[4].elements(1).shapes().F()(2, 1) = 6;
  nested.view()[4].elements(1).fibres(1).direction() = Eigen::Vector3f(1, 2, 3);
  test::expect("nested[4].elements(1).shapes().F()", nested.view().get(4).elements[1].shapes.F);
  test::expect("nested[4].elements(1).fibres(1).direction()", Eigen::Vector3f(1, 2, 3));
  model::MarksArray<float, Host, Aosoa<4>> marks(9);  // integers of 64 bits and bools
  marks[6].key() = 0xfedcba9876543211;
  marks[6].counts()(0, 1) = -0x123456789abcdef1;
  marks[6].turns()(2, 0) = 0x123456789abcdef1;
  marks[6].fixed() = Eigen::Matrix<bool, 3, 1>(true, false, true);
  marks[6].touches()(1, 0) = true;
  marks[6].flags(4) = true;
  marks[6].hashes()[1] = 7;
  test::expect("marks", marks, 6);
  test::expect("marks[6].key()", marks[6].key());
  test::expect("marks[6].alive()", marks[6].alive());
  test::expect("marks[6].touches()", marks[6].touches().get());
  const auto touches = marks.view()[6].touches();
  test::expect("touches", marks[6].touches().get());
  model::FrameArray<float> turned(9);
  turned.view()[5].turn() = Eigen::AngleAxisf(0.7F, Eigen::Vector3f(1, 2, 2) / 3).toRotationMatrix();
  test::expect("turned[5].turn()", turned.view()[5].turn().get());

  const auto view = soa.view();
  const auto read_only = tiles_of_2.const_view();
  const auto one = formats.view()[13];
  const auto part = formats.view()[13].stress();
  const auto number = formats.view()[13].load();
  const auto value = tiles_of_64.view().get(3);
  UniformArray<model::ShapesArray<float>> same(1000);
  same.contents().view()[0].a() = 0.5F;
  const auto uniform = same.view();
  test::expect("view", soa, 3);
  test::expect("read_only", tiles_of_2, 3);
  test::expect("one", formats.view().get(13));
  test::expect("part", formats.view()[13].stress().get());
  test::expect("number", formats.view()[13].load().get());
  test::expect("uniform[999].a()", 0.5F);

  const auto rows = neighbours<elasticity::IncidenceArray<float, Host, Aosoa<8>>>();
  const auto rows_view = rows.view();

  model::ShapesArray<float> empty, moved(7), stolen(7);
  const auto thief = std::move(stolen);
  model::ShapesArray<float> garbage;
  std::memset(static_cast<void*>(&garbage), 0xA5, sizeof garbage);
  const decltype(moved)::View null_view(nullptr, 30, 16);
  const decltype(soa)::View stray(reinterpret_cast<std::byte*>(std::uintptr_t{0x100}), 30, 32);
  const Eigen::Matrix<double, 2, 3> plain = (Eigen::Matrix<double, 2, 3>() << 1, 2, 3, 4, 5, 6).finished();
  const Eigen::VectorXf dynamic = Eigen::Vector3f(1, 2, 3);
  const PartialPack<8> partial{16, 2, 5};

  const void* const kept[] = {&aos,           &aos_padded, &soa,
                              &soa_in_double, &tiles_of_2, &tiles_of_8,
                              &tiles_of_64,   &formats,    &formats_in_double,
                              &odd,           &aligned,    &nested,
                              &turned,        &view,       &read_only,
                              &one,           &part,       &number,
                              &value,         &uniform,    &rows,
                              &rows_view,     &empty,      &moved,
                              &stolen,        &thief,      &garbage,
                              &null_view,     &stray,      &plain,
                              &dynamic,       &partial,    &same,
                              &marks,         &touches};
  std::fflush(stdout);
  stop(static_cast<const void* const*>(kept));
  const Inside<decltype(tiles_of_2)::ConstView> inside{tiles_of_2.const_view()};
  inside(Pack<native_lanes<float>>{0});
  new (&garbage) model::ShapesArray<float>;  // which is then destroyed
  return 0;
}

/// Pitch, padding and record of a layout for some numbers of objects, and addresses of elements.
template <class Layout>
void tell_law(const char* name) {
  for (const index_t objects : {0, 1, 31, 32, 33, 479, 480, 511, 512, 1000, 1024, 4096, 5000}) {
    for (const int content : {2, 4, 15, 30, 36, 612}) {
      for (const int alignment : {1, 2, 4, 8, 32}) {
        const int record = Layout::record_bytes(content, alignment);
        const typename Layout::Pitch pitch(Layout::pitch(objects));
        std::printf("%s %lld %d %d : %lld %lld %d", name, static_cast<long long>(objects), content, alignment,
                    static_cast<long long>(Layout::pitch(objects)), static_cast<long long>(Layout::padded(objects)),
                    record);
        for (index_t i = 0; i < objects; i += 1 + objects / 3) {
          std::printf(" %lld",
                      static_cast<long long>(law::element(index_t{256}, pitch, record, i, index_t{content - 2}, 2)));
        }
        std::puts("");
      }
    }
  }
}

}  // namespace

int main(int argc, char** /*argv*/) {
  if (argc == 1) return look();
  tell_law<Aos>("physgen::Aos");
  tell_law<AosPadded>("physgen::AosPadded");
  tell_law<Soa>("physgen::Soa");
  tell_law<Uniform>("physgen::Uniform");
  tell_law<Aosoa<2>>("physgen::Aosoa<2>");
  tell_law<Aosoa<4>>("physgen::Aosoa<4>");
  tell_law<Aosoa<32>>("physgen::Aosoa<32>");
  tell_law<Aosoa<1024>>("physgen::Aosoa<1024>");
  return 0;
}
