// Programs that need a field of which nothing is stored, and that a compiler must refuse: one per CASE_..., which
// CMakeLists.txt defines. Compiled by nvcc, too.
#include <elasticity.physgen.h>
#include <physgen/gather.h>
#if defined(__CUDACC__)
#include <physgen/cuda/parallel_for.h>
#else
#include <physgen/parallel_for.h>
#endif

using namespace physgen;

struct explicit_dynamics;
namespace explicit_dynamics_fields {
struct svds;
struct rotation_U;
struct derivatives;
struct entry_x1111;
}  // namespace explicit_dynamics_fields

namespace {

#if defined(__CUDACC__)
using Space = Cuda;
#else
using Space = Host;
#endif

struct Stretches : elasticity::DeformationSvdFormats<Host> {
  using U = format::Pruned<explicit_dynamics, explicit_dynamics_fields::svds, explicit_dynamics_fields::rotation_U>;
};
struct NoU : elasticity::DeformationSvdFormats<Host> {
  using U = format::Nothing;
};
struct Derivative : elasticity::StressDerivativeFormats<Host> {
  using x1111 =
      format::Pruned<explicit_dynamics, explicit_dynamics_fields::derivatives, explicit_dynamics_fields::entry_x1111>;
};

template <class Formats = FormatsOf<elasticity::DeformationSvdObject, Space>>
using Svds = Array<elasticity::DeformationSvdObject, float, Space, Aosoa<32>, Formats>;
using Derivatives = Array<elasticity::StressDerivativeObject, float, Space, Aosoa<32>, Derivative>;

struct Kernel {
  using Scalar = float;
  Svds<Stretches>::View svds;
  Svds<Stretches>::ConstView read_only;
  Derivatives::View derivatives;

  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    using S = lanes_t<float, I>;
    using M = Eigen::Matrix<S, 3, 3>;
#if defined(CASE_reading_a_pruned_field)
    svds[i].V() = M(svds[i].U());
#elif defined(CASE_reading_an_element_of_a_pruned_field)
    derivatives[i].x2211() = S(svds[i].U()[3]);
#elif defined(CASE_reading_a_pruned_element)
    derivatives[i].x2211() = derivatives[i].x1111() * S(2.0F);
#elif defined(CASE_getting_an_object_with_a_pruned_field)
    derivatives[i].x2211() = svds.get(i).s[0];
#elif defined(CASE_copying_an_object_with_a_pruned_field)
    svds[i] = read_only[i];
#elif defined(CASE_swapping_a_pruned_element)
    swap(derivatives[i].x1111(), derivatives[i].x1111());
#elif defined(CASE_increasing_a_pruned_element)
    derivatives[i].x1111() += S(1.0F);
#elif defined(CASE_swapping_a_pruned_field)
    swap(svds[i].U(), svds[i].U());
#elif defined(CASE_adding_to_a_pruned_element)
    add(i, derivatives[i].x1111(), S(1.0F));
#elif defined(CASE_the_address_of_a_pruned_element)
    auto* address = &svds[i].U()[3];
    (void)address;
#elif defined(CASE_storing_to_a_pruned_field_of_a_read_only_array)
    read_only[i].U().setIdentity();
#else
    svds[i].U().setIdentity();
    svds[i].U()[3] = S(2.0F);
    svds[i].V() = M::Identity();
    svds.put(i, {});
    derivatives[i].x1111() = S(1.0F);
    derivatives[i].x2211() = S(svds[i].s()[0]);
#endif
  }
};

}  // namespace

void refused(Svds<Stretches>& part, Svds<>& full, Svds<NoU>& without, Derivatives& derivatives) {
  parallel_for(Space{}, part.size(), Kernel{part.view(), part.const_view(), derivatives.view()});
#if defined(CASE_copying_from_an_array_without_a_field)
  copy(full, part);
#elif defined(CASE_copying_from_an_array_of_another_space_without_a_field)
  Array<elasticity::DeformationSvdObject, double, Host, Aos> elsewhere;
  copy(elsewhere, part);
#elif defined(CASE_copying_to_an_array_that_would_lose_a_field)
  copy(without, full);
#elif defined(CASE_gathering_into_an_array_that_would_lose_a_field)
  gather_by(5, without, [](index_t) { return elasticity::DeformationSvd<float>(); });
#elif defined(CASE_scattering_from_an_array_without_a_field)
  scatter_by(part, [](index_t, const elasticity::DeformationSvd<float>&) {});
#elif defined(CASE_a_quaternion_of_nothing)
  (void)sizeof(format::Quaternion<format::Nothing>);
#elif defined(CASE_nothing_scaled)
  (void)sizeof(format::Scaled<format::Nothing, format::Affine{.scale = 2}>);
#else
  copy(part, full);
  copy(without, part);
  gather_by(5, part, [](index_t) { return elasticity::DeformationSvd<float>(); });
#endif
}
