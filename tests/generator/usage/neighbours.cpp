// Kernels that use their own objects, others, and sums at others, by themselves and in fused kernels; read by the
// analysis. Arrays are named by what is done to them.
#include <elasticity.physgen.h>
#include <physgen/fuse.h>
#include <physgen/kernel.h>
#include <physgen/kernels/add.h>
#include <physgen/probe.h>

namespace neighbours {

using namespace physgen;

#ifdef __CUDACC__
using Space = Cuda;
#else
using Space = Host;
#endif

#define PHYSGEN_TEST_ARRAY(Tag)               \
  struct Tag##_tag {                          \
    static constexpr const char* name = #Tag; \
  };                                          \
  ProbeOf<elasticity::RestShapeArray<float, Space>, Tag##_tag> Tag

struct Arrays {
  PHYSGEN_TEST_ARRAY(from);
  PHYSGEN_TEST_ARRAY(between);
  PHYSGEN_TEST_ARRAY(to);
  PHYSGEN_TEST_ARRAY(sums);
  struct named_tag {
    static constexpr const char* name = "named";
  };
  ProbeOf<elasticity::TetArray<float, Space>, named_tag> named;
};

/// to[i] = from[i]
template <class From, class To>
struct Copy {
  using Scalar = float;
  From from;
  To to;
  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    to[i].volume() = from[i].volume().get();
  }
};
template <class From, class To>
Copy(From, To) -> Copy<From, To>;

/// to[i] = from[next]
template <class From, class To>
struct Shift {
  using Scalar = float;
  From from;
  To to;
  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    to[i].volume() = from[numbers(i) + 1].volume().get();
  }
};
template <class From, class To>
Shift(From, To) -> Shift<From, To>;

/// sums[next] += from[i]
template <class From, class To>
struct AddToNext {
  using Scalar = float;
  From from;
  To sums;
  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    add(i, sums[numbers(i) + 1].volume(), from[i].volume().get());
  }
};
template <class From, class To>
AddToNext(From, To) -> AddToNext<From, To>;

/// The index of the pack behind this one, in a fused kernel.
template <class I>
PHYSGEN_FUNCTION I next_pack(I i) {
  if constexpr (requires { i.index.begin; }) i.index.begin += i.index.width;
  return i;
}
/// to[i] = from[an object of the next pack]
template <class From, class To>
struct NextPack {
  using Scalar = float;
  From from;
  To to;
  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    to[i].volume() = from[next_pack(i)].volume().get();
  }
};
template <class From, class To>
NextPack(From, To) -> NextPack<From, To>;

template <class From, class To>
struct OneByOne {
  using Scalar = float;
  From from;
  To to;
  PHYSGEN_FUNCTION void operator()(index_t i) const { to[i].volume() = float(from[i + 1].volume()); }
};
template <class From, class To>
OneByOne(From, To) -> OneByOne<From, To>;

/// to[i] = from[i + 1] + between[i of the part that begins at 4], a template over the index of single objects
template <class From, class Between, class To>
struct Single {
  using Scalar = float;
  From from;
  Between between;
  To to;
  PHYSGEN_FUNCTION void operator()(SingleObject auto i) const {
    to[i].volume() = float(from[object_number(i) + 1].volume()) + float(between[object_of_part(4, i)].volume());
  }
};
template <class From, class Between, class To>
Single(From, Between, To) -> Single<From, Between, To>;
template <class From>
struct SumOfOwn {
  using Scalar = float;
  From from;
  PHYSGEN_FUNCTION float operator()(SingleObject auto i) const { return from[i].volume(); }
};
template <class From>
SumOfOwn(From) -> SumOfOwn<From>;
template <class To>
struct StoreSum {
  To to;
  PHYSGEN_FUNCTION void operator()(double sum) const { to[index_t{0}].volume() = static_cast<float>(sum); }
};
template <class To>
StoreSum(To) -> StoreSum<To>;

