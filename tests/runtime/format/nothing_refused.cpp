// Everything that needs a field of which nothing is stored, in one source that a compiler must refuse:
// nothing_refused.py compares what it reports with the list of cases here, `refused NAME: words of the message`. Each
// case has formats of its own, in whose Pruned it stands as the field, once for single objects, once for packs and once
// for gathered objects. Compiled by nvcc, too.
#include <elasticity.physgen.h>
#include <physgen/gather.h>
#include <physgen/topology.h>
#if defined(__CUDACC__)
#include <physgen/cuda/parallel_for.h>
#else
#include <physgen/parallel_for.h>
#endif

using namespace physgen;

struct explicit_dynamics;

namespace arrays {
struct svds;
}

namespace refused {

#if defined(__CUDACC__)
using Space = Cuda;
#else
using Space = Host;
#endif

struct one;
struct pack;
struct gathered;

template <class Case>
struct Svd : elasticity::DeformationSvdFormats<Host> {
  using U = format::Pruned<explicit_dynamics, arrays::svds, Case>;
};
template <class Case>
struct Derivative : elasticity::StressDerivativeFormats<Host> {
  using x1111 = format::Pruned<explicit_dynamics, arrays::svds, Case>;
};
template <class Case>
struct Tet : elasticity::TetFormats<Host> {
  using nodes = format::Pruned<explicit_dynamics, arrays::svds, Case>;
};

/// The arrays that kernels are given.
template <class Case>
struct Views {
  using Scalar = float;
  View<elasticity::DeformationSvdObject, float, Soa, Svd<Case>, Space> svds;
  View<elasticity::DeformationSvdObject, const float, Soa, Svd<Case>, Space> read_only;
  View<elasticity::StressDerivativeObject, float, Soa, Derivative<Case>, Space> derivatives;
  View<elasticity::TetObject, float, Soa, Tet<Case>, Space> tets;
};
template <class I>
using Lanes = lanes_t<float, I>;

// Calls NAME(views, i) for every kind of index.
#if defined(__CUDACC__)
#define REFUSED(NAME)   \
  template <class Kind> \
  struct NAME##_;       \
  __global__ void run_##NAME(Views<NAME##_<one>> v) { NAME(v, index_t{threadIdx.x}); }
#else
#define REFUSED(NAME)                                                                                             \
  template <class Kind>                                                                                           \
  struct NAME##_;                                                                                                 \
  void run_##NAME(const Views<NAME##_<one>>& v, const Views<NAME##_<pack>>& p, const Views<NAME##_<gathered>>& g, \
                  const batch_t<std::int32_t, native_lanes<float>>& j) {                                          \
    NAME(v, index_t{3});                                                                                          \
    NAME(p, Pack<native_lanes<float>>{0});                                                                        \
    NAME(g, j);                                                                                                   \
  }
#endif

/// refused reading_a_field: no kernel of the scene reads it
template <class V, class I>
PHYSGEN_FUNCTION void reading_a_field(const V& v, I i) {
  const Eigen::Matrix<Lanes<I>, 3, 3> U = v.svds[i].U();
  v.svds[i].V() = U;
}
REFUSED(reading_a_field)

/// refused reading_an_element_of_a_field: no kernel of the scene reads it
template <class V, class I>
PHYSGEN_FUNCTION void reading_an_element_of_a_field(const V& v, I i) {
  v.derivatives[i].x2211() = Lanes<I>(v.svds[i].U()[3]);
}
REFUSED(reading_an_element_of_a_field)

/// refused calculating_with_an_element: no kernel of the scene reads it
template <class V, class I>
PHYSGEN_FUNCTION void calculating_with_an_element(const V& v, I i) {
  v.derivatives[i].x2211() = v.derivatives[i].x1111() * Lanes<I>(2.0F);
}
REFUSED(calculating_with_an_element)

/// refused reading_an_index: no kernel of the scene reads it
template <class V, class I>
PHYSGEN_FUNCTION void reading_an_index(const V& v, I i) {
  v.svds[i].s() = v.svds[v.tets[i].nodes()[0].get()].s().get();
}
REFUSED(reading_an_index)

/// refused getting_an_object: no kernel of the scene reads it
template <class V, class I>
PHYSGEN_FUNCTION void getting_an_object(const V& v, I i) {
  v.derivatives[i].x2211() = v.svds.get(i).s[0];
}
REFUSED(getting_an_object)

/// refused copying_an_object: no kernel of the scene reads it
template <class V, class I>
PHYSGEN_FUNCTION void copying_an_object(const V& v, I i) {
  v.svds[i] = v.read_only[i];
}
REFUSED(copying_an_object)

/// refused copying_a_field: no kernel of the scene reads it
template <class V, class I>
PHYSGEN_FUNCTION void copying_a_field(const V& v, I i) {
  v.svds[i].U() = v.read_only[i].U().get();
}
REFUSED(copying_a_field)

/// refused swapping_fields: no kernel of the scene reads it
template <class V, class I>
PHYSGEN_FUNCTION void swapping_fields(const V& v, I i) {
  swap(v.svds[i].U(), v.svds[i].U());
}
REFUSED(swapping_fields)

/// refused swapping_elements: no kernel of the scene reads it
template <class V, class I>
PHYSGEN_FUNCTION void swapping_elements(const V& v, I i) {
  swap(v.derivatives[i].x1111(), v.derivatives[i].x1111());
}
REFUSED(swapping_elements)

