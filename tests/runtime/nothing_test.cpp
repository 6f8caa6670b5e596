// Fields of which nothing is stored: what is stored is as it was, stores to the rest write nowhere, and what would need
// it is refused. Compiled twice: also with PHYSGEN_CHECKED.
#include <fem/kernels/compute_svd.h>
#include <fem/kernels/stress_derivative.h>
#include <fem/materials/neo_hookean.h>
#include <physgen/parallel_for.h>

#include "nothing_checks.h"
#include "own_formats.h"

namespace physgen::test {
namespace {

// ---- Records --------------------------------------------------------------------------------------------------------

using elasticity::DeformationSvdObject;
using tissue::model::ElementObject;
using tissue::model::EntriesObject;
using tissue::model::OptionsObject;
using tissue::model::ShapesObject;
using tissue::other::PatchObject;

static_assert(is_sound_record<DeformationSvdObject, float, StretchesOnly>(12, 4, {0, 0, 0}));
static_assert(is_sound_record<DeformationSvdObject, double, StretchesOnly>(24, 8, {0, 0, 0}));
static_assert(is_sound_record<DeformationSvdObject, float, NoSvd>(0, 1, {0, 0, 0}));
static_assert(is_sound_record<OptionsObject, float, PartOfOptions>(40, 32, {0, 0, 4, 0, 16, 20, 28, 0}));
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
static_assert(Array<EntriesObject, float, Host, Soa, PartOfEntries>::record_bytes == 504 - 5 * 4 - 40 * 8);
static_assert(Array<ElementObject, float, Host, Soa, PartOfElement>::record_bytes < 376 - 8 - 24 - 8 - 4 - 36 - 24);
static_assert(Array<PatchObject, float, Host, Soa, PartOfPatch>::elements ==
              Array<PatchObject, float, Host, Soa>::elements);

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

/// Expects that of a poisoned array nothing but the stored elements of some objects has been written.
void expect_only_stored_elements_written(const Storage& storage, const std::vector<bool>& objects) {
  std::vector<bool> stored(static_cast<std::size_t>(storage.bytes()), false);
  for (index_t i = 0; i < storage.size; ++i) {
    if (!objects[static_cast<std::size_t>(i)]) continue;
    for (const FieldInfo& field : storage.fields) {
      const int size = element_bytes(field.type);
      for (int k = 0; k < field.count; ++k) {
        const index_t at = address_by_law(field.offset + k * size, i, storage.pitch, storage.record_bytes, size);
        for (int b = 0; b < size; ++b) stored[static_cast<std::size_t>(at + b)] = true;
      }
    }
  }
  for (index_t b = 0; b < storage.bytes(); ++b) {
    if (!stored[static_cast<std::size_t>(b)]) {
      ASSERT_EQ(storage.base[b], std::byte{0xA5}) << "byte " << b;
    }
  }
}

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
    expect_only_stored_elements_written(part.storage(), written);
    for (index_t i = 0; i < n; ++i) {
      if (!written[static_cast<std::size_t>(i)]) continue;
      for_each_element(part.storage(), [&](int k, const FieldInfo& field) {
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
    parallel_for(Host{}, begin, end, PutAll<decltype(from), decltype(to)>{from, to});
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

template <class Layout>
class NothingStored : public ::testing::Test {};
TYPED_TEST_SUITE(NothingStored, AllLayouts, LayoutName);

TYPED_TEST(NothingStored, is_what_stores_of_pruned_fields_write) {
  check_stores<DeformationSvdObject, float, TypeParam, StretchesOnly>(41);
  check_stores<DeformationSvdObject, double, TypeParam, StretchesOnly>(41);
  check_stores<DeformationSvdObject, float, TypeParam, NoSvd>(41);
  check_stores<EntriesObject, float, TypeParam, PartOfEntries>(41);
  check_stores<PatchObject, float, TypeParam, PartOfPatch>(41);
}

/// Every word that only writes.
template <class SvdView, class DerivativeView, class EntriesView>
struct StoreSomeFields {
  using Scalar = float;
  SvdView svds;
  DerivativeView derivatives;
  EntriesView entries;
  template <class I>
  void operator()(I i) const {
    using S = lanes_t<float, I>;
    const auto svd = svds[i];
    svd.U() = Eigen::Matrix<S, 3, 3>::Constant(S(4.0F));
    svd.U().setIdentity();
    svd.V()[5] = S(3.0F);
    svd.V()(1, 2) = S(2.0F);
    store_where(S(1.0F) > S(0.0F), svd.V(), Eigen::Matrix<S, 3, 3>::Constant(S(1.0F)));
    derivatives[i].x1111() = S(1e30F);
    store_where(S(1.0F) > S(0.0F), derivatives[i].x2222(), S(1e30F));
    entries[i].weights(2) = S(5.0F);
    svd.s() = Eigen::Matrix<S, 3, 1>::Constant(S(6.0F));
  }
};

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
    expect_only_stored_elements_written(derivatives.storage(), std::vector<bool>(77, false));
    expect_only_stored_elements_written(entries.storage(), std::vector<bool>(77, false));
    expect_only_stored_elements_written(svds.storage(), std::vector<bool>(77, true));
    for (int k = 18; k < 21; ++k) ASSERT_EQ(svds.getdata(76, k), 6);
    EXPECT_EQ(derivatives.take_losses().falsified(), 0U) << "1e30 would be no half, but is not stored as one";
  };
  check([](const auto& kernel) { parallel_for<1>(Host{}, 77, kernel); });
  check([](const auto& kernel) { parallel_for(Host{}, 77, kernel); });
}

// ---- Results --------------------------------------------------------------------------------------------------------

/// SVD, then stress derivative, of random deformation gradients.
template <class Real, class Layout, class Formats>
auto derivatives_through(const elasticity::DeformationGradientArray<Real, Host, Aos>& F, bool packs) {
  Array<DeformationSvdObject, Real, Host, Layout, Formats> svds(F.size());
  elasticity::StressDerivativeArray<Real, Host, Aos> derivatives(F.size());
  poison(derivatives);
  const auto model = fem::NeoHookean<Real>{Real(1e5), Real(4e5)};
  const fem::ComputeSvd decompose{F.const_view(), svds.view()};
  const fem::ComputeStressDerivative derive{model, svds.const_view(), derivatives.view()};
  if (packs) {
    parallel_for(Host{}, F.size(), decompose);
    parallel_for(Host{}, F.size(), derive);
  } else {
    parallel_for<1>(Host{}, F.size(), decompose);
    parallel_for<1>(Host{}, F.size(), derive);
  }
  return derivatives;
}

template <class Real, class Layout>
void check_results_with_pruned_rotations() {
  std::mt19937 random(seed());
  std::uniform_real_distribution<double> entry(-0.3, 0.3);
  elasticity::DeformationGradientArray<Real, Host, Aos> F(1003);
  for (index_t i = 0; i < F.size(); ++i) {
    for (int k = 0; k < 9; ++k) F.putdata(i, k, entry(random) + (k % 4 == 0 ? 1 : 0));
  }
  for (const bool packs : {false, true}) {
    const auto all = derivatives_through<Real, Layout, elasticity::DeformationSvdFormats<Host>>(F, packs);
    const auto part = derivatives_through<Real, Layout, StretchesOnly>(F, packs);
    EXPECT_EQ(count_different(all, part), 0) << (packs ? "packs" : "one by one");
    EXPECT_NE(all.getdata(0, 0), all.getdata(1, 0));
  }
}

TYPED_TEST(NothingStored, of_rotations_leaves_every_bit_of_stress_derivatives) {
  check_results_with_pruned_rotations<float, TypeParam>();
  check_results_with_pruned_rotations<double, TypeParam>();
}

// ---- Copies ---------------------------------------------------------------------------------------------------------

template <class Object, class Layout, class Formats, class Full>
void check_copies_of(std::mt19937& random) {
  for (const index_t n : {0, 1, 33, 100}) {
    check_copies<Object, float, Host, Layout, Formats, Full>(n, random);
    check_topology<Object, float, Host, Layout, Formats, Full>(n, random);
  }
}

/// PartOfDerivative, and what it prunes in any format.
struct FullDerivative : elasticity::StressDerivativeFormats<Host> {
  using x3311 = format::Float64;
  using x2222 = format::Snorm16<format::Interval{0, 4}>;
  using x3322 = format::Half<>;
};

TYPED_TEST(NothingStored, of_some_fields_copies_and_changes_of_topology_keep_the_others) {
  std::mt19937 random(seed());
  check_copies_of<DeformationSvdObject, TypeParam, StretchesOnly, elasticity::DeformationSvdFormats<Host>>(random);
  check_copies_of<elasticity::StressDerivativeObject, TypeParam, PartOfDerivative, FullDerivative>(random);
  check_copies_of<PatchObject, TypeParam, PartOfPatch, tissue::other::PatchFormats<Host>>(random);
  check_copies_of<EntriesObject, TypeParam, PartOfEntries, tissue::model::EntriesFormats<Host>>(random);
}

TYPED_TEST(NothingStored, is_what_copies_write_for_pruned_fields) {
  std::mt19937 random(seed());
  const auto check = [&](const auto& full, auto& part) {
    poison(part);
    copy_range(part.storage(), full.storage(), 5, 44);
    std::vector<bool> written(50, false);
    std::fill(written.begin() + 5, written.begin() + 44, true);
    expect_only_stored_elements_written(part.storage(), written);
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
  EXPECT_EQ(part.storage().fields[0].visible_count(), 9);
}

TYPED_TEST(NothingStored, of_any_field_there_are_objects_all_the_same) { check_only_pruned_fields<Host, TypeParam>(); }

TYPED_TEST(NothingStored, of_pruned_fields_mirrors_and_gathered_arrays_hold_the_rest) {
  check_mirror<Host, TypeParam>();
  check_gather<Host, TypeParam>();
}

TEST(Nothing, is_refused_where_its_field_is_needed) { check_refusals<Host>(); }

TEST(Nothing, leaves_initial_values_of_other_fields) {
  const Array<OptionsObject, float, Host, Soa, PartOfOptions> options(3);
  const Array<OptionsObject, float, Host, Aos> all(3);
  expect_part_of(options, all);
}

struct Own : elasticity::StressDerivativeFormats<Host> {
  using x1111 = Gone<field::x1111>;
  using x2211 = Thousandths;
};
struct OwnOfPruned : elasticity::StressDerivativeFormats<Host> {
  using x1111 = Thousandths;
  using x2211 = Thousandths;
};

TEST(Nothing, of_a_field_with_formats_of_a_programs_own_beside_it_is_copied_by_their_functions) {
  std::mt19937 random(seed());
  const auto full = random_objects<elasticity::StressDerivativeObject, float, OwnOfPruned>(77, random);
  Array<elasticity::StressDerivativeObject, float, Host, Soa, Own> part(77);
  copy(part, full);
  expect_part_of(part, full);
}

/// Names, of the object's fields and of the array, are in the message of an element that is not stored.
TEST(Nothing, has_no_elements_to_get_or_put) {
  Array<PatchObject, float, Host, Soa, PartOfPatch> patches(5);
  const std::string message = message_of([&] { (void)patches.getdata(2, 1); });
  EXPECT_EQ(message,
            "physgen: tissue::other::Patch[5] in host memory: element 1 cannot be read, but nothing is stored of "
            "elements[0].lame.mu: this array prunes it (format::Nothing or Pruned); take an array that stores it");
}

/// A hole in a record may be read by nobody, but it must not be there twice: what prunes only some entries of records
/// with other sizes keeps them sound in every layout.
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
