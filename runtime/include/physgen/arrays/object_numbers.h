// Lists of object numbers: the objects that a change of topology keeps, their order, and their new numbers.
#pragma once

#include <physgen/config.h>

#include <span>
#include <string>
#include <vector>

namespace physgen {

/// Checks that `order` names each of the objects 0 .. size-1 once.
/// @param of names the objects in messages
/// @throw Error naming the first position at which it does not, the number there, and what to write instead
void check_permutation(std::span<const index_t> order, index_t size, const std::string& of = "objects");

/// Checks that `kept` names some of the objects 0 .. size-1 in ascending order, each at most once.
/// @throw Error naming the first position at which it does not, the number there, and what to write instead
void check_ascending(std::span<const index_t> kept, index_t size, const std::string& of = "objects");

/// The objects 0 .. size-1 without the erased ones, ascending.
/// @param erased in any order
/// @throw Error naming the first number that is out of range or listed a second time
[[nodiscard]] std::vector<index_t> remaining(index_t size, std::span<const index_t> erased,
                                             const std::string& of = "objects");

/// The new number of every old object, once object i is the old object order[i]: inverse(order)[order[i]] = i.
/// @throw Error as check_permutation()
[[nodiscard]] std::vector<index_t> inverse(std::span<const index_t> order);

/// The new number of each of the old objects 0 .. size-1, once only `kept` are left, in this order; -1 where it is
/// gone.
/// @throw Error naming the first number that is out of range or listed a second time
[[nodiscard]] std::vector<index_t> new_numbers(std::span<const index_t> kept, index_t size);

}  // namespace physgen
