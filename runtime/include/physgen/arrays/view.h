// A kernel holds a view of an array: a trivially copyable value of two words and, for Soa, the pitch.
#pragma once
#pragma push_macro("I")  // of <complex.h>
#undef I

#include <physgen/arrays/untyped_array.h>
#include <physgen/detail/cursor.h>
#include <physgen/error.h>
#include <physgen/fields/object_ref.h>
#include <physgen/layout.h>
#include <physgen/memory/space.h>

#include <cstdio>
#include <string>

#if defined(PHYSGEN_CHECKED) && !defined(__CUDACC__)
#include <physgen/detail/fused_accesses.h>
#endif

#ifdef __CUDACC__
// Defined nowhere: its name is what the linker of device code prints. (A static_assert would also refuse host code of
// the same file, which nvcc's device pass reads, too.)
extern "C" __device__ void physgen_a_kernel_on_the_device_uses_a_view_of_Host_memory_so_copy_the_array_to_Cuda_first();
#endif

namespace physgen {

/// @tparam Object a generated tag such as elasticity::StressDerivativeObject
/// @tparam Real float or double; const for a read-only view
/// @tparam Layout_ Aos, AosPadded, Soa or Aosoa<W>
/// @tparam Formats_ how the fields are stored: the object's own Formats<Space>, or a struct derived from it
/// @tparam Space_ where the objects lie: Host, PinnedHost or Cuda. Views of pinned memory convert to both others.
///
/// Objects 0 .. size()-1 are the array's; memory behind them is real up to the next multiple of padding_objects.
/// A kernel on the device that uses a view of Host memory does not link. With PHYSGEN_CHECKED, an index out of range, a
/// null view and a view of CUDA memory used on the host are reported: an Error on the host, a message and a trap on the
/// device; values that a storage format cannot hold are counted (losses.h).
template <class Object_, class Real, class Layout_, class Formats_, class Space_ = Host>
class View : private Layout_::Pitch {  // a base, because nvcc lays [[no_unique_address]] members out unlike its host
  using Pitch = typename Layout_::Pitch;

 public:
  using Object = Object_;
  using Layout = Layout_;
  using Formats = Formats_;
  using Space = Space_;
  using Precision = std::remove_const_t<Real>;
  using Byte = std::conditional_t<std::is_const_v<Real>, const std::byte, std::byte>;
  using Record = typename Object::template Record<Precision, Formats>;
  static constexpr int record_bytes = Layout::record_bytes(Record::bytes, Record::alignment);  // debuggers read it
  template <class I>
  using CursorAt =
      Cursor<Byte, Layout,
             RecordSize{Record::bytes, record_bytes, detail::record_size<Object, Precision, Layout, Formats>.lane}, I>;
  /// The reference to object(s) under an index of type I, and its value type.
  template <class I>
  using Ref = typename Object::template Ref<
      Precision, format::FormatsAt<Formats, detail::is_own<I> || detail::AnyPack<I>, detail::is_of_part<I>>,
      CursorAt<detail::Bare<I>>>;
  template <class I>
  using Value = typename Object::template Value<lanes_t<Precision, I>>;

  View() : View(nullptr, 0, 0) {}
  /// @pre base points to the memory of an array of `size` objects with this pitch, in Space
  /// @param losses where checked builds count what formats could not hold; null elsewhere
  PHYSGEN_FUNCTION View(Byte* base, index_t size, index_t pitch, [[maybe_unused]] Losses* losses = nullptr)
      : Pitch(pitch),
        base_(base),
        size_(size)
#ifdef PHYSGEN_CHECKED
        ,
        losses_(losses)
#endif
  {
  }

  /// The same objects: a read-only view of them, or one for a space that reaches pinned memory.
  template <class From, class FromSpace>
    requires((std::is_same_v<From, Real> || std::is_same_v<const From, Real>) &&
             (std::is_same_v<FromSpace, Space> || std::is_same_v<FromSpace, PinnedHost>) &&
             !std::is_same_v<View<Object, From, Layout, Formats, FromSpace>, View>)
  PHYSGEN_FUNCTION View(const View<Object, From, Layout, Formats, FromSpace>& other)  // NOLINT: as T* to const T*
      : View(other.base_, other.size(), other.pitch(), other.losses()) {}
  /// A kernel that names this type of view cannot be told the formats of an array whose reads and writes are looked
  /// for.
  template <class From, class FromLayout, class FromFormats, class FromSpace>
    requires(format::are_probes<FromFormats> && !format::are_probes<Formats>)
  View(const View<Object, From, FromLayout, FromFormats, FromSpace>&,
       format::detail::this_kernel_is_over_a_concrete_view_so_write_it_as_a_template_over_its_views = {}) = delete;