/// refused adding_to_an_element: no kernel of the scene reads it
template <class V, class I>
PHYSGEN_FUNCTION void adding_to_an_element(const V& v, I i) {
  add(i, v.derivatives[i].x1111(), Lanes<I>(1.0F));
}
#if !defined(__CUDACC__)
template <class V, class T, class A>  // by the kernel's own index
void adding_to_an_element(const V& v, const xsimd::batch<T, A>& j) {
  add(Pack<native_lanes<float>>{0}, v.derivatives[j].x1111(), Lanes<xsimd::batch<T, A>>(1.0F));
}
#endif
REFUSED(adding_to_an_element)

/// refused storing_to_a_read_only_array: this array is read-only here
template <class V, class I>
PHYSGEN_FUNCTION void storing_to_a_read_only_array(const V& v, I i) {
  v.read_only[i].U().setIdentity();
}
REFUSED(storing_to_a_read_only_array)

/// Not refused: nothing is stored.
template <class V, class I>
PHYSGEN_FUNCTION void only_storing(const V& v, I i) {
  using S = Lanes<I>;
  v.svds[i].U().setIdentity();
  v.svds[i].U()[3] = S(2.0F);
  v.svds.put(i, {});
  v.tets[i].nodes()[2] = lanes_t<std::int32_t, I>(7);
  v.derivatives[i].x1111() = S(1.0F);
  v.derivatives[i].x2211() = S(v.svds[i].s()[0]);
  store_where(S(1.0F) > S(0.0F), v.svds[i].U(), Eigen::Matrix<S, 3, 3>::Identity());
}
REFUSED(only_storing)

#if !defined(__CUDACC__)

/// refused on the host increasing_an_element: no kernel of the scene reads it
template <class V, class I>
void increasing_an_element(const V& v, I i) {
  if constexpr (requires { I::width; } || std::is_integral_v<I>) {
    v.derivatives[i].x1111() += Lanes<I>(1.0F);
  } else {
    (void)v.derivatives[i].x1111().get();  // += of gathered objects is refused for itself
  }
}
REFUSED(increasing_an_element)

/// refused on the host the_address_of_an_element: taking address of rvalue
void the_address_of_an_element(const Views<one>& v) {
  auto* const address = &v.svds[0].U()[3];
  (void)address;
}

// ---- Whole arrays: the case stands in the formats of one of them ----------------------------------------------------

template <class Case>
struct WouldLose : elasticity::DeformationSvdFormats<Host> {
  using U = format::Nothing;
};
template <class Formats = elasticity::DeformationSvdFormats<Host>>
using Svds = Array<elasticity::DeformationSvdObject, float, Host, Soa, Formats>;

/// refused on the host copying_from_an_array_without_it: the array copied from stores nothing of this field
struct copying_from_an_array_without_it_;
void copying_from_an_array_without_it(Svds<>& full, const Svds<Svd<copying_from_an_array_without_it_>>& part) {
  copy(full, part);
}

/// refused on the host appending_an_array_without_it: the array copied from stores nothing of this field
struct appending_an_array_without_it_;
void appending_an_array_without_it(Svds<>& full, const Svds<Svd<appending_an_array_without_it_>>& part) {
  append(full, part);
}

/// refused on the host copying_to_an_array_that_would_lose_it: this field would be lost
struct copying_to_an_array_that_would_lose_it_;
void copying_to_an_array_that_would_lose_it(Svds<WouldLose<copying_to_an_array_that_would_lose_it_>>& lost,
                                            const Svds<>& full) {
  copy(lost, full);
}

/// refused on the host gathering_into_an_array_that_would_lose_it: this field would be lost
struct gathering_into_an_array_that_would_lose_it_;
void gathering_into_an_array_that_would_lose_it(Svds<WouldLose<gathering_into_an_array_that_would_lose_it_>>& lost) {
  gather_by(lost, 5, [](index_t) { return elasticity::DeformationSvd<float>(); });
}

/// refused on the host scattering_from_an_array_without_it: no kernel of the scene reads it
struct scattering_from_an_array_without_it_;
void scattering_from_an_array_without_it(const Svds<Svd<scattering_from_an_array_without_it_>>& part) {
  scatter_by(part, [](index_t, const elasticity::DeformationSvd<float>&) {});
}

/// Not refused: who prunes has said that this is meant, and what both lack need not be copied.
struct only_copying_;
void only_copying(Svds<Svd<only_copying_>>& part, Svds<WouldLose<only_copying_>>& lost, const Svds<>& full) {
  copy(part, full);
  copy(lost, part);
  append(part, full);
  gather_by(part, 5, [](index_t) { return elasticity::DeformationSvd<float>(); });
}

/// refused on the host reading_a_field_of_Nothing: its format is Nothing, so it cannot be read
template <class Kind>
struct reading_a_field_of_Nothing_;
void reading_a_field_of_Nothing(const Svds<WouldLose<reading_a_field_of_Nothing_<one>>>& lost) {
  (void)lost.const_view().get(index_t{2});
}

/// refused on the host a_quaternion_of_nothing: a rotation is pruned as a whole
struct a_quaternion_of_nothing_;
format::Quaternion<Svd<a_quaternion_of_nothing_>::U> a_quaternion_of_nothing();
static_assert(sizeof(a_quaternion_of_nothing()) > 0);

/// refused on the host nothing_scaled: Scaled takes Native, Float32, Float64, Half<> or Bfloat16
struct nothing_scaled_;
format::Scaled<Svd<nothing_scaled_>::U, format::Affine{.scale = 2}> nothing_scaled();
static_assert(sizeof(nothing_scaled()) > 0);

#endif

}  // namespace refused
