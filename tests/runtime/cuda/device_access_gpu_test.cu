// Views on the device: kernels read and write by name in every layout, atomics work on accessors.
#include <everything.physgen.h>
#include <physgen/cuda/parallel_for.h>

#include "gpu_fixture.h"
#include "test_objects.h"

namespace physgen::test {
namespace {

template <class L>
class DeviceAccess : public GpuTest {};
TYPED_TEST_SUITE(DeviceAccess, AllLayouts, LayoutName);

template <class Real, class Layout>
struct SwapRotations {
  elasticity::DeformationSvdView<Real, Layout, Cuda> svd;
  PHYSGEN_FUNCTION void operator()(index_t i) const {
    const auto value = svd.get(i);
    svd.put(i, {value.V, value.U, value.s});
    svd[i].s()(2) = -svd[i].s()(2);
  }
};

// Host and device compilers must lay out a kernel's views alike: this is compiled by both.
struct ManyViews {
  elasticity::DeformationSvdView<const float, Aosoa<32>, Cuda> a;
  elasticity::DeformationSvdView<float, Aosoa<32>, Cuda> b;
  elasticity::NodeForceView<float, AosPadded, Cuda> c;
  elasticity::NodeForceView<float, Soa, Cuda> d;
};
static_assert(checked_build || sizeof(ManyViews) == (2 + 2 + 2 + 3) * sizeof(void*));

template <class Real, class Layout>
void check_device_access() {
  std::mt19937 random(seed());
  const index_t n = 100003;
  Array<elasticity::DeformationSvdObject, Real, Host, Aos> source(n);
  randomise(source, random);
  elasticity::DeformationSvdArray<Real, Cuda, Layout> array(n);
  copy(array, source);
  parallel_for(Cuda{}, n, SwapRotations<Real, Layout>{array.view()});
  Array<elasticity::DeformationSvdObject, Real, Host, Aos> back(n);
  poison(back);
  copy(back, array);
  synchronize();
  for (index_t i = 0; i < n; ++i) {
    const auto was = source.view().get(i);
    const auto is = back.view().get(i);
    ASSERT_EQ(is.U, was.V);
    ASSERT_EQ(is.V, was.U);
    ASSERT_EQ(is.s(2), -was.s(2));
  }
}

TYPED_TEST(DeviceAccess, reads_and_writes_floats_by_name) { check_device_access<float, TypeParam>(); }
TYPED_TEST(DeviceAccess, reads_and_writes_doubles_by_name) { check_device_access<double, TypeParam>(); }

// Fields are stored by 16-byte words where these hold nothing else, and one element at a time where they do.
struct StoreVectors {
  Array<material::FibreObject, float, Cuda, AosPadded>::View fibres;        // a vector and a scalar in a word
  Array<material::FibreObject, double, Cuda, AosPadded>::View wide;         // in two
  elasticity::NodeForceArray<float, Cuda, AosPadded>::View forces;          // a vector and padding
  Array<tissue::model::ShapesObject, float, Cuda, AosPadded>::View shapes;  // of fields that begin anywhere
  PHYSGEN_FUNCTION void operator()(index_t i) const {
    const auto x = static_cast<float>(i);
    fibres[i].direction() = Eigen::Vector3f(x, x + 1, x + 2);
    wide[i].direction() = Eigen::Vector3f(x, x + 1, x + 2);
    forces[i].f() = Eigen::Vector3f(x, -x, 2 * x);
    const Eigen::Matrix<float, 1, 4> row = shapes[i].row();
    shapes[i].v() = Eigen::Vector3f(row[0], row[1], row[2]);
    shapes[i].row() = Eigen::Matrix<float, 1, 4>(row[3], x, x, x);
  }
};

class DeviceWords : public GpuTest {};

TEST_F(DeviceWords, touch_no_other_field_and_no_other_object) {
  std::mt19937 random(seed());
  const index_t n = 1000;
  const auto random_there = [&](auto& array) {
    using There = std::remove_reference_t<decltype(array)>;
    Array<typename There::Object, double, Host, Aos> drawn(n);
    randomise(drawn, random);
    copy(array, drawn);
    return drawn;
  };
  const auto back = [](const auto& array) {
    Array<typename std::remove_reference_t<decltype(array)>::Object, double, Host, Aos> objects(n);
    copy(objects, array);
    synchronize();
    return objects;
  };
  Array<material::FibreObject, float, Cuda, AosPadded> fibres(n);
  Array<material::FibreObject, double, Cuda, AosPadded> wide(n);
  elasticity::NodeForceArray<float, Cuda, AosPadded> forces(n + 1);
  Array<tissue::model::ShapesObject, float, Cuda, AosPadded> shapes(n);
  const auto fibres_were = random_there(fibres), wide_were = random_there(wide);
  const auto shapes_were = random_there(shapes);
  for (int k = 0; k < 3; ++k) forces.putdata(n, k, 7);
  parallel_for(Cuda{}, n, StoreVectors{fibres.view(), wide.view(), forces.view(), shapes.view()});
  const auto fibres_are = back(fibres), wide_are = back(wide);
  const auto shapes_are = back(shapes);
  for (index_t i = 0; i < n; ++i) {
    const auto x = static_cast<double>(i);
    for (int k = 0; k < 3; ++k) {
      ASSERT_EQ(fibres_are.getdata(i, k), x + k);
      ASSERT_EQ(wide_are.getdata(i, k), x + k);
    }
    ASSERT_EQ(fibres_are.getdata(i, 3), fibres_were.getdata(i, 3)) << "the strength beside the direction";
    ASSERT_EQ(wide_are.getdata(i, 3), wide_were.getdata(i, 3));
    auto expected = shapes_were.view().get(i);
    expected.v = expected.row.template head<3>().transpose();
    expected.row << expected.row[3], x, x, x;
    Array<tissue::model::ShapesObject, double, Host, Aos> wanted(1);
    wanted.view().put(0, expected);
    for (int k = 0; k < wanted.elements; ++k) ASSERT_EQ(shapes_are.getdata(i, k), wanted.getdata(0, k)) << k;
  }
  const double last = static_cast<double>(n - 1);
  EXPECT_EQ(forces.getdata(n - 1, 1), -last);
  EXPECT_EQ(forces.getdata(n - 1, 2), 2 * last);
  for (int k = 0; k < 3; ++k) EXPECT_EQ(forces.getdata(n, k), 7) << "the next object";
}

template <class Layout>
struct AddToFirst {
  elasticity::NodeForceView<float, Layout, Cuda> force;
  PHYSGEN_FUNCTION void operator()([[maybe_unused]] index_t i) const {
#ifdef __CUDA_ARCH__
    atomicAdd(&force[i % 3].f()(1), 1.0F);
#endif
  }
};

TYPED_TEST(DeviceAccess, gives_addresses_that_atomic_operations_take) {
  elasticity::NodeForceArray<float, Cuda, TypeParam> force(3);
  parallel_for(Cuda{}, 3000, AddToFirst<TypeParam>{force.view()});
  for (index_t i = 0; i < 3; ++i) EXPECT_EQ(force.getdata(i, 1), 1000);
}

struct NumberObjects {
  elasticity::IncidenceArray<float, Cuda, Aosoa<32>>::View incidences;
  PHYSGEN_FUNCTION void operator()(index_t i) const {
    incidences.put(i, {static_cast<std::int32_t>(i >> 20), static_cast<std::int32_t>(i & 0xfffff)});
  }
};

class ManyObjects : public GpuTest {};

TEST_F(ManyObjects, more_than_two_to_the_31st_are_ordinary) {
  const index_t n = (index_t{1} << 31) + 33;  // 17 GB
  std::size_t free = 0;
  std::size_t total = 0;
  cuda::check(cudaMemGetInfo(&free, &total), "asking for free memory");
  if (static_cast<index_t>(free) < n * 9) GTEST_SKIP() << "this test needs 20 GB of device memory";
  elasticity::IncidenceArray<float, Cuda, Aosoa<32>> incidences(n);
  parallel_for(Cuda{}, n, NumberObjects{incidences.view()});
  for (const index_t i : {index_t{0}, (index_t{1} << 31) - 1, index_t{1} << 31, n - 1}) {
    EXPECT_EQ(incidences.getdata(i, 0), static_cast<double>(i >> 20));
    EXPECT_EQ(incidences.getdata(i, 1), static_cast<double>(i & 0xfffff));
  }
}

}  // namespace
}  // namespace physgen::test
