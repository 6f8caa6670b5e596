// Kernels that hide what they read and write from whoever reads their text. Compiled into usage_analysis_test, where
// the compiler registers what it finds, and read by the analysis. Arrays are named by what is done to them.
#include <elasticity.physgen.h>
#include <physgen/fuse.h>
#include <physgen/kernel.h>
#include <physgen/probe.h>

#include <algorithm>
#include <array>
#include <functional>
#include <memory>

#include "awkward_helper.h"

namespace awkward {

using namespace physgen;

#ifdef __CUDACC__
using Space = Cuda;
#else
using Space = Host;
#endif

#define PHYSGEN_TEST_ARRAY(Tag, Type)                    \
  struct Tag##_tag {                                     \
    static constexpr const char* name = "awkward." #Tag; \
  };                                                     \
  ProbeOf<elasticity::Type##Array<float, Space>, Tag##_tag> Tag

struct Arrays {
  PHYSGEN_TEST_ARRAY(whole, DeformationSvd);
  PHYSGEN_TEST_ARRAY(put, DeformationSvd);
  PHYSGEN_TEST_ARRAY(copied, DeformationSvd);
  PHYSGEN_TEST_ARRAY(lambda, RestShape);
  PHYSGEN_TEST_ARRAY(generic, RestShape);
  PHYSGEN_TEST_ARRAY(function, StressDerivative);
  PHYSGEN_TEST_ARRAY(virtual_call, RestShape);
  PHYSGEN_TEST_ARRAY(pointer, RestShape);
  PHYSGEN_TEST_ARRAY(algorithm, StressDerivative);
  PHYSGEN_TEST_ARRAY(either, StressDerivative);
  PHYSGEN_TEST_ARRAY(destroyed, RestShape);
  PHYSGEN_TEST_ARRAY(address, RestShape);
  PHYSGEN_TEST_ARRAY(helper, RestShape);
  PHYSGEN_TEST_ARRAY(discarded, RestShape);
  PHYSGEN_TEST_ARRAY(over, RestShape);
  PHYSGEN_TEST_ARRAY(fused_from, RestShape);
  PHYSGEN_TEST_ARRAY(fused_to, RestShape);
  PHYSGEN_TEST_ARRAY(terms, RestShape);
  PHYSGEN_TEST_ARRAY(total, RestShape);
  PHYSGEN_TEST_ARRAY(predicate, RestShape);
  PHYSGEN_TEST_ARRAY(value, RestShape);
  PHYSGEN_TEST_ARRAY(outside, RestShape);
  PHYSGEN_TEST_ARRAY(never_given, RestShape);
  PHYSGEN_TEST_ARRAY(untouched, RestShape);
};

template <class From, class To, class Copied>
struct WholeObjects {
  using Scalar = float;
  From from;
  To to;
  Copied copied;
  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    const auto [U, V, s] = from.get(i);
    to.put(i, {V, U, s});
    copied[i] = to[i];
  }
};
template <class From, class To, class Copied>
WholeObjects(From, To, Copied) -> WholeObjects<From, To, Copied>;

template <class View, class Generic>
struct Lambdas {
  using Scalar = float;
  View view;
  Generic generic;
  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    using S = lanes_t<float, I>;
    const auto read = [this](I k) -> S { return view[k].volume(); };
    const auto write = [](const auto& to, const auto& value) { to.dm_inverse()[3] = value; };
    write(generic[i], read(i));
  }
};
template <class View, class Generic>
Lambdas(View, Generic) -> Lambdas<View, Generic>;

template <class View>
struct InFunctionObject {
  using Scalar = float;
  View view;
  void operator()(index_t i) const {
    const std::function<float(index_t)> read = [this](index_t k) -> float { return view[k].x2121(); };
    view[i].x2112() = read(i);
  }
};
template <class View>
InFunctionObject(View) -> InFunctionObject<View>;

struct Reader {
  Reader() = default;
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;
  virtual ~Reader() = default;
  [[nodiscard]] virtual float read(index_t i) const = 0;
};
template <class View>
struct VolumeReader final : Reader {
  View view;
  explicit VolumeReader(const View& from) : view(from) {}
  [[nodiscard]] float read(index_t i) const override { return view[i].volume(); }
};
template <class View>
struct VirtualCall {
  using Scalar = float;
  View view;
  float* result;
  void operator()(index_t i) const {
    const std::unique_ptr<Reader> reader = std::make_unique<VolumeReader<View>>(view);
    *result = reader->read(i);
  }
};

template <class View>
float volume_of(const View& view, index_t i) {
  return view[i].volume();
}
template <class View>
struct FunctionPointer {
  using Scalar = float;
  View view;
  float* result;
  void operator()(index_t i) const {
    float (*const pointer)(const View&, index_t) = &volume_of<View>;
    *result = pointer(view, i);
  }
};

