// The few declarations of probes that the analysis of usage knows, for small programs that need no other header. They
// lie in a folder of this name as the runtime's do, by which the analysis tells them from a program's own code.
#pragma once

namespace physgen {
template <class Tag, class Object, int field, class Base>
struct Probe {
  template <class T>
  static T decode(T stored) {
    return stored;
  }
  template <class T>
  static T encode(T value) {
    return value;
  }
};
template <class Probe>
struct View {
  char* memory;
  float get() const { return Probe::template decode<float>(0); }
  void put(float value) const { Probe::template encode<float>(value); }
  char* data() const { return memory; }
};
namespace probe::detail {
template <class Kernel>
void step(const Kernel& kernel) {
  if (false) kernel(0);
}
}  // namespace probe::detail
}  // namespace physgen
struct Object;
struct A {
  static constexpr const char* name = "a";
};
struct B {
  static constexpr const char* name = "b";
};
template <class Tag>
using V = physgen::View<physgen::Probe<Tag, Object, 7, int>>;
template <class Kernel>
void run(const Kernel& kernel) {
  physgen::probe::detail::step<Kernel>(kernel);
}
