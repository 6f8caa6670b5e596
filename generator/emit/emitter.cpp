// See emitter.h.
#include "emit/emitter.h"

#include "emit/cpp/header.h"
#include "emit/cpp/rules.h"
#include "emit/python/module.h"
#include "model/text.h"

namespace physgen::emit {

std::span<const Emitter> emitters() {
  static constexpr Emitter all[] = {
      {"cpp", "accessor classes in C++ and CUDA", cpp::ending, cpp::objections, cpp::accessor_header},
      {"python", "the source of a Python module over these classes", python::ending, python::objections,
       python::module_source},
  };
  return all;
}

const Emitter& emitter(const std::string& name) {
  std::vector<std::string> names;
  for (const Emitter& one : emitters()) {
    if (one.name == name) return one;
    names.emplace_back(one.name);
  }
  throw UnknownEmitter(model::unknown("emitter", name, names));
}

}  // namespace physgen::emit
