// Arrays held against the plainest model there is: a vector of objects, which are vectors of numbers. For the checks of
// topology and of mirrors.
#pragma once

#include <algorithm>
#include <numeric>

#include "test_objects.h"

namespace physgen::test {

/// The plainest array there is: the elements of each object, as numbers that hold every stored value exactly.
using Model = std::vector<std::vector<double>>;

template <class Object, class Real, class Space, class Layout, class Formats>
Model objects_of(const Array<Object, Real, Space, Layout, Formats>& array) {
  Array<Object, Real, Host, Aos> objects(array.size());
  poison(objects);
  copy(objects, array);
  synchronize();
  Model model(static_cast<std::size_t>(array.size()));
  for (index_t i = 0; i < array.size(); ++i) {
    for (int k = 0; k < array.elements; ++k) model[static_cast<std::size_t>(i)].push_back(objects.getdata(i, k));
  }
  return model;
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
template <class Array>
bool is_exact(const Array& array) {
  const auto fields = array.storage().fields;
  return std::all_of(fields.begin(), fields.end(),
                     [](const FieldInfo& field) { return !field.quaternion && element_bytes(field.type) > 2; });
}

/// Whether the memory behind the last object is as in a new array, and the objects stand where getdata() in the array's
/// own space finds them.
template <class Object, class Real, class Space, class Layout, class Formats>
void expect_sound(const Array<Object, Real, Space, Layout, Formats>& array, const Model& model) {
  ASSERT_EQ(array.size(), static_cast<index_t>(model.size()));
  ASSERT_EQ(objects_of(array), model) << Object::name << " n = " << array.size() << " layout " << Layout::name;
  const index_t n = array.size();
  for (const index_t i : {index_t{0}, n / 2, n - 1}) {
    if (n == 0) break;
    for (const int k : {0, array.elements - 1}) {
      // Where it decodes a quaternion, it does so in double.
      const double tolerance = is_exact(array) ? 0 : 1e-6;
      ASSERT_NEAR(array.getdata(i, k), model[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)], tolerance);
    }
  }
  if constexpr (host_accessible(Space::kind)) {
    const Array<Object, Real, Space, Layout, Formats> fresh(1);
    const auto element = [](const Storage& storage, const FieldInfo& field, int k, index_t i) {
      const int size = element_bytes(field.type);
      return storage.base + address_by_law(field.offset + k * size, i, storage.pitch, storage.record_bytes, size);
    };
    const Storage storage = array.storage();
    for (index_t i = n; i < storage.padded; ++i) {
      for (const FieldInfo& field : storage.fields) {
        const auto size = static_cast<std::size_t>(element_bytes(field.type));
        for (int k = 0; k < field.count; ++k) {
          ASSERT_EQ(std::memcmp(element(storage, field, k, i), element(fresh.storage(), field, k, 0), size), 0)
              << field.name << " element " << k << " of object " << i << " in padding";
        }
      }
    }
  }
}

}  // namespace physgen::test
