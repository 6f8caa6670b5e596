// Values that are made when they are first asked for, and kept by name.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <tuple>

namespace physgen::bench {

class Kept {
 public:
  /// The T that make() gave when this name was first asked for.
  template <class T, class Make>
  const T& once(const std::string& name, const Make& make) {
    auto& slot = made_[name];
    if (!slot) slot = std::make_shared<const T>(make());
    return *static_cast<const T*>(slot.get());
  }
  /// The same, but only what was asked for last is kept: references, which all layouts of a kernel share.
  template <class T, class Make>
  const T& latest(const std::string& name, const Make& make) {
    if (name != latest_name_) {
      latest_.reset();
      latest_ = std::make_shared<const T>(make());
      latest_name_ = name;
    }
    return *static_cast<const T*>(latest_.get());
  }

 private:
  std::map<std::string, std::shared_ptr<const void>> made_;
  std::shared_ptr<const void> latest_;
  std::string latest_name_;
};

/// The T of these arguments that rows share; it lives as long as one of them.
template <class T, class... Argument>
std::shared_ptr<T> shared(const Argument&... arguments) {
  static std::map<std::tuple<Argument...>, std::weak_ptr<T>> all;
  auto& known = all[{arguments...}];
  std::shared_ptr<T> one = known.lock();
  if (!one) known = one = std::make_shared<T>(arguments...);
  return one;
}

}  // namespace physgen::bench
