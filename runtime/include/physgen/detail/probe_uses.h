// The lists in which probes register themselves: every use of a probe makes an object before main() begins.
#pragma once

#include <physgen/memory/space.h>

#include <string_view>

namespace physgen::probe::detail {

enum class Access { read, written, address };

/// One use, in a list of all.
struct Use {
  const char* array;
  std::string_view object, field;
  Access access;
  const Use* next;

  Use(const char* of_array, std::string_view of_object, std::string_view of_field, Access what)
      : array(of_array), object(of_object), field(of_field), access(what), next(last) {
    last = this;
  }
  static inline const Use* last = nullptr;
};

/// Code that names `use` makes the program have it.
template <class ArrayTag, class Object, int field, Access access>
struct Used {
  static inline const Use use{ArrayTag::name, Object::name,
                              Object::template fields<float, typename Object::template Formats<Host>>[field].name,
                              access};
};

/// Work in a way of its own for a device, or an array in memory of one: of these Clang alone sees all uses.
struct ForDevice {
  const char* what;
  bool is_array;
  const ForDevice* next;

  ForDevice(const char* name, bool array) : what(name), is_array(array), next(last) { last = this; }
  static inline const ForDevice* last = nullptr;
};

/// The name of a type, somewhere in the text.
template <class T>
[[nodiscard]] constexpr const char* text_with_name() {
  return __PRETTY_FUNCTION__;
}
template <class Work>
struct DeviceWork {
  static inline const ForDevice work{text_with_name<Work>(), false};
};
template <class ArrayTag>
struct DeviceArray {
  static inline const ForDevice array{ArrayTag::name, true};
};

}  // namespace physgen::probe::detail