  [[nodiscard]] PHYSGEN_FUNCTION index_t size() const { return size_; }
  /// The memory. Probed arrays and arrays with pruned fields do not give it: whoever reads it reads all fields.
  [[nodiscard]] PHYSGEN_FUNCTION Byte* data() const {
    static_assert(!format::are_probes<Formats>,
                  "data(): a probed array has no raw memory, so read and write its fields, view[i].field()");
    static_assert(all_stored(Object::template fields<Precision, Formats>),
                  "data(): fields of this array are pruned, so what lies in its memory depends on the scene; read and "
                  "write its fields, view[i].field()");
    return base_;
  }
  [[nodiscard]] PHYSGEN_FUNCTION index_t pitch() const { return Pitch::value(); }
  /// The objects without their types, which copy() reads.
  [[nodiscard]] UntypedArray untyped() const {
    return {const_cast<std::byte*>(static_cast<const std::byte*>(base_)),
            size_,
            Layout::padded(size_),
            pitch(),
            record_bytes,
            Space::kind,
            Object::name,
            Object::template fields<Precision, Formats>};
  }
  /// The space in which the objects lie.
  [[nodiscard]] PHYSGEN_FUNCTION static constexpr SpaceKind space() { return Space::kind; }

  /// The object at index i; for a Pack or a SIMD batch of indices, the objects at them.
  template <class I>
    requires(!detail::ElementReference<I>)
  [[nodiscard]] PHYSGEN_FUNCTION auto operator[](I i) const {  // so compilers print no alias of its type
    return at<I>(detail::bare(i));
  }
  /// The object(s) at indices that another array holds: `nodes[tets[i].nodes()[0]]`.
  template <detail::ElementReference I>
  [[nodiscard]] PHYSGEN_FUNCTION auto operator[](I&& i) const {
    return (*this)[detail::operand(std::forward<I>(i))];
  }
  /// All fields of object(s) i, by value.
  template <class I>
    requires(!detail::ElementReference<I>)
  [[nodiscard]] PHYSGEN_FUNCTION const Value<I> get(I i) const {
    return (*this)[i].get();
  }
  template <detail::ElementReference I>
  [[nodiscard]] PHYSGEN_FUNCTION auto get(I&& i) const {
    return get(detail::operand(std::forward<I>(i)));
  }
  /// Stores all fields of object(s) i.
  template <class I>
  PHYSGEN_FUNCTION void put(I&& i, const Value<std::remove_cvref_t<detail::Operand<I>>>& value) const {
    (*this)[std::forward<I>(i)].put(value);
  }

  /// The counters of checked builds for these objects; null in others.
  [[nodiscard]] PHYSGEN_FUNCTION Losses* losses() const {
#ifdef PHYSGEN_CHECKED
    return losses_;
#else
    return nullptr;
#endif
  }

 private:
  template <class, class, class, class, class>
  friend class View;

  /// @tparam I the index, or an Own that holds it
  template <class I>
  [[nodiscard]] PHYSGEN_FUNCTION Ref<I> at(const detail::Bare<I>& i) const {
    check(i);
#if defined(PHYSGEN_CHECKED) && !defined(__CUDACC__)
    if constexpr (!std::is_integral_v<detail::Bare<I>>) detail::watch_array<View>(losses_);
#endif
    return Ref<I>(CursorAt<detail::Bare<I>>(base_, *this, i, losses()));
  }

  template <class I>
  PHYSGEN_FUNCTION void check(const I& i) const {
#ifdef __CUDA_ARCH__
    if constexpr (!device_accessible(Space::kind)) {
      physgen_a_kernel_on_the_device_uses_a_view_of_Host_memory_so_copy_the_array_to_Cuda_first();
    }
#endif
#ifdef PHYSGEN_CHECKED
    if constexpr (std::is_integral_v<I>) {
      check_range(static_cast<index_t>(i), static_cast<index_t>(i) + 1);
    } else if constexpr (requires { I::width; }) {
      const LaneRange range = lane_range(i);
#ifndef __CUDA_ARCH__  // where there are no packs
      if (i.begin % I::width != 0) {
        throw Error(std::string(Object::name) + ": a pack of " + std::to_string(I::width) +
                    " objects begins at object " + std::to_string(i.begin) + ", which is not a multiple of its width");
      }
#endif
      check_range(i.begin + range.first, i.begin + range.last);
    } else {
      for (std::size_t l = 0; l < I::size; ++l) {
        const auto object = static_cast<index_t>(i.get(l));
        check_range(object, object + 1);
      }
    }
#else
    (void)i;
#endif
  }
#ifdef PHYSGEN_CHECKED
  PHYSGEN_FUNCTION void check_range(index_t begin, index_t end) const {
#ifdef __CUDA_ARCH__
    if ((base_ == nullptr && record_bytes > 0) || begin < 0 || end > size_) {
      printf("physgen: object %lld of an array of %lld on the device\n", static_cast<long long>(begin),
             static_cast<long long>(size_));
      __trap();
    }
#else
    if (!host_accessible(Space::kind)) {
      throw Error(std::string(Object::name) + ": a view of " + physgen::name(Space::kind) +
                  " memory is used on the host; copy the array to Host first");
    }
    if ((base_ == nullptr && record_bytes > 0) || begin < 0 || end > size_) {
      const index_t wrong = begin < 0 || begin >= size_ ? begin : size_;
      throw Error(std::string(Object::name) + ": object " + std::to_string(wrong) + " of an array of " +
                  std::to_string(size_));
    }
#endif
  }
#endif

  Byte* base_;
  index_t size_;
#ifdef PHYSGEN_CHECKED
  Losses* losses_;
#endif
};

}  // namespace physgen

#pragma pop_macro("I")
