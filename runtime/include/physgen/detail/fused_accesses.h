// In checked builds, on the CPU: which elements of arrays the steps of a fused kernel read, write and add to, and for
// which of the kernel's objects, so that a race between two of these is an error when it happens. Kept for one launch.
#pragma once

#include <physgen/arrays/losses.h>
#include <physgen/error.h>
#include <physgen/fields/object_info.h>
#include <physgen/kernels/pack.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdlib>
#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <vector>

namespace physgen::detail {

enum class FusedAccess { read, write, add };

/// Names of steps by number. Those of a program are few, and stay.
class StepNames {
 public:
  static int add(std::string_view name) {
    const std::lock_guard lock(mutex_);
    names_.emplace_back(name);
    return static_cast<int>(names_.size()) - 1;
  }
  [[nodiscard]] static std::string of(int step) {
    const std::lock_guard lock(mutex_);
    return names_[static_cast<std::size_t>(step)];
  }

 private:
  static inline std::mutex mutex_;
  static inline std::vector<std::string> names_;
};

/// "CopyNext": a type's name without its namespaces and what it is a template over.
template <class Step>
[[nodiscard]] constexpr std::string_view name_of_step() {
  constexpr std::string_view text = __PRETTY_FUNCTION__, before = "Step = ";
  constexpr std::string_view behind = text.substr(text.find(before) + before.size());
  constexpr std::string_view name = behind.substr(0, behind.find_first_of("<;]"));
  return name.substr(name.rfind(':') + 1);
}
template <class Step>
[[nodiscard]] int number_of_step() {
  static const int number = StepNames::add(name_of_step<Step>());
  return number;
}

/// The accesses of one launch to one array.
class ArrayAccesses {
 public:
  /// @param size objects of the array, of which a view may have fewer
  ArrayAccesses(std::string_view object, std::span<const FieldInfo> fields, index_t size, int record_bytes)
      : object_(object), fields_(fields) {
    for (const FieldInfo& field : fields)
      if (field.is_stored()) unit_ = std::min(unit_, element_bytes(field.type));
    units_ = record_bytes / unit_;
    // Zero, without touching memory that no access needs.
    entries_.reset(static_cast<Entry*>(std::calloc(static_cast<std::size_t>(size * units_), sizeof(Entry))));
    if (!entries_) throw Error(std::string(object) + ": there is no memory for checking the accesses of fused kernels");
  }

  /// @param offset of the element in the record [bytes]
  /// @param of the kernel's object for which it happens
  /// @throw Error when it and another one, for another object of the kernel, are a race
  void note(FusedAccess access, index_t object, int offset, index_t of, int step) {
    Entry& entry = entries_.get()[object * units_ + offset / unit_];
    const Element at{object, offset};
    const std::uint64_t mine = static_cast<std::uint64_t>(step) << index_bits | static_cast<std::uint64_t>(of + 1);
    // An access is stored before others' are looked at: of two threads one at least sees the other.
    if (access == FusedAccess::write) {
      look(at, access, mine, FusedAccess::write, std::atomic_ref(entry.writer).exchange(mine));
    } else {
      remember(access == FusedAccess::read ? entry.readers : entry.adders, mine);
      look(at, access, mine, FusedAccess::write, std::atomic_ref(entry.writer).load());
    }
    for (std::size_t k = 0; k < 2; ++k) {
      if (access != FusedAccess::read)
        look(at, access, mine, FusedAccess::read, std::atomic_ref(entry.readers[k]).load());
      if (access != FusedAccess::add) look(at, access, mine, FusedAccess::add, std::atomic_ref(entry.adders[k]).load());
    }
  }

 private:
  /// The step and the kernel's object, plus 1, of the last write, and of the first and the last other read and add.
  struct Entry {
    std::uint64_t writer;
    std::array<std::uint64_t, 2> readers, adders;
  };
  struct Element {
    index_t object;
    int offset;
  };
  struct Free {
    void operator()(Entry* entries) const { std::free(entries); }
  };
  static constexpr int index_bits = 48;
  [[nodiscard]] static constexpr index_t index(std::uint64_t mark) {
    return static_cast<index_t>(mark & ((std::uint64_t{1} << index_bits) - 1)) - 1;
  }

  static void remember(std::array<std::uint64_t, 2>& who, std::uint64_t mine) {
    std::uint64_t first = 0;
    if (!std::atomic_ref(who[0]).compare_exchange_strong(first, mine) && index(first) != index(mine))
      std::atomic_ref(who[1]).store(mine);
  }

