// Reports of a checked build. This program is compiled with PHYSGEN_CHECKED.
#include <physgen/gather.h>
#include <physgen/parallel_for.h>
#include <physgen/parallel_reduce.h>
#include <physgen/save_npy.h>
#include <physgen/threads.h>
#include <physgen/topology.h>

#include "checked_formats.h"
#include "saved_files.h"

namespace physgen::test {
namespace {

using elasticity::NodePositionArray;
using elasticity::NodePositionView;

TEST(CheckedView, reports_an_index_out_of_range_with_object_type_and_size) {
  NodePositionArray<float> array(5);
  const auto view = array.view();
  EXPECT_EQ(message_of([&] { (void)view[5]; }), "physgen: elasticity::NodePosition: object 5 of an array of 5");
  EXPECT_EQ(message_of([&] { (void)view[-1]; }), "physgen: elasticity::NodePosition: object -1 of an array of 5");
}

TEST(CheckedView, reports_a_null_view) {
  const NodePositionView<float, Aosoa<16>> view;
  EXPECT_NE(message_of([&] { (void)view[0]; }), "nothing was thrown");
}

TEST(CheckedView, reports_device_memory_used_on_the_host) {
  std::vector<std::byte> memory(4096);
  const NodePositionView<float, Aosoa<32>, Cuda> view(memory.data(), 5, 32);
  EXPECT_EQ(
      message_of([&] { (void)view[0]; }),
      "physgen: elasticity::NodePosition: a view of cuda memory is used on the host; copy the array to Host first");
}

TEST(CheckedView, reports_out_of_packs_and_threads) {
  NodePositionArray<float> array(20000);
  const auto view = array.view();
  EXPECT_THROW(parallel_for(Host{}, 20001, lanes<1>([=](index_t i) { (void)view[i]; })), Error);
  EXPECT_THROW(parallel_for(Host{}, 20001, over<float>([=](auto i) { (void)view[i]; })), Error);
  EXPECT_NO_THROW(parallel_for(Host{}, 3, 19999, over<float>([=](auto i) { (void)view[i]; })));
  EXPECT_THROW((void)view[Pack<8>{20000}], Error);
  EXPECT_NO_THROW((void)view[Pack<8>{19992}]);
  EXPECT_EQ(message_of([&] { (void)view[Pack<8>{4}]; }),
            "physgen: elasticity::NodePosition: a pack of 8 objects begins at object 4, which is not a multiple of its "
            "width");
}

TEST(CheckedView, reports_a_gathered_index_out_of_range) {
  NodePositionArray<float> array(10);
  const auto view = array.view();
  const batch_t<std::int32_t, native_lanes<float>> index(10);
  EXPECT_THROW((void)view[index], Error);
}

/// A pack does not follow the values in padding, such as an initial value of -1.
TEST(CheckedView, sees_no_indices_in_padding) {
  elasticity::TetArray<float> tets(1);
  NodePositionArray<float> array(2);
  const UntypedArray untyped = tets.untyped();
  std::fill(untyped.base, untyped.base + untyped.bytes(), std::byte{0xff});  // -1 everywhere
  for (int k = 0; k < 4; ++k) tets.view()[0].nodes()[k] = k % 2;
  array.view()[1].x() = Eigen::Vector3f(1, 2, 3);
  const auto view = array.view();
  const auto from = tets.const_view();
  EXPECT_EQ(sum(Host{}, 1, over<float>([=](auto i) {
                  const auto nodes = from[i].nodes();
                  const lanes_t<std::int32_t, decltype(i)> node = nodes[1];
                  return view[node].x().get().squaredNorm();
                })),
            14.0);
}

TEST(CheckedView, reports_entries_and_elements_that_do_not_exist) {
  elasticity::TetStiffnessArray<float> blocks(3);
  elasticity::NodeStiffnessArray<float> nodes(3);
  const auto view = blocks.view();
  EXPECT_EQ(message_of([&] { (void)view[0].k(4); }),
            "physgen: index 4 of an entry of elasticity::TetStiffness::k, of which there are 4; give one from 0 to 3");
  EXPECT_THROW((void)view[0].e(-1), Error);
  EXPECT_THROW((void)nodes.view()[0].K()[6], Error) << "a symmetric 3x3 stores 6 elements";
  EXPECT_THROW((void)nodes.view()[0].K()(0, 3), Error);
  EXPECT_THROW((void)nodes.view()[Pack<8>{0}], Error) << "the array has 3 objects only";
  const auto partial = nodes.view()[PartialPack<8>{0, 0, 3}];
  EXPECT_THROW((void)partial.K()[-1], Error);
  EXPECT_NO_THROW((void)partial.K()[5]);
}

TEST(CheckedView, reports_a_gathered_store_of_two_lanes_to_one_object) {
  NodePositionArray<float> array(40);
  const auto view = array.view();
  const auto store_to_halves = over<float>([=](auto i) {
    using S = lanes_t<float, decltype(i)>;
    view[numbers(i) / 2].x() = Eigen::Matrix<S, 3, 1>(S(1), S(2), S(3));
  });
  EXPECT_NE(message_of([&] { parallel_for(Host{}, 40, store_to_halves); }).find("both name object"), std::string::npos);
  EXPECT_NO_THROW(parallel_for(Host{}, 40, lanes<1>(store_to_halves)));
  // The lanes outside a range repeat one inside, and are no objects of their own.
  const auto store_to_own = over<float>([=](auto i) {
    using S = lanes_t<float, decltype(i)>;
    view[numbers(i)].x() = Eigen::Matrix<S, 3, 1>(S(1), S(2), S(3));
  });
  EXPECT_NO_THROW(parallel_for(Host{}, 3, 38, store_to_own));
  const auto store_after_another = over<float>([=](auto i) {
    parallel_for(Host{}, 1, over<float>([](auto) {}));
    using S = lanes_t<float, decltype(i)>;
    view[numbers(i)].x() = Eigen::Matrix<S, 3, 1>(S(1), S(2), S(3));
  });
  EXPECT_NO_THROW(parallel_for(Host{}, 3, 38, store_after_another));
}

TEST(CheckedFormats, count_what_kernels_store_and_cannot_be_held_and_say_where) {
  Array<elasticity::StressDerivativeObject, float, Host, Aosoa<16>, Coarse> array(40);
  const auto view = array.view();
  for (index_t i = 0; i < array.size(); ++i) view[i].x1111() = 1.0F;
  EXPECT_EQ(array.take_losses().falsified(), 0U);
  view[33].x1111() = 70000.0F;
  view[34].x2211() = -3.0F;
  view[35].x2211() = std::numeric_limits<float>::quiet_NaN();
  view[36].x1111() = 1e-7F;
  view[37].x1111() = std::numeric_limits<float>::quiet_NaN();
  view[38].x1111() = -std::numeric_limits<float>::infinity();
  view[39].x1111() = 2e-8F;
  const Losses losses = array.take_losses();
  EXPECT_EQ(losses.out_of_range, 2U);
  EXPECT_EQ(losses.not_a_number, 3U);
  EXPECT_EQ(losses.imprecise, 2U);
  EXPECT_EQ(losses.first_imprecise.object, 36);
  EXPECT_EQ(losses.first_imprecise.value, double{1e-7F});
  EXPECT_EQ(losses.worst_relative_error(), 1.0) << "half of the smallest half became 0";
  EXPECT_EQ(losses.first.object, 33);
  const std::string message = message_of([&] { throw_if_falsified(losses, array.untyped()); });
  EXPECT_NE(message.find("the first is 70000 Pa in x1111 of object 33"), std::string::npos) << message;
  EXPECT_EQ(array.take_losses().falsified(), 0U) << "they were taken";
}

/// The same place on every run, however many threads store: that of the smallest object, and of the first element
/// there.
TEST(CheckedFormats, name_the_first_object_that_is_wrong_whichever_thread_comes_first) {
  constexpr index_t n = 200000;
  Array<elasticity::StressDerivativeObject, float, Host, Aosoa<16>, Coarse> array(n);
  elasticity::StressDerivativeArray<float> wrong(n);
  for (const index_t i : {10, 9999, 60000, 110000, 160000, 199999}) {
    wrong.putdata(i, 1, 2);
    wrong.putdata(i, 0, 1e6 + static_cast<double>(i));
  }
  set_threads(8);
  for (int run = 0; run < 8; ++run) {
    const Losses copied = losses_of_copy(array.untyped(), wrong.untyped());
    EXPECT_EQ(copied.out_of_range, 12U);
    EXPECT_EQ(copied.first.object, 10);
    const auto fields = array.untyped().fields;
    const bool is_x1111 = fields[0].offset < fields[1].offset;
    EXPECT_EQ(copied.first.offset, fields[is_x1111 ? 0 : 1].offset);
    EXPECT_EQ(copied.first.value, is_x1111 ? 1000010 : 2);
    const auto to = array.view();
    const auto from = wrong.const_view();
    parallel_for(Host{}, n, lanes<1>([&](index_t k) {
                   const index_t i = run % 2 == 0 ? n - 1 - k : k;
                   to.put(i, from.get(i));
                 }));
    const Losses stored = array.take_losses();
    EXPECT_EQ(stored.first.object, 10);
    EXPECT_EQ(stored.first.value, copied.first.value);
    EXPECT_EQ(stored.first.offset, copied.first.offset);
  }
  set_threads(0);
}

TEST(Losses, of_several_chunks_begin_with_the_first_object) {
  Losses all, later, earlier;
  detail::remember(later.out_of_range, later.first, 3, 8, 5.0);
  detail::remember(earlier.out_of_range, earlier.first, 7, 4, 6.0);
  all.add(later, 100);
  all.add(earlier, 90);
  EXPECT_EQ(all.first.object, 97);
  EXPECT_EQ(all.first.offset, 4);
  EXPECT_EQ(all.first.value, 6.0);
  EXPECT_EQ(all.out_of_range, 2U);
  all.add(Losses{});
  EXPECT_EQ(all.first.object, 97);
  EXPECT_FALSE(all.first_imprecise.known());
}

TEST(CheckedScatter, refuses_a_pointer_that_is_there_twice) {
  const NodePositionArray<float> array(5);
  std::vector<elasticity::NodePosition<float>> objects(5);
  std::vector<elasticity::NodePosition<float>*> pointers;
  for (auto& object : objects) pointers.push_back(&object);
  const auto write = [](auto& object, const auto& value) { object.x = value.x + Eigen::Vector3f::Ones(); };
  scatter(pointers, array, write);
  EXPECT_EQ(objects[3].x[0], 1);
  pointers[4] = pointers[1];
  pointers[3] = pointers[2];
  EXPECT_EQ(message_of([&] { scatter(pointers, array, write); }),
            "physgen: elasticity::NodePosition: pointers 2 and 3 of 5 are the same; an object is scattered to once");
  EXPECT_EQ(objects[0].x[0], 1) << "nothing was written";
}

TEST(CheckedFormats, count_in_packs_and_not_in_padding) {
  Array<elasticity::StressDerivativeObject, float, Host, Aosoa<16>, Coarse> array(20);
  constexpr int W = native_lanes<float>;
  const auto view = array.view();
  for (index_t i = 0; i < 20; i += W) {
    view[partial_pack<W>(i, 1, 20)].x1111() = batch_t<float, W>(1e6F);
  }
  EXPECT_EQ(array.take_losses().out_of_range, 19U);
  view[numbers(Pack<W>{0}) + 3].x1111() = batch_t<float, W>(1e6F);
  const Losses gathered = array.take_losses();
  EXPECT_EQ(gathered.out_of_range, static_cast<unsigned>(W));
  EXPECT_EQ(gathered.first.object, 3);
}

TEST(CheckedFormats, count_matrices_that_are_no_rotations) {
  Array<elasticity::DeformationSvdObject, float, Host, Soa, QuaternionRotations> array(3);
  array.view()[0].U() = Eigen::Matrix3f::Identity();
  array.view()[1].U() = Eigen::Matrix3f(-Eigen::Matrix3f::Identity());
  array.view()[2].U() = Eigen::Matrix3f(Eigen::Matrix3f::Constant(std::numeric_limits<float>::quiet_NaN()));
  const Losses losses = array.take_losses();
  EXPECT_EQ(losses.not_a_rotation, 2U);
  EXPECT_EQ(losses.first.object, 1);
  using S = batch_t<float, native_lanes<float>>;
  array.view()[PartialPack<native_lanes<float>>{0, 0, 3}].U() = Eigen::Matrix<S, 3, 3>::Constant(S(2));
  EXPECT_EQ(array.take_losses().not_a_rotation, 3U) << "lanes outside the range are no objects";
  const PartialPack<native_lanes<float>> pack{0, 0, 3};
  store_where(numbers(pack) == 1, array.view()[pack].U(), Eigen::Matrix<S, 3, 3>::Constant(S(2)));
  EXPECT_EQ(array.take_losses().not_a_rotation, 1U);
}

TEST(CheckedFormats, keep_their_counts_when_an_array_changes_its_size) {
  Array<elasticity::StressDerivativeObject, float, Host, Aosoa<16>, Coarse> array(40);
  array.view()[33].x1111() = 70000.0F;
  array.resize(90);
  append(array, 1);
  const Losses losses = array.take_losses();
  EXPECT_EQ(losses.out_of_range, 1U);
  EXPECT_EQ(losses.first.object, 33);
  EXPECT_EQ(losses.objects, 91);
}

TEST(CheckedFormats, keep_their_counts_when_as_many_objects_as_files_have_are_loaded) {
  const Folder folder;
  for (const index_t n : {40, 7}) {
    Array<elasticity::StressDerivativeObject, float, Host, Aosoa<16>, Coarse> array(40);
    save_npy(Array<elasticity::StressDerivativeObject, float, Host, Aosoa<16>, Coarse>(n), folder / "stress");
    array.view()[33].x1111() = 70000.0F;
    load_npy(folder / "stress", array);
    const Losses losses = array.take_losses();
    EXPECT_TRUE(losses.out_of_range == 1 && losses.objects == n) << n;
  }
}

/// A copy, an append, a gather and putdata are refused, and nothing has changed then.
TEST(CheckedFormats, refuse_values_that_they_cannot_hold_and_change_nothing) {
  using Derivatives = Array<elasticity::StressDerivativeObject, float, Host, Aosoa<16>, Coarse>;
  const auto said = [](const std::string& message, const char* part) {
    EXPECT_NE(message.find("its storage formats cannot hold 1 values"), std::string::npos) << message;
    EXPECT_NE(message.find(part), std::string::npos) << message;
  };
  Derivatives array(40);
  array.putdata(3, 0, 5);
  elasticity::StressDerivativeArray<float> wrong(40);
  wrong.putdata(7, 0, 1e6);
  said(message_of([&] { copy(array, wrong); }), "the first is 1e+06 Pa in x1111 of object 7");
  said(message_of([&] { append(array, wrong); }), "in x1111 of object 7");
  said(message_of([&] { array.putdata(9, 1, 3); }), "the first is 3 Pa in x2211 of object 9");
  std::vector<elasticity::StressDerivative<float>> objects(40);
  std::vector<elasticity::StressDerivative<float>*> pointers;
  for (auto& object : objects) pointers.push_back(&(object = wrong.view().get(0)));
  objects[11].x1111 = std::numeric_limits<float>::quiet_NaN();
  said(message_of([&] {
         gather(array, std::span<elasticity::StressDerivative<float>* const>(pointers),
                [](const auto& object) { return object; });
       }),
       "the first is nan Pa in x1111 of object 11");
  EXPECT_EQ(array.size(), 40);
  EXPECT_EQ(array.getdata(3, 0), 5);
  EXPECT_EQ(array.getdata(7, 0), 0);
  EXPECT_EQ(array.getdata(9, 1), 0);
}

/// Stored quaternions that are no unit quaternions: copies to matrices and to other quaternions refuse them.
TEST(CheckedFormats, refuse_quaternions_of_another_length) {
  Array<elasticity::DeformationSvdObject, float, Host, Aos, QuaternionRotations> array(5);
  const UntypedArray untyped = array.untyped();
  float w = 0;  // of U of object 3, whose x, y, z are 0
  std::memcpy(untyped.base + 3 * untyped.record_bytes + untyped.fields[0].offset, &w, sizeof w);
  elasticity::DeformationSvdArray<float> matrices(5);
  Array<elasticity::DeformationSvdObject, float, Host, Soa, HalfQuaternions> halves(5);
  for (const std::string& message :
       {message_of([&] { copy(matrices, array); }), message_of([&] { copy(halves, array); })}) {
    EXPECT_NE(message.find("1 not rotations); the first is 1 in U"), std::string::npos) << message;
    EXPECT_NE(message.find("of object 3"), std::string::npos) << message;
  }
}

}  // namespace
}  // namespace physgen::test
