// Kernels for CUDA that load and store elements past the caches, by functions that take an address: of one element,
// which is its field's use, or of what lies behind it, which nobody can follow. Read by the analysis of the device.
#include <elasticity.physgen.h>
#include <physgen/kernel.h>
#include <physgen/probe.h>

namespace cache_hints {

using namespace physgen;

#define PHYSGEN_TEST_ARRAY(Tag, Type)         \
  struct Tag##_tag {                          \
    static constexpr const char* name = #Tag; \
  };                                          \
  ProbeOf<elasticity::Type##Array<float, Cuda>, Tag##_tag> Tag

struct Arrays {
  PHYSGEN_TEST_ARRAY(loaded, RestShape);
  PHYSGEN_TEST_ARRAY(stored, StressDerivative);
  PHYSGEN_TEST_ARRAY(behind, RestShape);
  PHYSGEN_TEST_ARRAY(given, RestShape);
};

template <class From, class To>
struct PastTheCaches {
  using Scalar = float;
  From from;
  To to;
  PHYSGEN_FUNCTION void operator()(index_t i) const {
#ifdef __CUDA_ARCH__
    const float volume = __ldcg(&from[i].volume()) + __ldcs(&from[i].volume()) + __ldg(&from[i].volume());
    __stwt(&to[i].x1111(), volume);
    __stwt(&to[i].x2222(), 2 * volume);
#endif
  }
};
template <class From, class To>
PastTheCaches(From, To) -> PastTheCaches<From, To>;

/// This is a function of the program, in spite of its name.
PHYSGEN_FUNCTION inline void atomicRaise(float* number) { number[1] += 1.0F; }

template <class Behind, class Given>
struct FurtherThanTheElement {
  using Scalar = float;
  Behind behind;
  Given given;
  PHYSGEN_FUNCTION void operator()(index_t i) const {
#ifdef __CUDA_ARCH__
    const float next = __ldcg(&behind[i].volume() + 1);  // not followed
    __stwt(&behind[i].volume(), next);
    atomicRaise(&given[i].volume());  // not followed
#endif
  }
};
template <class Behind, class Given>
FurtherThanTheElement(Behind, Given) -> FurtherThanTheElement<Behind, Given>;

template <class On>
void program(On& on, Arrays& a) {
  on.run(1, PastTheCaches{a.loaded.const_view(), a.stored.view()});
  on.run(1, FurtherThanTheElement{a.behind.view(), a.given.view()});
}

template void program(ProbeExecutor<Cuda>& on, Arrays& a);

}  // namespace cache_hints
