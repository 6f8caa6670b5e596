// Between arrays and objects that a simulator allocated one by one: gather builds an array, scatter writes back.
#pragma once

#include <physgen/array.h>
#include <physgen/chunked_transfer.h>
#include <physgen/parallel_for.h>

#include <span>

namespace physgen {

namespace detail {

template <class T>
void check_not_null(std::span<T* const> objects, std::string_view object_type) {
  const auto count = static_cast<index_t>(objects.size());
  index_t first = count;  // that is null
#pragma omp parallel for reduction(min : first) if (count > 8192)
  for (index_t i = 0; i < count; ++i) {
    if (objects[static_cast<std::size_t>(i)] == nullptr && i < first) first = i;
  }
  if (first < count) {
    throw Error(std::string(object_type) + ": pointer " + std::to_string(first) + " of " + std::to_string(count) +
                " is null; every object needs one");
  }
}

}  // namespace detail

/// Makes `array` hold object_of(i) for i = 0 .. size-1, resized to fit: for handles of any kind.
/// @param object_of index_t -> Value of one object; called on several threads at once
/// @throw Error when the memory cannot be had; the array is then unchanged
template <class Object, class Real, class Space, class Layout, class Formats, class ObjectOf>
void gather_by(index_t size, Array<Object, Real, Space, Layout, Formats>& array, const ObjectOf& object_of,
               Stream stream = nullptr) {
  if constexpr (host_accessible(Space::kind)) {
    Array<Object, Real, Space, Layout, Formats> gathered(size);
    const auto view = gathered.view();
    parallel_for(Host{}, size, [&](index_t i) { view.put(i, object_of(i)); });
    array = std::move(gathered);
  } else {
    // Packed in chunks, in the array's own form, while the chunk before is transferred.
    Array<Object, Real, Space, Layout, Formats> gathered(size);
    ChunkedUpload upload(gathered.storage(), 0, size, stream);
    Losses losses;
    losses.objects = size;
    while (upload.next()) {
      const View<Object, Real, Layout, Formats> chunk(upload.chunk().base, upload.chunk().size, upload.chunk().pitch,
                                                      SpaceKind::pinned, &losses);
      const index_t begin = upload.begin();
      parallel_for(Host{}, chunk.size(), [&](index_t i) { chunk.put(i, object_of(begin + i)); });
    }
    synchronize(stream);  // what failed shows here, while the array is as it was
    throw_if_falsified(losses, gathered.storage());
    array = std::move(gathered);
  }
}

/// Makes `array` hold the objects pointed to, in this order, resized to fit.
/// @param to_value const T& -> Value of one object; called on several threads at once
/// @throw Error when a pointer is null or the memory cannot be had; the array is then unchanged
template <class T, class Object, class Real, class Space, class Layout, class Formats, class ToValue>
void gather(std::span<T* const> objects, Array<Object, Real, Space, Layout, Formats>& array, const ToValue& to_value,
            Stream stream = nullptr) {
  detail::check_not_null(objects, Object::name);
  gather_by(
      static_cast<index_t>(objects.size()), array,
      [&](index_t i) { return to_value(*objects[static_cast<std::size_t>(i)]); }, stream);
}

/// Hands every object of `array` to set(i, value), i = 0 .. size-1: for handles of any kind.
/// @param set called on several threads at once, once for each i
template <class Object, class Real, class Space, class Layout, class Formats, class Set>
void scatter_by(const Array<Object, Real, Space, Layout, Formats>& array, const Set& set, Stream stream = nullptr) {
  if constexpr (host_accessible(Space::kind)) {
    const auto view = array.view();
    parallel_for(Host{}, view.size(), [&](index_t i) { set(i, view.get(i)); });
  } else {
    ChunkedDownload download(array.storage(), 0, array.size(), stream);
    while (download.next()) {
      const View<Object, const Real, Layout, Formats> chunk(download.chunk().base, download.chunk().size,
                                                            download.chunk().pitch, SpaceKind::pinned);
      const index_t begin = download.begin();
      parallel_for(Host{}, chunk.size(), [&](index_t i) { set(begin + i, chunk.get(i)); });
    }
  }
}

/// Writes the array's objects back to the objects pointed to, in this order.
/// @param from_value (T&, const Value&); called on several threads at once
/// @throw Error when a pointer is null or there are not as many pointers as objects; no object is then changed
template <class T, class Object, class Real, class Space, class Layout, class Formats, class FromValue>
void scatter(const Array<Object, Real, Space, Layout, Formats>& array, std::span<T* const> objects,
             const FromValue& from_value, Stream stream = nullptr) {
  if (static_cast<index_t>(objects.size()) != array.size()) {
    throw Error(std::string(Object::name) + ": cannot scatter an array of " + std::to_string(array.size()) + " to " +
                std::to_string(objects.size()) + " objects");
  }
  detail::check_not_null(objects, Object::name);
  scatter_by(
      array, [&](index_t i, const auto& value) { from_value(*objects[static_cast<std::size_t>(i)], value); }, stream);
}

}  // namespace physgen
