// Reads the same run of elements of W records as W-wide registers: each record by words of 16 bytes, which shuffles
// turn into one register per element. Included by host translation units only.
#pragma once

#include <physgen/config.h>

#include <cstddef>
#include <cstring>
#include <utility>

namespace physgen::detail {

/// Elements in a word of 16 bytes.
template <class T>
inline constexpr int word_elements = 16 / int{sizeof(T)};

/// A register of kCount numbers, as compilers know it.
template <class T, int kCount>
struct Register {
  using type [[gnu::vector_size(kCount * sizeof(T))]] = T;
};
template <class T, int kCount>
using register_t = typename Register<T, kCount>::type;

/// 0, 1, 2, ...
template <class T, int kCount>
[[gnu::always_inline]] inline register_t<T, kCount> counting_register() {
  return []<int... k>(std::integer_sequence<int, k...>) {
    return register_t<T, kCount>{k...};
  }(std::make_integer_sequence<int, kCount>());
}

/// The words that begin at address(first), address(first + step), ..., one behind the other.
template <class T, int kWords, class Address>
[[gnu::always_inline]] inline auto join_words(const Address& address, int first, int step) {
  constexpr int E = word_elements<T>;
  if constexpr (kWords == 1) {
    register_t<T, E> word;
    std::memcpy(&word, address(first), sizeof word);
    return word;
  } else {
    const auto low = join_words<T, kWords / 2>(address, first, step);
    const auto high = join_words<T, kWords / 2>(address, first + kWords / 2 * step, step);
    return [&]<int... k>(std::integer_sequence<int, k...>) {
      return __builtin_shufflevector(low, high, k...);
    }(std::make_integer_sequence<int, kWords * E>());
  }
}

/// Interleaves, in each word, runs of kRun elements of the lower (kUpper: the upper) halves of a and b.
template <class T, int W, int kRun, bool kUpper, class V>
[[gnu::always_inline]] inline V zip_words(const V& a, const V& b) {
  constexpr int E = word_elements<T>;
  return [&]<int... k>(std::integer_sequence<int, k...>) {
    // Lane k: its word, and in the word run r of the result, which is run r / 2 of a half of a or b.
    return __builtin_shufflevector(
        a, b, (k / E * E + (kUpper ? E / 2 : 0) + k % E / kRun / 2 * kRun + k % kRun + (k % E / kRun % 2) * W)...);
  }(std::make_integer_sequence<int, W>());
}

/// Lane l of elements[k] becomes the k-th number of the word at address(l), for all numbers of a word.
template <class T, int W, class Address>
[[gnu::always_inline]] inline void load_transposed(const Address& address, register_t<T, W>* elements) {
  constexpr int E = word_elements<T>;
  using V = register_t<T, W>;
  if constexpr (E == 2) {
    const V a = join_words<T, W / E>(address, 0, E), b = join_words<T, W / E>(address, 1, E);
    elements[0] = zip_words<T, W, 1, false>(a, b);
    elements[1] = zip_words<T, W, 1, true>(a, b);
  } else {
    const V a = join_words<T, W / E>(address, 0, E), b = join_words<T, W / E>(address, 1, E),
            c = join_words<T, W / E>(address, 2, E), d = join_words<T, W / E>(address, 3, E);
    const V ab = zip_words<T, W, 1, false>(a, b), cd = zip_words<T, W, 1, false>(c, d);
    const V ef = zip_words<T, W, 1, true>(a, b), gh = zip_words<T, W, 1, true>(c, d);
    elements[0] = zip_words<T, W, 2, false>(ab, cd);
    elements[1] = zip_words<T, W, 2, true>(ab, cd);
    elements[2] = zip_words<T, W, 2, false>(ef, gh);
    elements[3] = zip_words<T, W, 2, true>(ef, gh);
  }
}

}  // namespace physgen::detail
