// Arrays held against the plainest model there is: a vector of objects, which are vectors of numbers. For the checks of
// topology and of mirrors.
#pragma once

#include <algorithm>
#include <numeric>

#include "test_objects.h"

namespace physgen::test {

/// The plainest array there is: the elements of each object, as numbers that hold every stored value exactly.
using Model = std::vector<std::vector<double>>;

/// The elements of each object of an array on the host, as code sees them.
inline Model elements_of(const UntypedArray& untyped) {
  int elements = 0;
  for (const FieldInfo& field : untyped.fields) elements += field.visible_count();
  Model model(static_cast<std::size_t>(untyped.size));
  for (index_t i = 0; i < untyped.size; ++i) {
    for (int k = 0; k < elements; ++k) model[static_cast<std::size_t>(i)].push_back(getdata(untyped, i, k));
  }
  return model;
}

template <class Object, class Real, class Space, class Layout, class Formats>
Model objects_of(const Array<Object, Real, Space, Layout, Formats>& array) {
  Array<Object, Real, Host, Aos> objects(array.size());
  poison(objects.untyped());
  copy(objects, array);
  synchronize();
  return elements_of(objects.untyped());
}

/// Gives the array random objects.
template <class Object, class Real, class Space, class Layout, class Formats>
void randomise_objects(Array<Object, Real, Space, Layout, Formats>& array, std::mt19937& random) {
  Array<Object, Real, Host, Aos> source(array.size());
  randomise(source, random);
  copy(array, source);
  synchronize();
}

/// Objects in the array's own form, and their model.
template <class Array>
struct Random {
  Array array;
  Model model;

  Random(index_t n, std::mt19937& random) : array(n) {
    randomise_objects(array, random);
    model = objects_of(array);
  }
};

inline Model picked(const Model& objects, const std::vector<index_t>& numbers) {
  Model result;
  for (const index_t i : numbers) result.push_back(objects[static_cast<std::size_t>(i)]);
  return result;
}

inline std::vector<index_t> random_order(index_t n, std::mt19937& random) {
  std::vector<index_t> order(static_cast<std::size_t>(n));
  std::iota(order.begin(), order.end(), index_t{0});
  std::shuffle(order.begin(), order.end(), random);
  return order;
}

/// About half of the numbers, in random order.
inline std::vector<index_t> random_part(index_t n, std::mt19937& random) {
  std::vector<index_t> part = random_order(n, random);
  part.resize(part.size() / 2);
  return part;
}

/// Whether the array stores what objects_of() reads without loss.
inline bool is_exact(const UntypedArray& array) {
  return std::all_of(array.fields.begin(), array.fields.end(),
                     [](const FieldInfo& field) { return !field.quaternion && element_bytes(field.type) > 2; });
}

/// Whether the objects stand where getdata() in the array's own space finds them.
inline void expect_elements(const UntypedArray& array, const Model& model) {
  const index_t n = array.size;
  if (n == 0) return;
  // Where it decodes a quaternion, it does so in double.
  const double tolerance = is_exact(array) ? 0 : 1e-6;
  const auto last = static_cast<int>(model.front().size()) - 1;
  for (const index_t i : {index_t{0}, n / 2, n - 1}) {
    for (const int k : {0, last}) {
      ASSERT_NEAR(getdata(array, i, k), model[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)], tolerance);
    }
  }
}

/// Whether the memory behind the last object is as in a new array. @param fresh of one object, of the same type
inline void expect_new_padding(const UntypedArray& array, const UntypedArray& fresh) {
  const auto element = [](const UntypedArray& untyped, const FieldInfo& field, int k, index_t i) {
    const int size = element_bytes(field.type);
    return untyped.base + address_by_law(field.offset + k * size, i, untyped.pitch, untyped.record_bytes, size);
  };
  for (index_t i = array.size; i < array.padded; ++i) {
    for (const FieldInfo& field : array.fields) {
      const auto size = static_cast<std::size_t>(element_bytes(field.type));
      for (int k = 0; k < field.count; ++k) {
        ASSERT_EQ(std::memcmp(element(array, field, k, i), element(fresh, field, k, 0), size), 0)
            << field.name << " element " << k << " of object " << i << " in padding";
      }
    }
  }
}

/// Whether these are the objects of the array, read back from it.
inline void expect_objects(const UntypedArray& array, const Model& objects, const Model& model,
                           std::string_view layout) {
  ASSERT_EQ(array.size, static_cast<index_t>(model.size()));
  ASSERT_EQ(objects, model) << array.object << " n = " << array.size << " layout " << layout;
  expect_elements(array, model);
}

/// Expects the objects, and padding as in a new array.
template <class Object, class Real, class Space, class Layout, class Formats>
void expect_sound(const Array<Object, Real, Space, Layout, Formats>& array, const Model& model) {
  expect_objects(array.untyped(), objects_of(array), model, Layout::name);
  if constexpr (host_accessible(Space::kind)) {
    const Array<Object, Real, Space, Layout, Formats> fresh(1);
    expect_new_padding(array.untyped(), fresh.untyped());
  }
}

}  // namespace physgen::test