  void look(const Element& at, FusedAccess access, std::uint64_t mine, FusedAccess other_access,
            std::uint64_t other) const {
    if (other == 0 || index(other) == index(mine)) return;
    const auto says = [](FusedAccess what, std::uint64_t who) {
      const char* verb = what == FusedAccess::read    ? " reads it for object "
                         : what == FusedAccess::write ? " writes it for object "
                                                      : " adds to it for object ";
      return StepNames::of(static_cast<int>(who >> index_bits)) + verb + std::to_string(index(who));
    };
    std::string_view field;
    for (const FieldInfo& one : fields_)
      if (one.is_stored() && at.offset >= one.offset && at.offset < one.offset + one.count * element_bytes(one.type))
        field = one.name;
    throw Error(std::string(object_) + ": a race in a fused kernel at field " + std::string(field) + " of object " +
                std::to_string(at.object) + ": " + says(access, mine) + ", and " + says(other_access, other) +
                "; what is found there depends on how threads and packs run, so take one of the two out of fuse(...)");
  }

  std::string_view object_;
  std::span<const FieldInfo> fields_;
  int unit_ = 8, units_ = 0;  // smallest element [bytes]; of them in a record
  std::unique_ptr<Entry, Free> entries_;
};

/// The accesses of a fused kernel's steps in one launch.
class FusedAccesses {
 public:
  /// The accesses to an array; null where none are known. @param losses of the array, which tell arrays apart
  [[nodiscard]] ArrayAccesses* find(const Losses* losses) {
    static thread_local std::array<Known, 16> lately;
    Known& known = lately[reinterpret_cast<std::uintptr_t>(losses) / 64 % lately.size()];
    if (known.launch == number_ && known.losses == losses) return known.accesses;
    const std::lock_guard lock(mutex_);
    const auto entry = arrays_.find(losses);
    if (entry == arrays_.end()) return nullptr;
    known = {number_, losses, entry->second.get()};
    return known.accesses;
  }
  void add(const Losses* losses, std::string_view object, std::span<const FieldInfo> fields, int record_bytes) {
    const std::lock_guard lock(mutex_);
    std::unique_ptr<ArrayAccesses>& accesses = arrays_[losses];
    if (!accesses) accesses = std::make_unique<ArrayAccesses>(object, fields, losses->objects, record_bytes);
  }

 private:
  struct Known {
    unsigned long long launch = 0;
    const Losses* losses = nullptr;
    ArrayAccesses* accesses = nullptr;
  };
  static inline std::atomic<unsigned long long> launches = 0;
  unsigned long long number_ = ++launches;
  std::mutex mutex_;
  std::map<const Losses*, std::unique_ptr<ArrayAccesses>> arrays_;
};

/// The launch whose kernel runs on this thread, for which objects, and which step of a fused kernel it is at.
struct RunningStep {
  FusedAccesses* launch = nullptr;
  index_t begin = 0;  ///< of lane 0
  LaneRange range{0, 0};
  int width = 0;
  std::uint64_t used = ~std::uint64_t{0};  ///< bits of the lanes for which it runs; what others find is not used
  int step = -1;                           ///< none: no fused kernel runs

  [[nodiscard]] bool watched() const { return launch != nullptr && step >= 0; }
};
inline thread_local RunningStep running_step;

/// Sets it until it goes out of scope.
class RunStep {
 public:
  explicit RunStep(const RunningStep& step) : before_(running_step) { running_step = step; }
  RunStep(const RunStep&) = delete;
  RunStep& operator=(const RunStep&) = delete;
  ~RunStep() { running_step = before_; }

 private:
  RunningStep before_;
};
/// The same launch, at a step.
template <class Step>
[[nodiscard]] RunningStep at_step() {
  RunningStep here = running_step;
  here.step = number_of_step<Step>();
  return here;
}
/// The same step, for those of its lanes whose bits are set.
[[nodiscard]] inline RunningStep of_lanes(std::uint64_t lanes) {
  RunningStep here = running_step;
  here.used &= lanes;
  return here;
}

/// Makes an array known to the launch whose fused kernel looks at objects of it. @param losses null: of no array
template <class View>
void watch_array(const Losses* losses) {
  if (losses == nullptr || !running_step.watched() || running_step.launch->find(losses) != nullptr) return;
  using Object = typename View::Object;
  running_step.launch->add(losses, Object::name,
                           Object::template fields<typename View::Precision, typename View::Formats>,
                           View::Record::bytes);
}

/// Notes an access of the lanes of a pack, or of objects that it gathers. @param object of a lane
template <int W, class ObjectOf>
void note_lanes(FusedAccess access, const Losses* losses, int offset, std::uint64_t lanes, const ObjectOf& object) {
  const RunningStep& here = running_step;
  if (losses == nullptr || !here.watched() || here.width != W) return;
  ArrayAccesses* const array = here.launch->find(losses);
  if (array == nullptr) return;
  for (int l = here.range.first; l < here.range.last; ++l)
    if ((lanes >> l & 1) != 0 && object(l) < losses->objects)
      array->note(access, object(l), offset, here.begin + l, here.step);
}

}  // namespace physgen::detail
