// Kernels over particles that can be steps of a fused kernel, and kernels each of which cannot for one reason.
#pragma once

#include <string>

namespace physgen::test {

inline const std::string particles_schema = R"(#include <physgen/schema.h>
namespace m {
using namespace physgen::schema;
struct PHYSGEN_OBJECT() Particle { Scalar a; Vector<3> x; };
struct PHYSGEN_OBJECT() Link { Index to; };
struct PHYSGEN_OBJECT() Total { Scalar a; };
}
)";

inline const std::string particles_kernels = R"(#pragma once
#include <particles.physgen.h>
#include <physgen/kernels/add.h>
#include <physgen/kernel.h>
#include <physgen/kernels/lanes.h>
#define STEP(NAME) template <class... V> NAME(V...) -> NAME<V...>;

/// Both fields.
template <class From, class To>
struct Copy {
  using Scalar = typename To::Precision;
  From from;
  To to;
  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    to[i].a() = physgen::lanes_t<Scalar, I>(from[i].a());
    to[i].x() = from[i].x().get();
  }
};
STEP(Copy)
template <class From, class To>
struct CopyBack {
  using Scalar = typename To::Precision;
  From from;
  To to;
  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const { to.put(i, from.get(i)); }
};
STEP(CopyBack)
template <class Links, class From, class To>
struct Gather {
  using Scalar = typename To::Precision;
  Links links;
  From from;
  To to;
  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    to[i].a() = physgen::lanes_t<Scalar, I>(from[links[i].to()].a());
  }
};
STEP(Gather)
template <class Links, class From, class To>
struct Scatter {
  using Scalar = typename To::Precision;
  Links links;
  From from;
  To to;
  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    using S = physgen::lanes_t<Scalar, I>;
    to[i].a() = S(1);
    physgen::add(i, to[links[i].to()].a(), S(from[i].a()));
  }
};
STEP(Scatter)
template <class From, class To>
struct CopySome {
  using Scalar = typename To::Precision;
  From from;
  To to;
  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    using S = physgen::lanes_t<Scalar, I>;
    const S a = from[i].a();
    if (!physgen::any(i, a > S(0))) return;
    to[i].a() = a;
  }
};
STEP(CopySome)
template <class From, class To>
struct CopyOrLeave {
  using Scalar = typename To::Precision;
  From from;
  To to;
  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    using S = physgen::lanes_t<Scalar, I>;
    const S a = ({
      if (!physgen::any(i, S(from[i].a()) > S(0))) return;
      S(from[i].a());
    });
    to[i].a() = a;
  }
};
STEP(CopyOrLeave)
inline float last = 0;
template <class From, class To>
struct CopyRemembering {
  using Scalar = typename To::Precision;
  float* remembered;
  From from;
  To to;
  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const { to[i].a() = physgen::lanes_t<Scalar, I>(from[i].a()); }
};
template <class From, class To>
CopyRemembering(float*, From, To) -> CopyRemembering<From, To>;
template <class From, class To>
struct CopyCounting {
  using Scalar = typename To::Precision;
  From from;
  To to;
  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    to[i].a() = physgen::lanes_t<Scalar, I>(from[i].a());
    ++last;
  }
};
STEP(CopyCounting)
template <class From, class To>
struct CopyElement {
  using Scalar = typename To::Precision;
  From from;
  To to;
  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const { to[i].x()[1] = physgen::lanes_t<Scalar, I>(from[i].a()); }
};
STEP(CopyElement)
template <class From, class To>
struct CopyVector {
  using Scalar = typename To::Precision;
  From from;
  To to;
  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const { to[i].x() = from[i].x().get(); }
};
STEP(CopyVector)
template <class From, class To>
struct CopyOne {
  using Scalar = typename To::Precision;
  From from;
  To to;
  PHYSGEN_FUNCTION void operator()(physgen::index_t i) const { to[i].a() = Scalar(from[i].a()); }
};
STEP(CopyOne)
template <class From, class To>
struct CopyByIndex {
  using Scalar = typename To::Precision;
  From from;
  To to;
  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    using S = physgen::lanes_t<Scalar, I>;
    if constexpr (std::is_integral_v<I>) {
      to[i].a() = S(from[i].a());
    } else {
      to[i].a() = S(from[i].a()) * S(2);
    }
  }
};
STEP(CopyByIndex)
template <class To>
struct Limit {
  using Scalar = typename To::Precision;
  To to;
  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    using S = physgen::lanes_t<Scalar, I>;
    physgen::store_where(S(to[i].a()) > S(1), to[i].a(), S(1));
  }
};
STEP(Limit)
template <class From>
struct Value {
  using Scalar = typename From::Precision;
  From from;
  template <class I>
  PHYSGEN_FUNCTION auto operator()(I i) const { return physgen::lanes_t<Scalar, I>(from[i].a()); }
};
STEP(Value)
template <class To>
struct Keep {
  To to;
  PHYSGEN_FUNCTION void operator()(double sum) const { to[physgen::index_t{0}].a() = float(sum); }
};
STEP(Keep)
inline float told(float number) { return number; }
template <class From, class To>
struct Shift {
  using Scalar = typename To::Precision;
  float by;
  From from;
  To to;
  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    using S = physgen::lanes_t<Scalar, I>;
    to[i].a() = S(from[i].a()) + S(by);
  }
};
template <class From, class To>
Shift(float, From, To) -> Shift<From, To>;
)";

}  // namespace physgen::test
