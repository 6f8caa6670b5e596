// Between arrays and objects that a simulator allocated one by one: gather builds an array, scatter writes back.
#pragma once

#include <physgen/array.h>
#include <physgen/parallel_for.h>

#include <span>

namespace physgen {

namespace detail {

template <class T>
void check_not_null(std::span<T* const> objects, std::string_view object_type) {
  for (std::size_t i = 0; i < objects.size(); ++i) {
    if (objects[i] == nullptr) {
      throw Error(std::string(object_type) + ": pointer " + std::to_string(i) + " of " +
                  std::to_string(objects.size()) + " is null; every object needs one");
    }
  }
}

}  // namespace detail

/// Makes `array` hold object_of(i) for i = 0 .. size-1, resized to fit: for handles of any kind.
/// @param object_of index_t -> Value of one object; called on several threads at once
/// @throw Error when the memory cannot be had; the array is then unchanged
template <class Object, class Real, class Space, class Layout, class ObjectOf>
void gather_by(index_t size, Array<Object, Real, Space, Layout>& array, const ObjectOf& object_of,
               Stream stream = nullptr) {
  if constexpr (host_accessible(Space::kind)) {
    Array<Object, Real, Space, Layout> gathered(size);
    const auto view = gathered.view();
    parallel_for(Host{}, size, [&](index_t i) { view.put(i, object_of(i)); });
    array = std::move(gathered);
  } else {
    Array<Object, Real, PinnedHost, Layout> staged;
    gather_by(size, staged, object_of);
    Array<Object, Real, Space, Layout> gathered(size);
    copy(gathered, staged, stream);
    synchronize(stream);  // the staging memory ends with this call
    array = std::move(gathered);
  }
}

/// Makes `array` hold the objects pointed to, in this order, resized to fit.
/// @param to_value const T& -> Value of one object; called on several threads at once
/// @throw Error when a pointer is null or the memory cannot be had; the array is then unchanged
template <class T, class Object, class Real, class Space, class Layout, class ToValue>
void gather(std::span<T* const> objects, Array<Object, Real, Space, Layout>& array, const ToValue& to_value,
            Stream stream = nullptr) {
  detail::check_not_null(objects, Object::name);
  gather_by(
      static_cast<index_t>(objects.size()), array,
      [&](index_t i) { return to_value(*objects[static_cast<std::size_t>(i)]); }, stream);
}

/// Hands every object of `array` to set(i, value), i = 0 .. size-1: for handles of any kind.
/// @param set called on several threads at once, once for each i
template <class Object, class Real, class Space, class Layout, class Set>
void scatter_by(const Array<Object, Real, Space, Layout>& array, const Set& set, Stream stream = nullptr) {
  if constexpr (host_accessible(Space::kind)) {
    const auto view = array.view();
    parallel_for(Host{}, view.size(), [&](index_t i) { set(i, view.get(i)); });
  } else {
    Array<Object, Real, PinnedHost, Layout> staged(array.size());
    copy(staged, array, stream);
    synchronize(stream);
    scatter_by(staged, set);
  }
}

/// Writes the array's objects back to the objects pointed to, in this order.
/// @param from_value (T&, const Value&); called on several threads at once
/// @throw Error when a pointer is null or there are not as many pointers as objects; no object is then changed
template <class T, class Object, class Real, class Space, class Layout, class FromValue>
void scatter(const Array<Object, Real, Space, Layout>& array, std::span<T* const> objects, const FromValue& from_value,
             Stream stream = nullptr) {
  if (static_cast<index_t>(objects.size()) != array.size()) {
    throw Error(std::string(Object::name) + ": cannot scatter an array of " + std::to_string(array.size()) + " to " +
                std::to_string(objects.size()) + " objects");
  }
  detail::check_not_null(objects, Object::name);
  scatter_by(
      array, [&](index_t i, const auto& value) { from_value(*objects[static_cast<std::size_t>(i)], value); }, stream);
}

}  // namespace physgen
