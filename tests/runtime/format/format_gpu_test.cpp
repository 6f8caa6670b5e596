// Storage formats and layouts in CUDA memory: every conversion on the device, and between host and device.
#include <physgen/gather.h>

#include "format_checks.h"
#include "gpu_fixture.h"

namespace physgen::test {
namespace {

template <class Layout>
class CudaFormatsOver : public GpuTest {};
TYPED_TEST_SUITE(CudaFormatsOver, AllLayouts, LayoutName);

TYPED_TEST(CudaFormatsOver, objects_of_mixed_sizes_come_back_within_the_errors_of_their_formats) {
  for (const index_t n : {0, 1, 31, 33, 1000, 300000}) check_mixed_round_trip<Cuda, TypeParam>(n);
}

TYPED_TEST(CudaFormatsOver, pinned_memory_round_trips_as_well) { check_mixed_round_trip<PinnedHost, TypeParam>(70001); }

TYPED_TEST(CudaFormatsOver, rotations_come_back_from_quaternions) {
  check_rotations<Cuda, TypeParam, format::Native>(1025, 1.2e-6);  // what format/quaternion.h states
  check_rotations<Cuda, TypeParam, format::Half<>>(1025, 2e-3);
  check_rotations<Cuda, TypeParam, format::Snorm16<format::Interval{-1.0, 1.0}>>(1025, 9e-5);
}

/// Device and host convert alike, bit by bit, between any two layouts and formats.
template <class To, class From, class ToFormats, class FromFormats>
void check_against_host(index_t n) {
  using Object = elasticity::StressDerivativeObject;
  std::mt19937 random(seed());
  std::uniform_real_distribution<float> value(-2.0F, 2.0F);
  Array<Object, float, Host, From, FromFormats> from(n);
  for (index_t i = 0; i < n; ++i) {
    for (int k = 0; k < from.elements; ++k) from.putdata(i, k, value(random));
  }
  Array<Object, float, Host, To, ToFormats> expected(n), result(n);
  copy(expected, from);
  Array<Object, float, Cuda, From, FromFormats> from_there(n);
  Array<Object, float, Cuda, To, ToFormats> to_there(n);
  copy(from_there, from);
  copy(to_there, from_there);
  poison(result);
  copy(result, to_there);
  synchronize();
  Array<Object, float, Host, Aos, ToFormats> a(n), b(n);
  copy(a, expected);
  copy(b, result);
  EXPECT_EQ(count_different(a, b), 0) << n;
}

TYPED_TEST(CudaFormatsOver, the_device_converts_as_the_host_does) {
  using Plain = elasticity::StressDerivativeFormats<Cuda>;
  for (const index_t n : {1, 100, 5000}) {
    check_against_host<TypeParam, Aos, Plain, Plain>(n);
    check_against_host<TypeParam, AosPadded, Plain, Plain>(n);
    check_against_host<TypeParam, Soa, Plain, Plain>(n);
    check_against_host<TypeParam, Aosoa<32>, Plain, Plain>(n);
    check_against_host<TypeParam, Aos, MixedDerivative, Plain>(n);
    check_against_host<TypeParam, Aosoa<32>, MixedDerivative, Plain>(n);
    check_against_host<TypeParam, Aos, Plain, MixedDerivative>(n);
    check_against_host<TypeParam, Aos, MixedDerivative, MixedDerivative>(n);
  }
}

TYPED_TEST(CudaFormatsOver, ranges_of_objects_convert_alone) {
  using Object = elasticity::StressDerivativeObject;
  constexpr index_t n = 3000;
  std::mt19937 random(seed());
  for (const auto& [begin, end] : {std::pair<index_t, index_t>{0, 1}, {1, 40}, {31, 2999}, {1000, 3000}}) {
    elasticity::StressDerivativeArray<float, Host, Aos> from(n), back(n);
    randomise(from, random);
    Array<Object, double, Cuda, TypeParam> there(n);
    copy_range(there.untyped(), from.untyped(), begin, end);
    copy(back, there);
    synchronize();
    for (index_t i = 0; i < n; ++i) {
      const double expected = i >= begin && i < end ? from.getdata(i, 5) : 0;
      ASSERT_EQ(back.getdata(i, 5), expected) << i << " of " << begin << " to " << end;
    }
  }
}

/// Other objects go the same way in between: what the first have left in pinned memory is not there any more.
TYPED_TEST(CudaFormatsOver, objects_gathered_from_pointers_come_back_scattered_whatever_their_number) {
  std::mt19937 random(seed());
  std::uniform_real_distribution<float> value(-2.0F, 2.0F);
  using Value = elasticity::StressDerivative<float>;
  for (const std::size_t n : {0, 1, 31, 32, 33, 64, 1000, 400001}) {
    std::vector<Value> objects(n), back(n);
    std::vector<Value*> pointers, back_pointers;
    for (std::size_t i = 0; i < n; ++i) {
      objects[i].x1111 = value(random);
      objects[i].x3223 = value(random);
      pointers.push_back(&objects[i]);
      back_pointers.push_back(&back[i]);
    }
    elasticity::StressDerivativeArray<float, Cuda, TypeParam> array, others;
    gather(array, std::span<Value* const>(pointers), [](const Value& object) { return object; });
    gather_by(others, 2000, [](index_t) { return Value{}; });
    ASSERT_EQ(array.size(), static_cast<index_t>(n));
    scatter(std::span<Value* const>(back_pointers), array, [](Value& object, const Value& read) { object = read; });
    for (std::size_t i = 0; i < n; ++i) {
      ASSERT_EQ(back[i].x1111, objects[i].x1111) << i << " of " << n;
      ASSERT_EQ(back[i].x3223, objects[i].x3223) << i << " of " << n;
    }
  }
}

class CudaFormats : public GpuTest {};

TEST_F(CudaFormats, what_a_copy_loses_is_counted_with_its_place) { check_losses<Cuda>(); }

/// An array that has the size is filled in place where nothing can fail, else built anew: the objects are the same.
TEST_F(CudaFormats, objects_are_gathered_again_and_again_into_one_array) {
  using Value = elasticity::NodePosition<float>;
  constexpr std::size_t n = 1500001;  // more than a chunk
  std::mt19937 random(seed());
  std::uniform_real_distribution<float> value(-2.0F, 2.0F);
  std::vector<Value> objects(n);
  std::vector<Value*> pointers;
  for (Value& object : objects) pointers.push_back(&object);
  const std::span<Value* const> all(pointers);
  elasticity::NodePositionArray<float, Cuda, AosPadded> array;
  const auto read = [](const Value& object) noexcept { return object; };
  for (int round = 0; round < 3; ++round) {
    for (Value& object : objects) object.x = {value(random), value(random), value(random)};
    gather(array, all, read);
    elasticity::NodePositionArray<float, Host, Aos> back(array.size());
    copy(back, array);
    for (std::size_t i = 0; i < n; i += 997) ASSERT_EQ(back.view().get(static_cast<index_t>(i)).x, objects[i].x) << i;
    ASSERT_EQ(back.view().get(n - 1).x, objects[n - 1].x);
  }
  const auto failing = [&](const Value& object) {
    if (&object == pointers[n - 1]) throw std::runtime_error("the last object is broken");
    return Value{2 * object.x};
  };
  EXPECT_THROW(gather(array, all, failing), std::runtime_error);
  pointers[n / 2] = nullptr;
  EXPECT_NE(message_of([&] { gather(array, all, read); }).find("pointer 750000 of 1500001 is null"), std::string::npos);
  EXPECT_THROW(gather_by(array, index_t{1} << 40, [](index_t) { return Value{}; }), Error) << "no such memory";
  ASSERT_EQ(array.size(), static_cast<index_t>(n));
  for (const index_t i : {index_t{0}, index_t{1000000}, index_t{n - 1}}) {
    for (int k = 0; k < 3; ++k) ASSERT_EQ(array.getdata(i, k), objects[static_cast<std::size_t>(i)].x[k]);
  }
}

TEST_F(CudaFormats, copies_that_share_device_memory_or_have_none_are_refused) {
  elasticity::NodePositionArray<float, Cuda> array(100);
  array.putdata(3, 1, 5);
  UntypedArray null = array.untyped();
  null.base = nullptr;
  EXPECT_NE(message_of([&] { copy(array.untyped(), array.untyped()); }).find("they share memory"), std::string::npos);
  EXPECT_NE(message_of([&] { copy(array.untyped(), null); }).find("no memory (null)"), std::string::npos);
  EXPECT_EQ(array.getdata(3, 1), 5);
}

/// An allocation that fails is told once: what is done after it is not taken for failed.
TEST_F(CudaFormats, work_goes_on_after_memory_has_run_out) {
  elasticity::NodePositionArray<float, Cuda> array(100);
  EXPECT_THROW(array.resize(index_t{1} << 40), Error);
  elasticity::NodePositionArray<double, Cuda, Soa> other(100);
  EXPECT_NO_THROW(copy(other, array));
  EXPECT_NO_THROW(synchronize());
}

}  // namespace
}  // namespace physgen::test
