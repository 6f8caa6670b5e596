// A scene of kernels that hide what they read, or compute something else where fields are pruned: each line says in a
// comment what physgen finds in it. What has no comment is harmless.
#pragma once

#include <elasticity.physgen.h>
#include <physgen/layout/uniform.h>
#include <physgen/scene.h>

#include <any>
#include <array>
#include <bit>
#include <concepts>
#include <cstring>
#include <memory>
#include <new>
#include <optional>
#include <source_location>
#include <span>
#include <string_view>
#include <tuple>
#include <typeinfo>
#include <utility>
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
template <class V> concept TwelveBytes = V::record_bytes == 12;
template <class V> concept Writable = requires(const V& view) { view[0].s() = view[1].s().get(); };
inline float by_kind(std::true_type) { return 1; }  // depends
inline float by_kind(std::false_type) { return 2; }  // depends
template <class V, bool other> using Kind = std::bool_constant<std::is_same_v<typename V::Formats::V, format::Native> != other>;
template <class T> int& counter(const T&) {
  static int n = 0;
  return ++n;  // depends
}
struct Box { virtual ~Box() = default; };
template <class T> struct BoxOf : Box {};
template <class T> BoxOf<T> boxed(const T&) { return {}; }  // depends
template <class V> decltype(auto) element(const V& view, index_t i) { return *&view[i].V()[2]; }
template <class V> decltype(auto) same_element(const V& view, index_t i) { return element(view, i); }
inline float any_arguments(int n, ...) { return float(n); }
template <class V> struct Overlaid { const float* first; index_t size; };

template <class In, class Out, class Same>
struct Kernel {
  using Scalar = float;
  In in;
  Out out;
  Same same;

  static void keep(float& to, float x) { to = x; }

  PHYSGEN_FUNCTION void operator()(index_t i) const {
    const float x = in[i].s()[0];
    float y = x;
    // How fields are stored.
    if constexpr (std::is_same_v<typename In::Formats::U, format::Native>) y += float(in[i].U()[0]);  // depends
    if constexpr (In::record_bytes > 64) y *= 2;  // depends
    if constexpr (is_large<In>) y *= 2;  // depends
    if constexpr (format::StoresNothing<typename Out::Formats::U>) y *= 2;  // depends
    if constexpr (std::is_reference_v<decltype(in[i].U()[0])>) y *= 2;  // depends
    if constexpr (requires { [](const float&) {}(in[i].U()[0]); keep(y, 1.0F); }) y += float(in[i].s()[1]);
    if constexpr (requires { const_cast<float*>(&in[i].V()[0])[1]; }) y *= 2;
    if constexpr (PlainU<decltype(in[i])>) y *= 2;  // depends
    if constexpr (noexcept(float(std::declval<decltype(in[i].U()[0])>()))) y *= 2;  // depends
    if constexpr (is_native(static_cast<const In*>(nullptr))) y *= 2;  // depends
    if constexpr (requires { in.data(); }) y *= 2;
    y += float(In::record_bytes);  // depends
    y += float(In::Formats::U::scale);
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
    y += Chosen<In>::of(x) + by_type(in[i].s()[0]);
    y += float(typeid(In).hash_code() % 3);  // not followed
    y += in.losses() != nullptr ? 1.0F : 0.0F;
    y += again(in, i, 2);
    y += float(in.size()) + float(sizeof(lanes_t<float, index_t>)) + float(In::Layout::contiguous(4));
    // Facts of the scene's own arrays alone.
    if constexpr (TwelveBytes<Same>) y *= 2;  // depends
    const std::conditional_t<Same::record_bytes == 12, float, double> of_twelve = x;  // depends
    y += float(of_twelve);
    if constexpr (requires { same[i].s()[0] = 1.0F; }) y *= 2;  // depends
    if constexpr (std::is_assignable_v<decltype(same[i].s()[0]), float>) y *= 2;  // depends
    if constexpr (std::is_const_v<typename Same::Byte>) y *= 2;  // depends
    if constexpr (Writable<Same>) y *= 2;
    if constexpr (std::is_same_v<typename Same::Layout, Uniform>) y *= 2;  // depends
    y += float(same[i].s()[0]);
    y += by_kind(Kind<In, false>()) + 3 * by_kind(Kind<In, true>());
    y += float(counter(in[i].V()[1]));
    const auto box = boxed(in[i].V()[1]);
    y += dynamic_cast<const BoxOf<float>*>(static_cast<const Box*>(&box)) != nullptr ? 1.0F : 0.0F;
    // The contents of memory.
    const float* const first = &in[i].V()[0];  // not followed
    y += first[1];
    const float& second = *&in[i].V()[1];  // not followed
    y += (&second)[1];
    y += *&in[i].V()[2];
    y += element(in, i) + same_element(in, i);
    const float& third_of = same_element(in, i);  // not followed
    y += (&third_of)[1];
    const auto& assigned = (*&out[i].V()[0] = y);  // not followed
    y += (&assigned)[1];
    struct { const float* third; } holder{&in[i].V()[3]};  // not followed
    y += holder.third[1];
    In copy(in);
    std::memcpy(&copy, &in, sizeof copy);  // not followed
    const void* const bytes = &in;  // not followed
    y += (*static_cast<const In*>(bytes))[i].s()[0];  // not followed
    y += std::bit_cast<Overlaid<In>>(in).first[i];  // not followed
    y += __builtin_bit_cast(Overlaid<In>, in).first[i];  // not followed
    y += float(std::as_bytes(std::span<const In, 1>(&in, 1)).size());  // not followed
    alignas(16) std::array<unsigned char, 64> room{};
    y += (*new (room.data()) In(in))[i].s()[0] + float(room[0]);  // not followed
    y += any_arguments(1, in);  // not followed
    asm volatile("" : : "m"(in));  // not followed
    auto&& named = in[i].V()[3];
    y += std::move(*(&named + 1));  // not followed
    y += std::move(*(std::addressof(named) + 1));  // not followed
    union Union { In view; Overlaid<In> overlaid; explicit Union(const In& of) : view(of) {} };
    y += Union(in).overlaid.first[i];  // not followed
    y += float(__PRETTY_FUNCTION__[40] + __func__[0]);  // not followed
    y += float(std::source_location::current().function_name()[40]);  // not followed
    const std::any any(in[i].V()[1]);  // not followed
    y += std::any_cast<float>(&any) != nullptr ? 1.0F : 0.0F;
    if (y < -1e30F) throw in[i].V()[1];  // not followed
    // Code that is allowed.
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
template <class In, class Out, class Same>
Kernel(In, Out, Same) -> Kernel<In, Out, Same>;

}  // namespace hidden

namespace scenes {
using namespace physgen::scene;

struct PHYSGEN_SCENE() hidden {
  using Real = float;
  struct Body {
    PHYSGEN_ARRAY(per("tet"), input()) Array<elasticity::DeformationSvdObject, Real> in;
    PHYSGEN_ARRAY(per("tet"), input(), uniform()) Array<elasticity::DeformationSvdObject, Real> same;
    PHYSGEN_ARRAY(per("tet"), output("s")) Array<elasticity::DeformationSvdObject, Real> out;
  };
  template <class On, class Body>
  static void program(On& on, Body& body) {
    on.run(body.in.size(), ::hidden::Kernel{body.in.view(), body.out.view(), body.same.view()});
    // clang-format off
    if constexpr (requires { body.in.untyped(); }) on.run(1, ::hidden::Kernel{body.in.view(), body.out.view(), body.same.view()});  // depends
    // clang-format on
  }
};

}  // namespace scenes
