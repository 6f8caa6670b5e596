// Records of objects of which some fields, or all, are not stored: the others have bytes of their own, and numbers as
// if all were.
#include <gtest/gtest.h>
#include <physgen/arrays/array.h>

#include "nothing_formats.h"

namespace physgen::test {
namespace {

using elasticity::DeformationSvdObject;
using tissue::model::ElementObject;
using tissue::model::EntriesObject;
using tissue::model::OptionsObject;
using tissue::model::ShapesObject;
using tissue::other::PatchObject;

static_assert(is_sound_record<DeformationSvdObject, float, StretchesOnly>(12, 4, {0, 0, 0}));
static_assert(is_sound_record<DeformationSvdObject, double, StretchesOnly>(24, 8, {0, 0, 0}));
static_assert(is_sound_record<DeformationSvdObject, float, NoSvd>(0, 1, {0, 0, 0}));
static_assert(is_sound_record<OptionsObject, float, PartOfOptions>(36, 32, {0, 0, 4, 0, 0, 16, 24, 0}));
static_assert(is_sound_record<elasticity::TetObject, float, NoNodes>(0, 1, {0}));
static_assert(!is_sound_record<DeformationSvdObject, float, StretchesOnly>(84, 4, {0, 0, 0}), "bytes of all fields");
static_assert(!is_sound_record<DeformationSvdObject, float, NoSvd>(0, 4, {0, 0, 0}), "another alignment");
static_assert(!is_sound_record<DeformationSvdObject, float, StretchesOnly>(12, 4, {0, 36, 0}), "another offset");

// Whether the record of an array is that of its stored fields alone, since there are no holes in this object's.
template <class Object, class Formats>
constexpr int bytes_of_fields() {
  int bytes = 0;
  for (const FieldInfo& field : Object::template fields<float, Formats>)
    bytes += field.count * element_bytes(field.type);
  return bytes;
}
static_assert(Array<EntriesObject, float, Host, Soa, PartOfEntries>::record_bytes ==
              bytes_of_fields<EntriesObject, PartOfEntries>());
static_assert(Array<EntriesObject, float, Host, Soa, PartOfEntries>::record_bytes == 504 - 5 * 4 - 3 * 4 - 40 * 8);
static_assert(Array<ElementObject, float, Host, Soa, PartOfElement>::record_bytes <
              376 - 4 - 8 - 24 - 8 - 4 - 16 - 36 - 24);
static_assert(Array<PatchObject, float, Host, Soa, PartOfPatch>::elements ==
              Array<PatchObject, float, Host, Soa>::elements);

template <class Formats, class Object>
void expect_elements_of_their_own(const Object& /*object*/) {
  const auto& fields = Object::template fields<float, Formats>;
  using Record = typename Object::template Record<float, Formats>;
  std::vector<int> owners(static_cast<std::size_t>(Record::bytes), 0);
  for (const FieldInfo& field : fields) {
    const int size = element_bytes(field.type);
    if (size > 0) {
      EXPECT_EQ(field.offset % size, 0) << field.name;
    }
    EXPECT_LE(field.offset + field.count * size, Record::bytes) << field.name;
    for (int b = 0; b < field.count * size; ++b) ++owners[static_cast<std::size_t>(field.offset + b)];
  }
  for (const int owner : owners) EXPECT_LE(owner, 1);
}
TEST(Nothing, leaves_the_elements_of_other_fields_bytes_of_their_own) {
  expect_elements_of_their_own<PartOfPatch>(PatchObject{});
  expect_elements_of_their_own<PartOfElement>(ElementObject{});
  expect_elements_of_their_own<PartOfEntries>(EntriesObject{});
  expect_elements_of_their_own<PartOfOptions>(OptionsObject{});
  expect_elements_of_their_own<PartOfShapes>(ShapesObject{});
  expect_elements_of_their_own<PartOfDerivative>(elasticity::StressDerivativeObject{});
}

}  // namespace
}  // namespace physgen::test
