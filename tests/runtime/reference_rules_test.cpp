// Which expressions over references compile: those that mean the same for one object, a pack and any storage format.
// All is static_asserts; refused_references.cpp checks the messages of what does not compile.
#include <physgen/kernel.h>
#include <physgen/parallel_for.h>

#include "test_objects.h"

namespace physgen::test {
namespace {

using elasticity::NodePositionArray;
using elasticity::StressDerivativeArray;

using Position = NodePositionArray<float>::View;
using OnePosition = Position::Ref<index_t>;
using PackPosition = Position::Ref<Pack<native_lanes<float>>>;
using GatheredPosition = Position::Ref<batch_t<std::int32_t, native_lanes<float>>>;
using Derivative = StressDerivativeArray<float>::View;
using PackDerivative = Derivative::Ref<Pack<native_lanes<float>>>;
using GatheredDerivative = Derivative::Ref<batch_t<std::int32_t, native_lanes<float>>>;
using Rotations = elasticity::DeformationSvdArray<float>::View::Ref<index_t>;
using S = batch_t<float, native_lanes<float>>;

template <class Object>
using FieldX = decltype(std::declval<const Object&>().x());
template <class Object>
using Element = decltype(std::declval<const Object&>().x1111());
template <class Object>
using FieldU = decltype(std::declval<const Object&>().U());

template <class T>
concept IsACondition = requires(T mask) { mask ? 1 : 2; };
template <class Ref>
concept ReadByName = std::is_convertible_v<const Ref&, typename Ref::Value> || requires(const Ref ref) { ref.get(); };
template <class Ref>
concept ReadAsTemporary = requires(Ref (*make)()) {
  requires std::is_convertible_v<Ref, typename Ref::Value>;
  make().get();
};
template <class Ref>
concept AssignedByName = requires(Ref ref, typename Ref::Value value) { ref = value; } || requires(Ref ref, Ref other) {
  ref = other;
} || requires(Ref ref, typename Ref::Value value) { ref += value; };
template <class Ref>
concept CompoundAssigned = requires(const Ref ref, typename Ref::Value value) { ref += value; };

static_assert(!IsACondition<decltype(S() > S())>);
static_assert(!IsACondition<typename batch_t<double, native_lanes<double>>::batch_bool_type>);
static_assert(!IsACondition<typename batch_t<std::int32_t, native_lanes<float>>::batch_bool_type>);
static_assert(!std::is_constructible_v<bool, S::batch_bool_type>);

static_assert(!ReadByName<FieldX<OnePosition>> && ReadAsTemporary<FieldX<OnePosition>>);
static_assert(!ReadByName<FieldX<PackPosition>> && ReadAsTemporary<FieldX<PackPosition>>);
static_assert(!ReadByName<Element<PackDerivative>> && ReadAsTemporary<Element<PackDerivative>>);
static_assert(!AssignedByName<FieldX<OnePosition>> && !AssignedByName<FieldX<PackPosition>>);
static_assert(!AssignedByName<Element<PackDerivative>>);
static_assert(!std::is_move_assignable_v<FieldX<OnePosition>> && !std::is_move_assignable_v<OnePosition> &&
                  !std::is_move_assignable_v<Element<PackDerivative>>,
              "std::swap, std::sort and std::rotate need it");

// The result of get() is const where it is a class.
template <class Ref>
concept WritesToATemporary = requires(Ref (*make)(), typename Ref::Value value) { make().get() += value; };
static_assert(!WritesToATemporary<FieldX<OnePosition>> && !WritesToATemporary<FieldX<PackPosition>> &&
              !WritesToATemporary<Element<PackDerivative>>);
static_assert(std::is_const_v<decltype(std::declval<OnePosition>().get())>);

// The three steps of a swap by hand would read the saved object after it was overwritten.
template <class Ref>
concept AssignedFromAName = requires(const Ref to, const Ref from) { to = from; };
static_assert(!AssignedFromAName<OnePosition> && !AssignedFromAName<PackPosition> &&
              !AssignedFromAName<FieldX<OnePosition>> && !AssignedFromAName<Element<PackDerivative>>);
template <class Ref>
concept AssignedBraces = requires(const Ref to) { to = {}; };
static_assert(!AssignedBraces<FieldX<OnePosition>>, "Eigen's values are not initialised by {}");
static_assert(std::is_const_v<decltype(std::declval<Position>().get(index_t{0}))>);

// Integers of a pack beside numbers that they cannot hold: one object calculates in the number's type.
using Integers = batch_t<std::int32_t, native_lanes<float>>;
template <class Number>
concept BesideIntegers = requires(Integers n, Number x) { n * x; } || requires(Integers n, Number x) { x + n; } ||
                         requires(Integers n, Number x) { n < x; } || requires(Integers n, Number x) { x == n; } ||
                         requires(Integers n, Number x) { math::max(n, x); };
static_assert(BesideIntegers<int> && !BesideIntegers<float> && !BesideIntegers<double> && !BesideIntegers<index_t>);
using PackEnds = elasticity::EdgeArray<float>::View::Ref<Pack<native_lanes<float>>>;
template <class Number>
concept AddedToIntegers = requires(PackEnds ends, Number x) { ends.nodes()[0] += x; };
static_assert(AddedToIntegers<int> && !AddedToIntegers<double>);

// Sums through gathered indices need add().
static_assert(CompoundAssigned<FieldX<OnePosition>> && CompoundAssigned<FieldX<PackPosition>> &&
              CompoundAssigned<Element<PackDerivative>>);
static_assert(!CompoundAssigned<FieldX<GatheredPosition>> && !CompoundAssigned<Element<GatheredDerivative>>);

// A rotation is assigned and set to the identity, no more.
template <class Ref>
concept SetToZero = requires(const Ref ref) { ref.setZero(); };
template <class Ref>
concept SetToIdentity = requires(const Ref ref) { ref.setIdentity(); };
static_assert(SetToZero<FieldX<OnePosition>> && !SetToIdentity<FieldX<OnePosition>>);
static_assert(!SetToZero<FieldU<Rotations>> && SetToIdentity<FieldU<Rotations>> &&
              !CompoundAssigned<FieldU<Rotations>>);
template <class Ref>
concept Scaled = requires(const Ref ref) { ref *= 2.0F; };
static_assert(Scaled<FieldX<OnePosition>> && !Scaled<FieldU<Rotations>>);

// A field of several elements is no value; an element is.
template <class Ref>
concept Calculates = requires(Ref (*make)(), typename Ref::Value value) { make() + value; } ||
                     requires(Ref (*make)()) { make() * 2.0F; } || requires(Ref (*make)()) { -make(); };
static_assert(!Calculates<FieldX<OnePosition>> && !Calculates<FieldX<PackPosition>>);
static_assert(Calculates<Element<PackDerivative>>);

// Views know their space.
template <class Space>
using ViewIn = NodePositionArray<float, Space, Soa>::View;
static_assert(std::is_convertible_v<ViewIn<PinnedHost>, ViewIn<Cuda>> &&
              std::is_convertible_v<ViewIn<PinnedHost>, ViewIn<Host>>);
static_assert(!std::is_convertible_v<ViewIn<Host>, ViewIn<Cuda>> &&
              !std::is_convertible_v<ViewIn<Cuda>, ViewIn<Host>> &&
              !std::is_convertible_v<ViewIn<Host>, ViewIn<PinnedHost>>);

}  // namespace
}  // namespace physgen::test
