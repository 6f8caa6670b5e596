// Probes of each word that reads or stores, and of the formats that they stand for.
#include <everything.physgen.h>
#include <quasistatic.physgen.h>

#include "probe_checks.h"

namespace physgen {
namespace {

using namespace test;

template <class View>
struct TakesAddresses {
  View view;
  void operator()(index_t i) const {
    __atomic_fetch_add(&view[i].arrived(), 1, __ATOMIC_RELAXED);
    view[i].children() += 1;
    view[i].scale() = 1.0F;
  }
};
template <class View>
TakesAddresses(View) -> TakesAddresses<View>;
template <class View>
struct ReadsByAddress {
  View view;
  void operator()(index_t i) const {
    const float* first = &view[i].s()[0];
    EXPECT_EQ(*first, 0);
  }
};
template <class View>
ReadsByAddress(View) -> ReadsByAddress<View>;

PHYSGEN_TEST_ARRAY(blocks);
PHYSGEN_TEST_ARRAY(read_only);
TEST(Probes, take_addresses_for_reading_and_writing_and_say_so) {
  ProbeOf<quasistatic::SchwarzBlockArray<float>, blocks> array;
  Svds<read_only> svds;
  Perform()(TakesAddresses{array.view()});
  Perform()(ReadsByAddress{svds.const_view()});
  EXPECT_EQ(fields_of("blocks"), (Fields{"arrived RW&", "children RW", "scale W"}));
  EXPECT_EQ(fields_of("read_only"), Fields{"s R&"});
}

template <class View>
struct Conditional {
  using Scalar = float;
  View view;
  template <class I>
  void operator()(I i) const {
    using S = lanes_t<float, I>;
    const S one(1.0F);
    store_where(S(view[i].x1111()) > one, view[i].x2222(), one);
    add(i, view[i].x3333(), one);
    swap(view[i].x2121(), view[i].x2112());
  }
};
template <class View>
Conditional(View) -> Conditional<View>;

PHYSGEN_TEST_ARRAY(words);
TEST(Probes, know_every_word_that_stores) {
  Derivatives<words> derivatives;
  ProbeExecutor<Host>().run(1, Conditional{derivatives.view()});
  EXPECT_EQ(fields_of("words"), (Fields{"x1111 R", "x2112 RW", "x2121 RW", "x2222 W", "x3333 RW"}));
}

struct StoredCompact : elasticity::DeformationSvdFormats<Host> {
  using U = format::Quaternion<format::Half<>>;
  using V = format::Quaternion16;
  using s = format::Half<3>;
};
template <class View>
struct Turns {
  using Scalar = float;
  View view;
  template <class I>
  void operator()(I i) const {
    view[i].U() = view[i].V().get();
    view[i].s()[1] = lanes_t<float, I>(view[i].s()[0]);
  }
};
template <class View>
Turns(View) -> Turns<View>;

PHYSGEN_TEST_ARRAY(compact);
TEST(Probes, keep_the_formats_that_they_stand_for) {
  using Compact = elasticity::DeformationSvdArray<float, Host, Soa, StoredCompact>;
  using Probes = ProbeOf<Compact, compact>;
  Probes svds;
  ProbeExecutor<Host>().run(1, Turns{svds.view()});
  EXPECT_EQ(fields_of("compact"), (Fields{"U W", "V R", "s RW"}));
  static_assert(Probes::View::record_bytes == Compact::View::record_bytes);
  static_assert(Probes::View::Record::U::offset == Compact::View::Record::U::offset);
  static_assert(format::is_quaternion<Probes::Formats::U>);
  static_assert(Probes::Formats::s::scale == 8 && Probes::Formats::s::type<float> == ElementType::half);
  constexpr auto probed = elasticity::DeformationSvdObject::fields<float, Probes::Formats>;
  constexpr auto plain = elasticity::DeformationSvdObject::fields<float, StoredCompact>;
  for (std::size_t f = 0; f < plain.size(); ++f) {
    EXPECT_EQ(probed[f].offset, plain[f].offset);
    EXPECT_EQ(probed[f].count, plain[f].count);
    EXPECT_EQ(probed[f].type, plain[f].type);
  }
}

TEST(Probes, of_indices_are_formats_of_indices) {
  using Nodes = elasticity::TetProbe<words>::nodes;
  static_assert(format::is_probe<Nodes> && format::holds_indices<Nodes> && format::holds_indices<format::Native>);
  static_assert(!format::holds_indices<format::Float32> && !format::holds_indices<format::Half<>>);
  static_assert(format::are_probes<elasticity::TetProbe<words>>);
  static_assert(!format::are_probes<elasticity::TetFormats<Host>>);
}

template <class View>
struct Nested {
  View view;
  void operator()(index_t i) const {
    view[i].frame().turn() = view[i].frames(1).turn().get();
    view[i].frames(0).weight() = 2.0F;
    view[i].count() = 1;
  }
};
template <class View>
Nested(View) -> Nested<View>;

PHYSGEN_TEST_ARRAY(nested);
TEST(Probes, tell_fields_of_nested_objects_apart_but_not_entries_of_a_fixed_array) {
  ProbeOf<tissue::model::StoredArray<float>, nested> array;
  Perform()(Nested{array.view()});
  EXPECT_EQ(fields_of("nested"), (Fields{"count W", "frame.turn W", "frames.turn R", "frames.weight W"}));
}

// Every number that generated code gives a probe is that of the field of this name.
TEST(Probes, have_the_numbers_of_the_list_of_fields) {
  using Object = tissue::model::StoredObject;
  constexpr auto fields = Object::fields<float, tissue::model::StoredFormats<Host>>;
  const auto number_of =
      []<class Tag, class Of, int number, class Base>(std::type_identity<Probe<Tag, Of, number, Base>>) {
        static_assert(std::is_same_v<Of, Object>);
        return static_cast<std::size_t>(number);
      };
  using Probes = tissue::model::StoredProbe<nested>;
  EXPECT_EQ(fields[number_of(std::type_identity<Probes::single>())].name, "single");
  EXPECT_EQ(fields[number_of(std::type_identity<Probes::many>())].name, "many");
  EXPECT_EQ(fields[number_of(std::type_identity<Probes::count>())].name, "count");
  EXPECT_EQ(fields[number_of(std::type_identity<Probes::frame::turn>())].name, "frame.turn");
  EXPECT_EQ(fields[number_of(std::type_identity<Probes::frames::weight>())].name, "frames[0].weight");
  EXPECT_EQ(number_of(std::type_identity<Probes::frames::weight>()) + 4, fields.size()) << "and three of frames[1]";
}

}  // namespace
}  // namespace physgen
