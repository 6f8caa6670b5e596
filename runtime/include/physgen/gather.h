// Between arrays and objects that a simulator allocated one by one: gather builds an array, scatter writes back. What
// is written comes first, as in copy(to, from).
#pragma once

#include <physgen/arrays/array.h>
#include <physgen/arrays/chunked_transfer.h>
#include <physgen/detail/host_loop.h>
#include <physgen/detail/object_pointers.h>

#include <ranges>
#include <span>
#include <string>
#include <type_traits>

namespace physgen {

/// Makes `array` hold object_of(i) for i = 0 .. size-1, resized to fit: for handles of any kind. Done when this
/// returns; on CUDA and in pinned memory behind what is ordered in `stream`, which this waits for. Fields that the
/// array prunes are left out; where it stores Nothing of one without pruning it (format/nothing.h), this does not
/// compile.
/// @param object_of index_t -> Value of one object; called on several threads at once. Where it is noexcept, a CUDA
///        array that has the size already is filled in place, which saves its allocation
/// @throw Error when the memory cannot be had, and in checked builds when a format cannot hold a value; what object_of
///        throws. The array is then unchanged; only where it is filled in place and CUDA fails can some of its
///        objects be new
template <class Object, class Real, class Space, class Layout, class Formats, class ObjectOf>
void gather_by(Array<Object, Real, Space, Layout, Formats>& array, index_t size, const ObjectOf& object_of,
               Stream stream = nullptr) {
  detail::require_copied_fields<Object, Formats, FormatsOf<Object, Space>>();
  using Gathered = Array<Object, Real, Space, Layout, Formats>;
  if constexpr (host_accessible(Space::kind)) {
    detail::wait_for_host_work(Space::kind, stream);
    Gathered gathered(size);
    const auto view = gathered.view();
    detail::host_loop(size, [&](index_t i) { view.put(i, object_of(i)); });
    throw_if_falsified(gathered.take_losses(), gathered.untyped());
    array = std::move(gathered);
  } else {
    // Packed in chunks, in the array's own form, while the chunk before is transferred.
    using Pinned = Array<Object, Real, PinnedHost, Layout, Formats>;
    constexpr bool cannot_fail = std::is_nothrow_invocable_v<const ObjectOf&, index_t> && !checked_build;
    const bool in_place = cannot_fail && array.size() == size;
    Gathered fresh(in_place ? 0 : size);
    const UntypedArray target = in_place ? array.untyped() : fresh.untyped();
    ChunkedUpload upload(target, 0, size, stream);
    Losses losses;
    while (upload.next()) {
      Losses of_chunk;
      of_chunk.objects = upload.chunk().size;
      const typename Pinned::View chunk(upload.chunk().base, upload.chunk().size, upload.chunk().pitch, &of_chunk);
      const index_t begin = upload.begin();
      detail::host_loop(chunk.size(), [&](index_t i) { chunk.put(i, object_of(begin + i)); });
      losses.add(of_chunk, begin);
    }
    synchronize(stream);  // failures show here, before a fresh array takes the place of the old one
    throw_if_falsified(losses, target);
    if (!in_place) array = std::move(fresh);
  }
}

/// Pointers to objects that follow each other in memory: a std::vector<T*>, a std::span<T* const>, ...
template <class Pointers>
concept PointerRange =
    std::ranges::contiguous_range<Pointers> && std::is_pointer_v<std::ranges::range_value_t<Pointers>>;

/// Makes `array` hold the objects that `pointers` point to, in this order, resized to fit; otherwise as gather_by().
/// @param to_value const T& -> Value of one object; called on several threads at once
/// @throw Error when a pointer is null, and as gather_by(); the array is then unchanged
template <PointerRange Pointers, class Object, class Real, class Space, class Layout, class Formats, class ToValue>
void gather(Array<Object, Real, Space, Layout, Formats>& array, const Pointers& pointers, const ToValue& to_value,
            Stream stream = nullptr) {
  const std::span<const std::ranges::range_value_t<Pointers>> objects(pointers);
  detail::check_not_null(objects, Object::name);
  gather_by(
      array, static_cast<index_t>(objects.size()),
      [&](index_t i) noexcept(noexcept(to_value(*objects[0]))) {
        return to_value(*objects[static_cast<std::size_t>(i)]);
      },
      stream);
}

/// Hands every object of `array` to set(i, value), i = 0 .. size-1: for handles of any kind. Done when this returns; on
/// CUDA and in pinned memory behind what is ordered in `stream`.
/// @param set called on several threads at once, once for each i
template <class Object, class Real, class Space, class Layout, class Formats, class Set>
void scatter_by(const Array<Object, Real, Space, Layout, Formats>& array, const Set& set, Stream stream = nullptr) {
  if constexpr (host_accessible(Space::kind)) {
    detail::wait_for_host_work(Space::kind, stream);
    const auto view = array.view();
    detail::host_loop(view.size(), [&](index_t i) { set(i, view.get(i)); });
  } else {
    using Pinned = Array<Object, Real, PinnedHost, Layout, Formats>;
    ChunkedDownload download(array.untyped(), 0, array.size(), stream);
    while (download.next()) {
      const typename Pinned::ConstView chunk(download.chunk().base, download.chunk().size, download.chunk().pitch);
      const index_t begin = download.begin();
      detail::host_loop(chunk.size(), [&](index_t i) { set(begin + i, chunk.get(i)); });
    }
  }
}

/// Writes to the objects that `pointers` point to, in this order, those of `array`; otherwise as scatter_by().
/// @param from_value (T&, const Value&); called on several threads at once
/// @pre no two pointers are the same: two threads would write one object
/// @throw Error when a pointer is null or there are not as many pointers as objects, and in checked builds when two
///        pointers are the same; no object is then changed
template <PointerRange Pointers, class Object, class Real, class Space, class Layout, class Formats, class FromValue>
void scatter(const Pointers& pointers, const Array<Object, Real, Space, Layout, Formats>& array,
             const FromValue& from_value, Stream stream = nullptr) {
  const std::span<const std::ranges::range_value_t<Pointers>> objects(pointers);
  if (static_cast<index_t>(objects.size()) != array.size()) {
    throw Error(std::string(Object::name) + ": cannot scatter to " + std::to_string(objects.size()) +
                " objects an array of " + std::to_string(array.size()) + "; give one pointer for each object");
  }
  detail::check_not_null(objects, Object::name);
  if (checked_build) detail::check_different(objects, Object::name);
  scatter_by(
      array, [&](index_t i, const auto& value) { from_value(*objects[static_cast<std::size_t>(i)], value); }, stream);
}

// In another order they do not compile.
template <PointerRange Pointers, class Object, class Real, class Space, class Layout, class Formats, class ToValue>
void gather(const Pointers& /*pointers*/, const Array<Object, Real, Space, Layout, Formats>& /*array*/,
            const ToValue& /*to_value*/, Stream /*stream*/ = nullptr) {
  static_assert(std::is_void_v<Object>, "gather(array, pointers, to_value): the array, which is written, comes first");
}
template <PointerRange Pointers, class Object, class Real, class Space, class Layout, class Formats, class FromValue>
void scatter(const Array<Object, Real, Space, Layout, Formats>& /*array*/, const Pointers& /*pointers*/,
             const FromValue& /*from_value*/, Stream /*stream*/ = nullptr) {
  static_assert(std::is_void_v<Object>,
                "scatter(pointers, array, from_value): the pointers to what is written come first");
}

}  // namespace physgen
