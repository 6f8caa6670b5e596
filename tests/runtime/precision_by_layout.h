// Precisions by turns: tests that would compile the same code for every layout in every precision take one precision in
// half of the layouts and the other in the rest, and the other way round for the next type of objects.
#pragma once

#include "test_objects.h"

namespace physgen::test {

/// Halves AllLayouts, with layouts of records and of tiles in both.
template <class Layout>
constexpr bool is_even = std::same_as<Layout, Aos> || std::same_as<Layout, Soa> || std::same_as<Layout, Aosoa<32>>;
template <class Layout>
using EvenReal = std::conditional_t<is_even<Layout>, float, double>;
template <class Layout>
using OddReal = std::conditional_t<is_even<Layout>, double, float>;

}  // namespace physgen::test