/// to[i] = from[i of the part that begins at 4], in packs
template <class From, class To>
struct OfPart {
  using Scalar = float;
  From from;
  To to;
  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    to[i].volume() = from[object_of_part(4, i)].volume().get();
  }
};
template <class From, class To>
OfPart(From, To) -> OfPart<From, To>;
/// to[i] = from[i of the part that begins at 4, and i + 4]
template <class From, class To>
struct OfPartAndNext {
  using Scalar = float;
  From from;
  To to;
  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    using S = lanes_t<float, I>;
    to[i].volume() = S(from[object_of_part(4, i)].volume()) + S(from[numbers(i) + 4].volume());
  }
};
template <class From, class To>
OfPartAndNext(From, To) -> OfPartAndNext<From, To>;

template <class Number>
PHYSGEN_FUNCTION Number behind(Number number) {
  return number ^ 1;
}
template <class Number>
PHYSGEN_FUNCTION Number unpacked(const Number& packed) {
  return packed >> 2;
}

/// to[i] = from[what `named` names], and of others by numbers that are named, calculated before, stated, and given
template <class Named, class From, class To, class Stated, class Given>
struct ByNumbers {
  using Scalar = float;
  Named named;
  From from;
  To to;
  Stated stated;
  Given given;
  index_t place;
  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    using S = lanes_t<float, I>;
    using Number = lanes_t<std::int32_t, I>;
    const Number packed = named[i].nodes()[1], shifted = packed >> 2, next = shifted + 1;
    S sum = S(from[Number(named[i].nodes()[0])].volume()) + S(from[shifted].volume());
    for (int k = 0; k < 2; ++k) sum = sum + S(from[Number(named[i].nodes()[k + 1])].volume());
    to[i].volume() = S(sum + S(to[next].volume()) + S(stated[index_t{0}].volume()) + S(given[place].volume()));
  }
};
template <class N, class F, class T, class S, class G>
ByNumbers(N, F, T, S, G, index_t) -> ByNumbers<N, F, T, S, G>;

/// The same by a number that is assigned to, and by what functions return.
template <class Named, class From, class To, class Changed>
struct ByChangedNumbers {
  using Scalar = float;
  Named named;
  From from;
  To to;
  Changed changed;
  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    using S = lanes_t<float, I>;
    using Number = lanes_t<std::int32_t, I>;
    Number kept = named[i].nodes()[0], later = kept;
    later = later + kept;
    const S sum = S(from[kept].volume()) + S(from[unpacked(kept)].volume()) + S(changed[later].volume());
    to[i].volume() = S(sum + S(to[behind(kept)].volume()));
  }
};
template <class N, class F, class T, class C>
ByChangedNumbers(N, F, T, C) -> ByChangedNumbers<N, F, T, C>;

template <class On>
void program(On& on, Arrays& a) {
#if defined(PHYSGEN_TEST_STEP)
  on.run(1, PHYSGEN_TEST_STEP);
#else
  on.run(1, Copy{a.from.view(), a.to.view()});
  on.run(1, Shift{a.from.view(), a.to.view()});
  on.run(1, AddToNext{a.from.view(), a.sums.view()});
  on.run(1, OneByOne{a.from.view(), a.to.view()});
  on.run(1, Single{a.from.const_view(), a.between.view(), a.to.view()});
  on.run(1, lanes<1>(Single{a.from.const_view(), a.between.view(), a.sums.view()}));
  on.run(1, OfPart{a.between.view(), a.to.view()});
  on.run(1, OfPartAndNext{a.between.view(), a.to.view()});
  on.run(1, ByNumbers{a.named.const_view(), a.from.const_view(), a.to.view(), a.between.const_view(),
                      a.sums.const_view(), index_t{3}});
  on.run(1, ByChangedNumbers{a.named.const_view(), a.from.const_view(), a.to.view(), a.between.const_view()});
  on.reduce(1, SumOfOwn{a.from.const_view()}, Sum{}, StoreSum{a.sums.view()});
  on.run(1, fuse(locals(), Copy{a.from.view(), a.between.view()}, Copy{a.between.view(), a.to.view()},
                 AddToNext{a.to.view(), a.sums.view()}, AddToNext{a.between.view(), a.sums.view()}));
#endif
}

template void program(ProbeExecutor<Space>& on, Arrays& a);

}  // namespace neighbours
