// Arrays saved to files and loaded into other layouts and formats, held against direct copies, bit by bit; and files
// and arrays that do not fit each other.
#include <everything.physgen.h>
#include <physgen/save.h>

#include <atomic>
#include <fstream>
#include <functional>

#include "saved_files.h"
#include "stored_records.h"

namespace physgen::test {
namespace {

using namespace elasticity;

struct CompactTurns : DeformationSvdFormats<Host> {
  using U = format::Quaternion<format::Half<>>;
  using V = format::Quaternion16;
  using s = format::Bfloat16;
};
struct ScaledDerivative : StressDerivativeFormats<Host> {
  using x1111 = format::Scaled<format::Float32, format::Affine{.scale = 1000}>;
  using x2211 = format::Scaled<format::Half<>, format::Affine{.scale = 1, .centre = 300}>;
};
struct PrunedDerivative : StressDerivativeFormats<Host> {
  using x2211 = format::Pruned<void, void, void>;
};
/// A format of a program's own: tenths.
struct Tenths {
  static constexpr const char* name = "tenths";
  template <class Real>
  using Stored = std::int16_t;
  template <class Real>
  static constexpr ElementType type = ElementType::snorm16;
  static constexpr double scale = 1, centre = 0;
  template <class Real>
  static Real decode(std::int16_t stored) {
    return static_cast<Real>(stored) / 10;
  }
  template <class Real>
  static std::int16_t encode(Real value) {
    return static_cast<std::int16_t>(std::lround(value * 10));
  }
};
struct OwnDerivative : StressDerivativeFormats<Host> {
  using x1111 = Tenths;
};

/// What is loaded into B from what A saved has the bits of a copy.
template <class A, class B>
void expect_copy_by_file(const std::filesystem::path& file, index_t n, std::mt19937& random) {
  A a(n);
  copy(a, random_objects<typename A::Object>(n, random));
  save(file, {{"other", a}, {"objects", a}});
  B expected(n), loaded(static_cast<index_t>(random() % 70));
  poison(loaded);
  copy(expected, a);
  const Loaded result = load(file, "objects", loaded);
  EXPECT_TRUE(result.complete()) << result.text();
  expect_records(loaded.untyped(), records_of(expected.untyped()), "saving and loading " + std::to_string(n));
}
template <class A, class B>
void expect_copies_by_file() {
  const Folder folder;
  std::mt19937 random(seed());
  for (const index_t n : {0, 33, 2049}) expect_copy_by_file<A, B>(folder / "a.h5", n, random);
}

TEST(SavedArrays, come_back_in_every_layout) {
  using Object = StressDerivativeObject;
  expect_copies_by_file<Array<Object, float, Host, Aos>, Array<Object, float, Host, Soa>>();
  expect_copies_by_file<Array<Object, float, Host, Soa>, Array<Object, float, Host, Aosoa<8>>>();
  expect_copies_by_file<Array<Object, float, Host, Aosoa<64>>, Array<Object, double, Host, AosPadded>>();
  expect_copies_by_file<Array<Object, double, Host, AosPadded>, Array<Object, float, Host, Aos>>();
}
TEST(SavedArrays, come_back_in_every_format) {
  using Svd = DeformationSvdObject;
  using Derivative = StressDerivativeObject;
  expect_copies_by_file<Array<Svd, float, Host, Soa, CompactTurns>, Array<Svd, float, Host, Aos, CompactTurns>>();
  expect_copies_by_file<Array<Svd, float, Host, Aos>, Array<Svd, float, Host, Aosoa<4>, CompactTurns>>();
  expect_copies_by_file<Array<Svd, float, Host, Aosoa<4>, CompactTurns>, Array<Svd, double, Host, Soa>>();
  expect_copies_by_file<Array<Derivative, float, Host, Aos, MixedDerivative>,
                        Array<Derivative, double, Host, Soa, ScaledDerivative>>();
  expect_copies_by_file<Array<Derivative, float, Host, Aos, ScaledDerivative>,
                        Array<Derivative, float, Host, Soa, MixedDerivative>>();
  expect_copies_by_file<Array<Derivative, float, Host, Soa, OwnDerivative>,
                        Array<Derivative, float, Host, Aos, OwnDerivative>>();
}
TEST(SavedArrays, come_back_with_nested_objects_indices_and_every_shape) {
  using Shapes = tissue::model::ShapesObject;
  using Patch = tissue::other::PatchObject;
  using Marks = tissue::model::MarksObject;
  expect_copies_by_file<Array<Marks, float, Host, Soa>, Array<Marks, float, Host, Aosoa<4>>>();
  expect_copies_by_file<Array<Shapes, float, Host, Aos>, Array<Shapes, double, Host, Soa>>();
  expect_copies_by_file<Array<Patch, float, Host, Aosoa<32>>, Array<Patch, float, Host, AosPadded>>();
  expect_copies_by_file<Array<TetObject, float, Host, Soa>, Array<TetObject, float, Host, Aosoa<4>>>();
}

using Derivatives = Array<StressDerivativeObject, float, Host, Soa>;
using Pruned = Array<StressDerivativeObject, float, Host, Aos, PrunedDerivative>;

Derivatives derivatives(index_t n, unsigned more = 0) {
  std::mt19937 random(seed() + more);
  Derivatives a(n);
  copy(a, random_objects<StressDerivativeObject>(n, random));
  return a;
}
template <class A>
std::string refusal(const std::filesystem::path& file, const std::string& name, A& array) {
  const Records before = records_of(array.untyped());
  const std::string message = message_of([&] { load(file, name, array); });
  expect_records(array.untyped(), before, "a load that is refused");
  return message;
}

TEST(SavedArrays, give_single_fields_and_leave_the_others_as_they_are) {
  const Folder folder;
  const Derivatives saved = derivatives(100);
  save(folder / "a.h5", {{"a", saved}});
  Derivatives array = derivatives(100, 1);
  const Derivatives before = array;
  EXPECT_TRUE(load(folder / "a.h5", "a", array, {"x2211"}).complete());
  for (index_t i = 0; i < 100; ++i) {
    EXPECT_EQ(array.getdata(i, 1), saved.getdata(i, 1));
    EXPECT_EQ(array.getdata(i, 2), before.getdata(i, 2));
  }
  const std::string message = message_of([&] { load(folder / "a.h5", "a", array, {"x2212"}); });
  EXPECT_NE(message.find("has no field 'x2212'; it has 'x2"), std::string::npos) << message;
}

TEST(SavedArrays, of_another_schema_give_the_fields_that_both_have_and_name_the_others) {
  const Folder folder;
  const Derivatives all = derivatives(40);
  save(folder / "all.h5", {{"a", all}});
  Pruned fewer;
  const Loaded less = load(folder / "all.h5", "a", fewer);
  EXPECT_EQ(less.left_out, std::vector<std::string>{"x2211"});
  EXPECT_TRUE(less.kept.empty());
  EXPECT_EQ(fewer.getdata(39, 2), all.getdata(39, 2));

  save(folder / "fewer.h5", {{"a", fewer}});
  Derivatives again = derivatives(30, 1);
  const Derivatives before = again;
  const Loaded more = load(folder / "fewer.h5", "a", again);
  EXPECT_EQ(more.kept, std::vector<std::string>{"x2211"});
  EXPECT_NE(more.text().find("not in the file, so that it keeps its values: 'x2211'"), std::string::npos);
  ASSERT_EQ(again.size(), 40);
  EXPECT_EQ(again.getdata(29, 1), before.getdata(29, 1));
  EXPECT_EQ(again.getdata(39, 1), 0);
  EXPECT_EQ(again.getdata(39, 2), all.getdata(39, 2));
}

TEST(SavedArrays, that_do_not_fit_are_refused_with_names_and_sizes) {
  const Folder folder;
  const std::filesystem::path file = folder / "a.h5";
  const Array<HalvesObject<3>, float, Host, Aos> threes(5);
  save(file, {{"threes", threes}, {"stress", derivatives(5)}});
  Derivatives array = derivatives(7);
  EXPECT_EQ(refusal(file, "tress", array),
            "physgen: " + file.string() + ": has no array 'tress'; it has 'stress', 'threes'");
  EXPECT_EQ(
      refusal(file, "threes", array),
      "physgen: " + file.string() +
          ": 'threes' holds objects of the type test::Halves, and the array those of elasticity::StressDerivative; "
          "load it into an array of test::Halves");
  Array<HalvesObject<1>, float, Host, Soa> ones(5);
  EXPECT_NE(refusal(file, "threes", ones).find("h has 3 elements in the file and 1 element in the array"),
            std::string::npos);
  UntypedArray form = array.untyped();
  std::vector<FieldInfo> fields(form.fields.begin(), form.fields.end());
  form.fields = fields;
  fields[1].unit = "MPa";
  EXPECT_NE(message_of([&] {
              detail::ArrayOfFile(file, "stress", form, {});
            }).find("x2211 has the unit Pa in the file and the unit MPa in the array"),
            std::string::npos);
  fields[1].type = ElementType::int32;
  EXPECT_NE(message_of([&] {
              detail::ArrayOfFile(file, "stress", form, {});
            }).find("x2211 has real numbers in the file and integers in the array"),
            std::string::npos);
  fields[1].type = ElementType::boolean;
  EXPECT_NE(message_of([&] {
              detail::ArrayOfFile(file, "stress", form, {});
            }).find("x2211 has real numbers in the file and bool in the array"),
            std::string::npos);
}

TEST(SavedArrays, with_a_value_that_a_format_cannot_hold_are_refused_with_field_and_object_in_checked_programs) {
  const Folder folder;
  Derivatives saved(30000);  // several blocks
  for (const index_t i : {29999, 29000}) saved.putdata(i, 0, 1e6);
  save(folder / "a.h5", {{"a", saved}});
  Array<StressDerivativeObject, float, Host, Aos, MixedDerivative> array(30000);
  array.putdata(29000, 0, 3);
  const Records before = records_of(array.untyped());
  const detail::ArrayOfFile read(folder / "a.h5", "a", array.untyped(), {});
  const std::string message = message_of([&] { read.give(array.untyped(), detail::Target::in_use, true); });
  EXPECT_NE(message.find("cannot hold 2 values (2 out of range"), std::string::npos) << message;
  EXPECT_NE(message.find("the first is 1e+06 Pa in x1111 of object 29000"), std::string::npos) << message;
  expect_records(array.untyped(), before, "a load that is refused");
}

/// A format of a program's own that calls what a test wants, once, when its first number is loaded.
struct Watched : Tenths {
  inline static std::function<void()> at_first;
  inline static std::atomic<bool> called = true;
  template <class Real>
  static std::int16_t encode(Real value) {
    if (!called.exchange(true)) at_first();
    return Tenths::encode(value);
  }
};
struct WatchedDerivative : StressDerivativeFormats<Host> {
  using x1111 = Watched;
};

/// The Error of a load into an array that is in use, when change(file) was called while the file was read again.
std::string second_reading(const std::filesystem::path& file, const std::function<void()>& change) {
  Array<StressDerivativeObject, float, Host, Soa, WatchedDerivative> array(50);
  Watched::at_first = change;
  Watched::called = false;
  const detail::ArrayOfFile read(file, "a", array.untyped(), {});
  return message_of([&] { read.give(array.untyped(), detail::Target::in_use, false); });
}

TEST(SavedArrays, say_that_an_array_holds_a_part_where_the_file_changes_between_two_readings) {
  const Folder folder;
  const std::filesystem::path file = folder / "a.h5";
  const Derivatives saved = derivatives(50);
  save(file, {{"a", saved}});
  const std::string bytes = bytes_of_file(file);
  const std::string element(reinterpret_cast<const char*>(&saved.view()[49].x3223()), sizeof(float));
  EXPECT_EQ(second_reading(
                file,
                [&] {
                  std::fstream out(file, std::ios::binary | std::ios::in | std::ios::out);
                  out.seekp(static_cast<std::streamoff>(bytes.find(element))).put(static_cast<char>(element[0] ^ 1));
                }),
            "physgen: " + file.string() +
                ": 'a' /a/x3223 was changed while it was loaded, and the array holds a part of it: load it again");
  write_file(file, bytes);
  EXPECT_EQ(second_reading(file, [&] { std::filesystem::resize_file(file, 0); }),
            "physgen: " + file.string() +
                ": 'a' could not be read again, and the array holds a part of it: load it again (physgen: " +
                file.string() + ": cannot read /a/x2211: the file ends before it)");
}

TEST(SavedArrays, give_an_array_of_another_size_memory_for_as_many_objects) {
  const Folder folder;
  save(folder / "a.h5", {{"a", derivatives(40)}});
  for (const index_t n : {0, 10, 5000}) {
    Derivatives array = derivatives(n, 1);
    load(folder / "a.h5", "a", array);
    EXPECT_EQ(array.bytes(), Derivatives(40).bytes()) << n;
  }
}

TEST(SavedArrays, need_names_of_their_own) {
  const Folder folder;
  const Derivatives a = derivatives(3);
  EXPECT_NE(message_of([&] { save(folder / "a.h5", {{"a", a}, {"a", a}}); }).find("two arrays have the name 'a'"),
            std::string::npos);
  for (const char* name : {"", ".", "a/b"}) {
    EXPECT_NE(message_of([&] { save(folder / "a.h5", {{name, a}}); }).find("cannot be the name of"), std::string::npos);
  }
  EXPECT_TRUE(folder.names().empty());
}

}  // namespace
}  // namespace physgen::test
