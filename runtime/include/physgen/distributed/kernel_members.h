// The views that a kernel holds, found in its members: which arrays a step uses. And the names of kernels, by which the
// table of halo_uses.h knows them.
#pragma once

#include <physgen/arrays/view.h>
#include <physgen/distributed/kernel_view.h>
#include <physgen/fuse.h>
#include <physgen/kernels/object_numbers.h>
#include <physgen/launch/in_lanes.h>
#include <physgen/rows.h>

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <type_traits>

namespace physgen {

/// A kernel that this finds views in is an aggregate: a struct without constructors, bases and private members, whose
/// members are views, Rows, numbers, and structs of such. Calls visit(KernelView) for each view, in the order in which
/// halo_uses.h numbers them.
template <class Kernel, class Visit>
void for_each_view(const Kernel& kernel, const Visit& visit);

/// Calls visit(kernel) for a kernel, or for each step of a fused one.
template <class Kernel, class Visit>
void for_each_kernel(const Kernel& kernel, const Visit& visit);

/// "physgen::fem::ComputeSvd" of all its instances.
template <class Kernel>
[[nodiscard]] const std::string& name_of_kernel();

namespace detail {

/// Stands for a member of any type.
struct AnyMember {
  template <class T>
  constexpr operator T() const;  // NOLINT: only declared
};
template <std::size_t>
using AnyMemberAt = AnyMember;
template <class T, class Places>
inline constexpr bool is_made_of = false;
template <class T, std::size_t... k>
  requires requires { T{AnyMemberAt<k>{}...}; }
inline constexpr bool is_made_of<T, std::index_sequence<k...>> = true;

inline constexpr std::size_t most_members = 24;

/// The number of members of an aggregate; more than most_members: not known.
template <class T, std::size_t n = most_members>
constexpr std::size_t member_count() {
  if constexpr (is_made_of<T, std::make_index_sequence<most_members + 1>>) {
    return most_members + 1;
  } else if constexpr (n == 0 || is_made_of<T, std::make_index_sequence<n>>) {
    return n;
  } else {
    return member_count<T, n - 1>();
  }
}

template <class T>
inline constexpr bool is_view = false;
template <class Object, class Real, class Layout, class Formats, class Space>
inline constexpr bool is_view<View<Object, Real, Layout, Formats, Space>> = true;
template <class T>
inline constexpr bool is_rows = false;
template <class Ranges, class Entries>
inline constexpr bool is_rows<Rows<Ranges, Entries>> = true;
template <class T>
inline constexpr bool is_fused = false;
template <class Locals, class... Step>
inline constexpr bool is_fused<Fused<Locals, Step...>> = true;
template <class T>
inline constexpr bool is_local = false;
template <class Object, class Real, class Formats, class Tag, class Layout>
inline constexpr bool is_local<Local<Object, Real, Formats, Tag, Layout>> = true;
template <class T>
inline constexpr bool is_fixed_array = false;
template <class T, std::size_t n>
inline constexpr bool is_fixed_array<std::array<T, n>> = true;

// In these every member is a name of its own, as structured bindings have it.
#define PHYSGEN_MEMBERS(count, ...)                  \
  else if constexpr (member_count<T>() == (count)) { \
    const auto& [__VA_ARGS__] = of;                  \
    each(__VA_ARGS__);                               \
  }
/// Calls each(members...) with all members of an aggregate.
template <class T, class Each>
void with_members(const T& of, const Each& each) {
  if constexpr (member_count<T>() == 0) {
    each();
  }
  PHYSGEN_MEMBERS(1, a)
  PHYSGEN_MEMBERS(2, a, b)
  PHYSGEN_MEMBERS(3, a, b, c)
  PHYSGEN_MEMBERS(4, a, b, c, d)
  PHYSGEN_MEMBERS(5, a, b, c, d, e)
  PHYSGEN_MEMBERS(6, a, b, c, d, e, f)
  PHYSGEN_MEMBERS(7, a, b, c, d, e, f, g)
  PHYSGEN_MEMBERS(8, a, b, c, d, e, f, g, h)
  PHYSGEN_MEMBERS(9, a, b, c, d, e, f, g, h, i)
  PHYSGEN_MEMBERS(10, a, b, c, d, e, f, g, h, i, j)
  PHYSGEN_MEMBERS(11, a, b, c, d, e, f, g, h, i, j, k)
  PHYSGEN_MEMBERS(12, a, b, c, d, e, f, g, h, i, j, k, l)
  PHYSGEN_MEMBERS(13, a, b, c, d, e, f, g, h, i, j, k, l, m)
  PHYSGEN_MEMBERS(14, a, b, c, d, e, f, g, h, i, j, k, l, m, n)
  PHYSGEN_MEMBERS(15, a, b, c, d, e, f, g, h, i, j, k, l, m, n, o)
  PHYSGEN_MEMBERS(16, a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p)
  PHYSGEN_MEMBERS(17, a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q)
  PHYSGEN_MEMBERS(18, a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r)
  PHYSGEN_MEMBERS(19, a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s)
  PHYSGEN_MEMBERS(20, a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t)
  PHYSGEN_MEMBERS(21, a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u)
  PHYSGEN_MEMBERS(22, a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u, v)
  PHYSGEN_MEMBERS(23, a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u, v, w)
  PHYSGEN_MEMBERS(24, a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u, v, w, x)
}
#undef PHYSGEN_MEMBERS

/// Eigen's matrices and vectors are numbers.
template <class T>
concept OfNumbers = std::is_arithmetic_v<T> || std::is_enum_v<T> || std::is_empty_v<T> ||
                    std::is_same_v<T, ObjectNumbers> || requires { T::RowsAtCompileTime; };

template <class T>
concept Shown = std::is_aggregate_v<T> && !std::is_array_v<T>;

template <class Member, class Visit>
void visit_member(const Member& member, const Visit& visit) {
  if constexpr (is_view<Member>) {
    const UntypedArray array = member.untyped();
    visit(KernelView{array.base, array.size, !std::is_const_v<typename Member::Byte>, array.object});
  } else if constexpr (is_rows<Member>) {
    visit_member(member.ranges(), visit);
    visit_member(member.entries(), visit);
  } else if constexpr (is_local<Member>) {
    visit(KernelView{nullptr, 0, true, Member::Object::name});  // it has a number, as the views of stored arrays do
  } else if constexpr (is_fixed_array<Member>) {
    for (const auto& element : member) visit_member(element, visit);
  } else if constexpr (!OfNumbers<Member>) {
    static_assert(Shown<Member> && member_count<Member>() <= most_members,
                  "DistributedExecutor finds the arrays that a step uses in the members of its kernel, and a lambda, a "
                  "pointer or a class with constructors does not show them: write the kernel as a struct of views, "
                  "Rows and numbers, of 24 members at most");
    if constexpr (Shown<Member> && member_count<Member>() <= most_members) {
      with_members(member, [&](const auto&... one) { (visit_member(one, visit), ...); });
    }
  }
}

template <class Steps, class Visit>
void visit_steps(const Steps& steps, const Visit& visit) {
  for_each_kernel(steps.step, visit);
  if constexpr (requires { steps.rest; }) visit_steps(steps.rest, visit);
}

/// The name of T in what compilers call this function, without template arguments.
template <class T>
std::string name_of_type() {
  std::string_view all = __PRETTY_FUNCTION__;
  all.remove_prefix(all.find("T = ") + 4);
  std::string name;
  int depth = 0;
  for (const char c : all) {
    if (depth == 0 && (c == ';' || c == ']')) break;
    if (c == '<') ++depth;
    if (depth == 0) name += c;
    if (c == '>') --depth;
  }
  constexpr std::string_view of_gcc = "{anonymous}", of_clang = "(anonymous namespace)";
  for (auto at = name.find(of_gcc); at != std::string::npos; at = name.find(of_gcc)) {
    name.replace(at, of_gcc.size(), of_clang);
  }
  return name;
}

}  // namespace detail

template <class Kernel, class Visit>
void for_each_view(const Kernel& kernel, const Visit& visit) {
  detail::visit_member(kernel, visit);
}

template <class Kernel, class Visit>
void for_each_kernel(const Kernel& kernel, const Visit& visit) {
  if constexpr (detail::states_lanes<Kernel>) {
    for_each_kernel(kernel.kernel, visit);
  } else if constexpr (detail::is_fused<Kernel>) {
    detail::visit_steps(kernel.steps, visit);
  } else {
    visit(kernel);
  }
}

template <class Kernel>
const std::string& name_of_kernel() {
  static const std::string name = detail::name_of_type<Kernel>();
  return name;
}

}  // namespace physgen
