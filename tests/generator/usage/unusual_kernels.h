// Kernels for unusual.cpp: each reaches its view by a seldom used way of C++.
#pragma once

#include <physgen/kernel.h>

#include <compare>
#include <coroutine>
#include <exception>
#include <functional>
#include <ranges>
#include <tuple>
#include <utility>

namespace unusual {

using namespace physgen;

/// A kernel over one view whose class template is called Name.
#define PHYSGEN_TEST_KERNEL(Name) \
  template <class View>           \
  Name(View)->Name<View>

struct Task {
  struct promise_type {
    float value = 0;
    Task get_return_object() { return {std::coroutine_handle<promise_type>::from_promise(*this)}; }
    static std::suspend_always initial_suspend() { return {}; }
    static std::suspend_always final_suspend() noexcept { return {}; }
    void return_value(float x) { value = x; }
    static void unhandled_exception() { std::terminate(); }
  };
  std::coroutine_handle<promise_type> handle;
};
template <class View>
struct Stores {
  View view;
  index_t i;
  [[nodiscard]] static bool await_ready() { return true; }
  static void await_suspend(std::coroutine_handle<> /*of*/) {}
  void await_resume() const { view[i].volume() = 1.0F; }
};
template <class View>
Task read_later(View view, index_t i) {
  co_await Stores<View>{view, i};
  co_return view[i].dm_inverse()[2];
}
template <class View>
struct Coroutine {
  using Scalar = float;
  View view;
  void operator()(index_t i) const {
    const Task task = read_later(view, i);
    task.handle.resume();
    task.handle.destroy();
  }
};
PHYSGEN_TEST_KERNEL(Coroutine);

template <class View>
struct LambdaAsPointer {
  using Scalar = float;
  View view;
  void operator()(index_t i) const {
    float (*const read)(const View&, index_t) = [](const View& from, index_t k) -> float { return from[k].volume(); };
    (void)read(view, i);
  }
};
PHYSGEN_TEST_KERNEL(LambdaAsPointer);

template <class View>
struct StaticLambda {
  using Scalar = float;
  View view;
  void operator()(index_t i) const {
    static const auto write = [](const View& to, index_t k) { to[k].volume() = 1.0F; };
    write(view, i);
  }
};
PHYSGEN_TEST_KERNEL(StaticLambda);

/// An object whose structured bindings are the members that get() gives.
template <class View>
struct TupleLike {
  View view;
  index_t i;
  template <std::size_t k>
  [[nodiscard]] float get() const {
    if constexpr (k == 0)
      return view[i].volume();
    else
      return view[i].dm_inverse()[int{k}];
  }
};
}  // namespace unusual

template <class View>
struct std::tuple_size<unusual::TupleLike<View>> : std::integral_constant<std::size_t, 2> {};
template <std::size_t k, class View>
struct std::tuple_element<k, unusual::TupleLike<View>> {
  using type = float;
};

namespace unusual {

template <class View>
struct BindsTuple {
  using Scalar = float;
  View view;
  void operator()(index_t i) const {
    const auto [volume, element] = TupleLike<View>{view, i};
    (void)(volume + element);
  }
};
PHYSGEN_TEST_KERNEL(BindsTuple);

template <class View>
struct ByFriend {
  using Scalar = float;
  View view;
  friend void store(const ByFriend& kernel, index_t i) { kernel.view[i].volume() = 2.0F; }
  void operator()(index_t i) const { store(*this, i); }
};
PHYSGEN_TEST_KERNEL(ByFriend);

template <class View>
struct Comma {
  using Scalar = float;
  View view;
  struct Next {
    View view;
    index_t i;
    float operator,(float x) const {
      view[i].volume() = x;
      return x;
    }
  };
  void operator()(index_t i) const { (void)(Next{view, i}, float(view[i].dm_inverse()[0])); }
};
PHYSGEN_TEST_KERNEL(Comma);

template <class View>
struct Designated {
  using Scalar = float;
  View view;
  struct Numbers {
    View view;
    float first = view[0].volume();
    float second = 0;
  };
  void operator()(index_t i) const { (void)Numbers{.view = view, .second = view[i].dm_inverse()[1]}.first; }
};
PHYSGEN_TEST_KERNEL(Designated);

template <class View>
struct OverRanges {
  using Scalar = float;
  View view;
  void operator()(index_t i) const {
    auto volumes = std::views::iota(i, i + 3) | std::views::filter([](index_t k) { return k % 2 == 0; }) |
                   std::views::transform([this](index_t k) -> float { return view[k].volume(); });
    float sum = 0;
    for (const float volume : volumes) sum += volume;
    (void)sum;
  }
};
PHYSGEN_TEST_KERNEL(OverRanges);

template <class View>
struct Invoked {
  using Scalar = float;
  View view;
  void store(index_t i) const { view[i].volume() = 3.0F; }
  void operator()(index_t i) const { std::invoke(&Invoked::store, *this, i); }
};
PHYSGEN_TEST_KERNEL(Invoked);

template <class View>
void store_in(const View& view, index_t i) {
  view[i].volume() = 4.0F;
}
template <class View>
struct Applied {
  using Scalar = float;
  View view;
  void operator()(index_t i) const { std::apply(store_in<View>, std::make_tuple(view, i)); }
};
PHYSGEN_TEST_KERNEL(Applied);

template <class View>
void add_to(const View& view, index_t i) {
  view[i].volume() += 4.0F;
}
}  // namespace unusual
