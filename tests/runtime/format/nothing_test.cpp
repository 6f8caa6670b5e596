// Fields of which nothing is stored: what is stored is as it was, stores to the rest write nowhere, and what would need
// it is refused. Compiled twice: also with PHYSGEN_CHECKED.
#include <physgen/parallel_for.h>
#include <physgen/row_arrays.h>

#include "in_packs.h"
#include "nothing_checks.h"
#include "nothing_kernels.h"
#include "precision_by_layout.h"

namespace physgen::test {
namespace {

using elasticity::DeformationSvdObject;
using tissue::model::ElementObject;
using tissue::model::EntriesObject;
using tissue::model::OptionsObject;
using tissue::model::ShapesObject;
using tissue::other::PatchObject;

// ---- Stores ---------------------------------------------------------------------------------------------------------

template <class From, class To>
struct PutAll {
  using Scalar = double;  // the widest that these objects have
  From from;
  To to;
  template <class I>
  void operator()(I i) const {
    to.put(i, from.get(i));
  }
};

/// Whole objects, stored one by one, in packs, in parts of packs and through gathered indices.
template <class Object, class Real, class Layout, class Formats>
void check_stores(index_t n) {
  std::mt19937 random(seed());
  Array<Object, Real, Host, Aos> full(n);
  randomise(full, random);
  Array<Object, Real, Host, Layout, Formats> part(n);
  const auto from = full.const_view();
  const auto to = part.view();
  const index_t begin = 3, end = n - 2;
  const auto check = [&](const auto& store) {
    poison(part);
    std::vector<bool> written(static_cast<std::size_t>(n), false);
    store(written);
    expect_only_stored_elements_written(part.untyped(), written);
    for (index_t i = 0; i < n; ++i) {
      if (!written[static_cast<std::size_t>(i)]) continue;
      for_each_element(part.untyped(), [&](int k, const FieldInfo& field) {
        if (field.is_stored()) {
          ASSERT_EQ(part.getdata(i, k), full.getdata(i, k)) << field.name << " of " << i;
        }
      });
    }
  };
  check([&](std::vector<bool>& written) {
    for (index_t i = begin; i < end; ++i) to.put(i, from.get(i));
    std::fill(written.begin() + begin, written.begin() + end, true);
  });
  check([&](std::vector<bool>& written) {
    parallel_for(Host{}, begin, end, in_packs(PutAll<decltype(from), decltype(to)>{from, to}));
    std::fill(written.begin() + begin, written.begin() + end, true);
  });
  check([&](std::vector<bool>& written) {
    using Indices = batch_t<std::int32_t, native_lanes<double>>;
    alignas(64) std::int32_t numbers[native_lanes<double>];
    for (std::size_t l = 0; l < Indices::size; ++l) {
      numbers[l] = static_cast<std::int32_t>((5 + 7 * l) % static_cast<std::size_t>(n));
      written[static_cast<std::size_t>(numbers[l])] = true;
    }
    const Indices j = Indices::load_aligned(numbers);
    to.put(j, from.get(j));
  });
}

/// What checks add is the same in all layouts; so two do for them, with one precision each.
using Layouts = std::conditional_t<checked_build, ::testing::Types<Soa, Aosoa<8>>, AllLayouts>;
template <class Layout>
class NothingStored : public ::testing::Test {};
TYPED_TEST_SUITE(NothingStored, Layouts, LayoutName);

TYPED_TEST(NothingStored, is_what_stores_of_pruned_fields_write) {
  check_stores<DeformationSvdObject, EvenReal<TypeParam>, TypeParam, StretchesOnly>(41);
  if constexpr (is_even<TypeParam>) {
    check_stores<PatchObject, float, TypeParam, PartOfPatch>(41);
  } else {
    check_stores<DeformationSvdObject, float, TypeParam, NoSvd>(41);
    check_stores<EntriesObject, float, TypeParam, PartOfEntries>(41);
    check_stores<elasticity::TetObject, float, TypeParam, NoNodes>(41);
  }
}

TYPED_TEST(NothingStored, is_what_single_elements_and_masked_stores_of_pruned_fields_write) {
  Array<DeformationSvdObject, float, Host, TypeParam, StretchesOnly> svds(77);
  Array<elasticity::StressDerivativeObject, float, Host, TypeParam, PartOfDerivative> derivatives(77);
  Array<EntriesObject, float, Host, TypeParam, PartOfEntries> entries(77);
  const auto check = [&](const auto& run) {
    poison(svds);
    poison(derivatives);
    poison(entries);
    run(StoreSomeFields<decltype(svds.view()), decltype(derivatives.view()), decltype(entries.view())>{
        svds.view(), derivatives.view(), entries.view()});
    expect_only_stored_elements_written(derivatives.untyped(), std::vector<bool>(77, false));
    expect_only_stored_elements_written(entries.untyped(), std::vector<bool>(77, false));
    expect_only_stored_elements_written(svds.untyped(), std::vector<bool>(77, true));
    for (int k = 18; k < 21; ++k) ASSERT_EQ(svds.getdata(76, k), 6);
    EXPECT_EQ(derivatives.take_losses().falsified(), 0U) << "1e30 would be no half, but is not stored as one";
  };
  check([](const auto& kernel) { parallel_for(Host{}, 77, lanes<1>(kernel)); });
  check([](const auto& kernel) { parallel_for(Host{}, 77, in_packs(kernel)); });
}

// ---- Results --------------------------------------------------------------------------------------------------------

TYPED_TEST(NothingStored, of_rotations_leaves_every_bit_of_stress_derivatives) {
  check_results_with_pruned_rotations<EvenReal<TypeParam>, Host, TypeParam>([](index_t n, const auto& kernel) {
    if constexpr (std::derived_from<TypeParam, Aos>) {
      parallel_for(Host{}, n, lanes<1>(kernel));
    } else {
      parallel_for(Host{}, n, in_packs(kernel));
    }
  });
}

// ---- Copies ---------------------------------------------------------------------------------------------------------

template <class Object, class Layout, class Formats, class Full>
void check_copies_of(std::mt19937& random) {
  for (const index_t n : {0, 1, 33, 100}) {
    check_copies<Object, float, Host, Layout, Formats, Full>(n, random);
    check_topology<Object, float, Host, Layout, Formats, Full>(n, random);
  }
}

TYPED_TEST(NothingStored, of_some_fields_copies_and_changes_of_topology_keep_the_others) {
  std::mt19937 random(seed());
  if constexpr (is_even<TypeParam>) {
    check_copies_of<DeformationSvdObject, TypeParam, StretchesOnly, elasticity::DeformationSvdFormats<Host>>(random);
    check_copies_of<PatchObject, TypeParam, PartOfPatch, tissue::other::PatchFormats<Host>>(random);
  } else {
    check_copies_of<elasticity::StressDerivativeObject, TypeParam, PartOfDerivative, FullDerivative>(random);
    check_copies_of<EntriesObject, TypeParam, PartOfEntries, tissue::model::EntriesFormats<Host>>(random);
  }
}

TYPED_TEST(NothingStored, is_what_copies_write_for_pruned_fields) {
  std::mt19937 random(seed());
  const auto check = [&](const auto& full, auto& part) {
    poison(part);
    copy_range(part.untyped(), full.untyped(), 5, 44);
    std::vector<bool> written(50, false);
    std::fill(written.begin() + 5, written.begin() + 44, true);
    expect_only_stored_elements_written(part.untyped(), written);
  };
  Array<PatchObject, float, Host, TypeParam> patches(50);
  Array<PatchObject, float, Host, TypeParam, PartOfPatch> parts(50);
  check(patches, parts);
  Array<PatchObject, double, Host, Aos> wide(50);
  check(wide, parts);
  Array<PatchObject, float, Host, Aosoa<16>, PartOfPatch> tiles(50);
  check(tiles, parts);
  (void)random;
}

struct Turned : elasticity::DeformationSvdFormats<Host> {
  using V = format::Quaternion<>;
};

/// Quaternions are fewer elements than code sees, and a rotation that is pruned is none of them.
TYPED_TEST(NothingStored, of_one_rotation_the_other_is_stored_as_a_quaternion) {
  std::mt19937 random(seed());
  elasticity::DeformationSvdArray<float, Host, Aos> svds(65);
  for (index_t i = 0; i < 65; ++i) {
    svds.view()[i].V() = random_rotation(random).cast<float>();
    svds.view()[i].U() = random_rotation(random).cast<float>();
  }
  Array<DeformationSvdObject, float, Host, Aos, Turned> full(65);
  copy(full, svds);
  Array<DeformationSvdObject, float, Host, TypeParam, RightOnly> part(65), from_full(65);
  static_assert(decltype(part)::elements == 21);
  copy(part, svds);
  copy(from_full, full);
  expect_part_of(part, full);
  expect_part_of(from_full, full);
  EXPECT_EQ(part.untyped().fields[0].visible_count(), 9);
}

TYPED_TEST(NothingStored, of_any_field_there_are_objects_all_the_same) { check_only_pruned_fields<Host, TypeParam>(); }

TYPED_TEST(NothingStored, of_pruned_fields_mirrors_and_gathered_arrays_hold_the_rest) {
  check_mirror<Host, TypeParam>();
  check_gather<Host, TypeParam>();
}

TEST(Nothing, is_refused_where_its_field_is_needed) { check_refusals<Host>(); }

template <class Formats>
using RowsOf =
    RowArrays<elasticity::IncidenceRangeArray<float>, Array<elasticity::IncidenceObject, float, Host, Soa, Formats>>;

TEST(Nothing, of_what_entries_of_rows_name_is_refused_and_of_the_rest_changes_no_row) {
  const std::vector<std::vector<elasticity::Incidence<float>>> lists{{{2, 7}, {1, 7}}, {}, {{0, 7}}};
  const std::string message = message_of([&] { (void)RowsOf<NoElement>::from_lists({"element", 3}, lists); });
  EXPECT_NE(message.find("its indices are needed, but nothing is stored of element: "), std::string::npos) << message;
  auto rows = RowsOf<ElementOnly>::from_lists({"element", 3}, lists);
  rows.renumber(std::vector<index_t>{1, 0, 2}, 3);
  rows.permute(std::vector<index_t>{2, 0, 1});
  EXPECT_EQ(rows.entries().getdata(0, 0), 1);
  EXPECT_EQ(rows.entries().getdata(1, 0), 2);
  EXPECT_EQ(rows.entries().getdata(2, 0), 0);
  EXPECT_THROW((void)rows.entries().getdata(2, 1), Error);
}

TEST(Nothing, leaves_initial_values_of_other_fields) {
  const Array<OptionsObject, float, Host, Soa, PartOfOptions> options(3);
  const Array<OptionsObject, float, Host, Aos> all(3);
  expect_part_of(options, all);
}

TEST(Nothing, of_a_field_with_formats_of_a_programs_own_beside_it_is_copied_by_their_functions) {
  std::mt19937 random(seed());
  const auto full = random_objects<elasticity::StressDerivativeObject, float, OwnOfAll>(77, random);
  Array<elasticity::StressDerivativeObject, float, Host, Soa, OwnOfPart> part(77);
  copy(part, full);
  expect_part_of(part, full);
}

/// Names, of the object's fields and of the array, are in the message of an element that is not stored.
TEST(Nothing, has_no_elements_to_get_or_put) {
  Array<PatchObject, float, Host, Soa, PartOfPatch> patches(5);
  const std::string message = message_of([&] { (void)patches.getdata(2, 0); });
  EXPECT_EQ(message,
            "physgen: tissue::other::Patch[5] in host memory: element 0 cannot be read, but nothing is stored of "
            "elements[0].flag: this array prunes it (format::Nothing or Pruned); take an array that stores it");
}

/// Which index has no new number is said by its place among all elements, stored or not.
TEST(Nothing, of_fields_before_indices_leaves_the_numbers_of_their_elements) {
  Array<OptionsObject, float, Host, Soa, IndicesOfOptions> options(5);
  static_assert(decltype(options)::record_bytes == 12);
  for (index_t i = 0; i < 5; ++i) options.view()[i].label() = static_cast<std::int32_t>(4 - i);
  const int k = 1 + 1 + 3 + 6;  // behind density, nu, direction and metric
  EXPECT_EQ(options.getdata(3, k), 1);
  options.putdata(3, k, 77);
  const std::string message = message_of([&] { renumber(options, "label", remaining(5, {})); });
  EXPECT_NE(message.find("object 3 has the index 77 as element 0 of 1"), std::string::npos) << message;
}

#ifdef PHYSGEN_CHECKED
TEST(CheckedNothing, counts_losses_of_stored_fields_only) {
  Array<elasticity::StressDerivativeObject, float, Host, Soa, PartOfDerivative> derivatives(5);
  derivatives.view()[3].x1111() = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(derivatives.take_losses().falsified(), 0U);
  derivatives.view()[3].x3322() = 1e30F;
  EXPECT_EQ(derivatives.take_losses().out_of_range, 1U);
}

TEST(CheckedNothing, is_of_an_object_that_there_is) {
  Array<DeformationSvdObject, float, Host, Soa, NoSvd> empty(5);
  EXPECT_NO_THROW(empty.view()[4].U().setIdentity());
  EXPECT_EQ(message_of([&] { empty.view()[5].U().setIdentity(); }),
            "physgen: elasticity::DeformationSvd: object 5 of an array of 5");
  const Array<DeformationSvdObject, float, Host, Soa, NoSvd>::View by_hand(nullptr, 5, 32);
  EXPECT_NO_THROW(by_hand[4].U().setIdentity()) << "no bytes need no memory";
}
#endif

}  // namespace
}  // namespace physgen::test