template <class View>
struct InAlgorithm {
  using Scalar = float;
  View view;
  void operator()(index_t i) const {
    const std::array<index_t, 3> neighbours{i, i + 1, i + 2};
    std::for_each(neighbours.begin(), neighbours.end(), [this](index_t k) { view[k].x3333() = 1.0F; });
  }
};
template <class View>
InAlgorithm(View) -> InAlgorithm<View>;

template <class View>
struct EitherView {
  using Scalar = float;
  View v, w;
  PHYSGEN_FUNCTION void operator()(index_t i) const {
    const View& chosen = i % 2 == 0 ? v : w;
    chosen[i].x2211() = i == 7 ? float(v[i].x3311()) : float(w[i].x3322());
  }
};
template <class View>
EitherView(View, View) -> EitherView<View>;

/// Stores when it goes out of scope.
template <class View>
struct StoresAtItsEnd {
  View view;
  index_t i;
  ~StoresAtItsEnd() { view[i].volume() = 1.0F; }
};
template <class View>
struct EndOfScope {
  using Scalar = float;
  View view;
  void operator()(index_t i) const {
    struct Member {
      StoresAtItsEnd<View> member;
    };
    const Member at_its_end{{view, i}};
  }
};
template <class View>
EndOfScope(View) -> EndOfScope<View>;

template <class View>
struct TakesAnAddress {
  using Scalar = float;
  View view;
  PHYSGEN_FUNCTION void operator()(index_t i) const { *&view[i].volume() += 1.0F; }
};
template <class View>
TakesAnAddress(View) -> TakesAnAddress<View>;

template <class View>
struct ByHelper {
  using Scalar = float;
  View view;
  PHYSGEN_FUNCTION void operator()(index_t i) const { add_one(view, i); }
};
template <class View>
ByHelper(View) -> ByHelper<View>;

template <class View>
struct Discards {
  using Scalar = float;
  View view;
  PHYSGEN_FUNCTION void operator()(index_t i) const {
    if constexpr (View::record_bytes == 0) view[i].volume() = 0.0F;
    static_assert(sizeof(view[i].volume().get()) > 0);
    view[i].dm_inverse()[0] = 0.0F;
  }
};
template <class View>
Discards(View) -> Discards<View>;

template <class From, class To>
struct Copies {
  using Scalar = float;
  From from;
  To to;
  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    const lanes_t<float, I> volume = from[i].volume();
    to[i].volume() = volume;
  }
};
template <class From, class To>
Copies(From, To) -> Copies<From, To>;

template <class View>
struct Term {
  using Scalar = float;
  View view;
  PHYSGEN_FUNCTION float operator()(index_t i) const { return view[i].volume(); }
};
template <class View>
Term(View) -> Term<View>;
template <class View>
struct Store {
  View view;
  PHYSGEN_FUNCTION void operator()(double sum) const { view[0].volume() = float(sum); }
};
template <class View>
Store(View) -> Store<View>;

template <class View>
struct IsSmall {
  View view;
  PHYSGEN_FUNCTION bool operator()() const { return view[0].volume() < 1.0F; }
};
template <class View>
IsSmall(View) -> IsSmall<View>;

/// Instantiated, but given to no executor.
template <class View>
struct NeverGiven {
  View view;
  void operator()(index_t i) const { view[i].volume() = 2.0F; }
};

template <class On>
float program(On& on, Arrays& a) {
  float result = 0;
  on.run(1, WholeObjects{a.whole.const_view(), a.put.view(), a.copied.view()});
  on.run(1, Lambdas{a.lambda.const_view(), a.generic.view()});
  on.run(1, InFunctionObject{a.function.view()});
  on.run(1, VirtualCall<decltype(a.virtual_call.const_view())>{a.virtual_call.const_view(), &result});
  on.run(1, FunctionPointer<decltype(a.pointer.const_view())>{a.pointer.const_view(), &result});
  on.run(1, InAlgorithm{a.algorithm.view()});
  on.run(1, EitherView{a.either.view(), a.either.view()});
  on.run(1, EndOfScope{a.destroyed.view()});
  on.run(1, TakesAnAddress{a.address.view()});
  on.run(1, ByHelper{a.helper.view()});
  on.run(1, Discards{a.discarded.view()});
#ifndef __CUDACC__
  on.run(1, over<float>([view = a.over.view()](auto i) { view[i].volume() = lanes_t<float, decltype(i)>(3.0F); }));
#endif
  const auto between = local<elasticity::RestShapeObject, float>();
  on.run(1, fuse(locals(between), Copies{a.fused_from.const_view(), between}, Copies{between, a.fused_to.view()}));
  on.reduce(1, Term{a.terms.const_view()}, Sum{}, Store{a.total.view()});
  typename On::Loop loop;
  on.repeat(loop, 3, [] {}, IsSmall{a.predicate.const_view()});
  result += on.value(a.value).volume;
  return result + float(a.outside.const_view()[0].volume());
}

template float program(ProbeExecutor<Space>& on, Arrays& a);
template struct NeverGiven<decltype(std::declval<Arrays&>().never_given.view())>;

}  // namespace awkward
