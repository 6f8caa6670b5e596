// A scene of kernels that hide what they read, or compute something else where fields are pruned: each line says in a
// comment what physgen finds in it. What has no comment is harmless.
#pragma once

#include <elasticity.physgen.h>
#include <physgen/scene.h>

#include <array>
#include <bit>
#include <concepts>
#include <cstring>
#include <optional>
#include <tuple>
#include <typeinfo>
#include <variant>

namespace hidden {

using namespace physgen;

// clang-format off
template <class V> constexpr int bytes_of() { return V::record_bytes; }  // depends
template <class V> constexpr bool is_large = V::record_bytes > 64;  // depends
template <class V> struct Member { int bytes = V::record_bytes; };  // depends
template <class V> struct StaticMember { static inline int bytes = V::record_bytes; };  // depends
template <class V> struct Enumerator { enum : int { bytes = V::record_bytes }; };
template <class V, bool large = (V::record_bytes > 64)> struct Chosen { static float of(float x) { return x; } };  // depends
template <class V> struct Chosen<V, true> { static float of(float x) { return 2 * x; } };  // depends
template <class O, class R, class L, class F, class S> constexpr bool is_native(const View<O, R, L, F, S>*) { return std::is_same_v<typename F::U, format::Native>; }  // depends
inline float by_type(float x) { return x; }  // depends
template <class Element> float by_type(Element&& x) { return 2 * static_cast<Element&&>(x).get(); }  // depends
template <class Ref> concept PlainU = requires(const Ref& ref) { { ref.U()[0] } -> std::same_as<float&>; };
template <class V> float again(const V& view, index_t i, int n) { return n == 0 ? float(view[i].s()[0]) : again(view, i, n - 1); }
template <class V> struct Overlaid { const float* first; index_t size; };

template <class In, class Out>
struct Kernel {
  using Scalar = float;
  In in;
  Out out;

  static void keep(float& to, float x) { to = x; }

  PHYSGEN_FUNCTION void operator()(index_t i) const {
    const float x = in[i].s()[0];
    float y = x;
    // How fields are stored.
    if constexpr (std::is_same_v<typename In::Formats::U, format::Native>) y += float(in[i].U()[0]);  // depends
    if constexpr (In::record_bytes > 64) y *= 2;  // depends
    if constexpr (is_large<In>) y *= 2;  // depends
    if constexpr (format::StoresNothing<typename In::Formats::U>) y *= 2;  // depends
    if constexpr (std::is_reference_v<decltype(in[i].U()[0])>) y *= 2;  // depends
    if constexpr (requires { [](const float&) {}(in[i].U()[0]); keep(y, 1.0F); }) y += float(in[i].s()[1]);
    if constexpr (requires { const_cast<float*>(&in[i].U()[0])[1]; }) y *= 2;
    if constexpr (PlainU<decltype(in[i])>) y *= 2;  // depends
    if constexpr (noexcept(float(std::declval<decltype(in[i].U()[0])>()))) y *= 2;  // depends
    if constexpr (is_native(static_cast<const In*>(nullptr))) y *= 2;  // depends
    if constexpr (requires { in.data(); }) y *= 2;
    y += float(In::record_bytes);  // depends
    y += float(In::Formats::U::scale);  // depends
    y += float(In::Record::bytes);  // depends
    y += float(alignof(typename In::template Ref<index_t>));
    y += float(sizeof(in[i].U()[0]));  // depends, not followed
    y += float(std::array<char, In::record_bytes + 1>{}.size());  // depends
    y += float(std::integral_constant<int, In::record_bytes>());  // depends
    y += float(std::get<(In::record_bytes > 64 ? 1 : 0)>(std::tuple<float, float>(1.0F, 2.0F)));  // depends
    const std::conditional_t<(In::record_bytes > 64), float, double> rounded = x;  // depends
    y += float(rounded);
    static const float once = float(bytes_of<In>());  // depends
    y += once;
    y += float(Member<In>().bytes) + float(Enumerator<In>::bytes);  // depends
    y += float(StaticMember<In>::bytes);
    y += Chosen<In>::of(x) + by_type(in[i].U()[0]);
    y += float(typeid(In).hash_code() % 3);  // not followed
    y += in.losses() != nullptr ? 1.0F : 0.0F;
    y += again(in, i, 2);
    y += float(in.size()) + float(sizeof(lanes_t<float, index_t>)) + float(In::Layout::contiguous(4));
    // What lies in memory.
    const float* const first = &in[i].V()[0];  // not followed
    y += first[1];
    const float& second = *&in[i].V()[1];  // not followed
    y += (&second)[1];
    y += *&in[i].V()[2];
    struct { const float* third; } holder{&in[i].V()[3]};  // not followed
    y += holder.third[1];
    In copy(in);
    std::memcpy(&copy, &in, sizeof copy);  // not followed
    const void* const bytes = &in;  // not followed
    y += (*static_cast<const In*>(bytes))[i].s()[0];
    y += std::bit_cast<Overlaid<In>>(in).first[i];  // not followed
    union Union { In view; Overlaid<In> overlaid; explicit Union(const In& of) : view(of) {} };
    y += Union(in).overlaid.first[i];  // not followed
    // What may be done.
    const std::optional<In> maybe(in);
    y += (*maybe)[i].s()[0];
    const std::variant<int, In> either(in);
    y += std::get<In>(either)[i].s()[0];
    const std::array<In, 2> two{in, in};
    y += two[1][i].s()[0];
    out[i].s()[0] = y;
    out[i].s()[1] = y;
    out[i].s()[2] = y;
  }
};
// clang-format on
template <class In, class Out>
Kernel(In, Out) -> Kernel<In, Out>;

}  // namespace hidden

namespace scenes {
using namespace physgen::scene;

struct PHYSGEN_SCENE() hidden {
  using Real = float;
  struct Body {
    PHYSGEN_ARRAY(per("tet"), input()) Array<elasticity::DeformationSvdObject, Real> in;
    PHYSGEN_ARRAY(per("tet"), output("s")) Array<elasticity::DeformationSvdObject, Real> out;
  };
  template <class On, class Body>
  static void program(On& on, Body& body) {
    on.run(body.in.size(), ::hidden::Kernel{body.in.view(), body.out.view()});
    if constexpr (requires { body.in.untyped(); }) on.run(1, ::hidden::Kernel{body.in.view(), body.out.view()});  // depends
  }
};

}  // namespace scenes
