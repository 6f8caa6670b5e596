// Kernels that reach their views by seldom used ways of C++: coroutines, comparison operators, tables of functions,
// members of tuples, ... Compiled into usage_analysis_test, where the compiler registers what it finds, and read by
// the analysis. Arrays are named by the way.
#include <elasticity.physgen.h>
#include <physgen/kernel.h>
#include <physgen/probe.h>

#include <array>
#include <compare>
#include <cstddef>
#include <memory>
#include <new>
#include <variant>

#include "unusual_kernels.h"

namespace unusual {

using namespace physgen;

#define PHYSGEN_TEST_ARRAY(Tag)                          \
  struct Tag##_tag {                                     \
    static constexpr const char* name = "unusual." #Tag; \
  };                                                     \
  ProbeOf<elasticity::RestShapeArray<float>, Tag##_tag> Tag

struct Arrays {
  PHYSGEN_TEST_ARRAY(coroutine);
  PHYSGEN_TEST_ARRAY(lambda_as_pointer);
  PHYSGEN_TEST_ARRAY(static_lambda);
  PHYSGEN_TEST_ARRAY(tuple_like);
  PHYSGEN_TEST_ARRAY(by_friend);
  PHYSGEN_TEST_ARRAY(comma);
  PHYSGEN_TEST_ARRAY(designated);
  PHYSGEN_TEST_ARRAY(ranges);
  PHYSGEN_TEST_ARRAY(invoked);
  PHYSGEN_TEST_ARRAY(applied);
  PHYSGEN_TEST_ARRAY(table);
  PHYSGEN_TEST_ARRAY(inherited);
  PHYSGEN_TEST_ARRAY(compared);
  PHYSGEN_TEST_ARRAY(caught);
  PHYSGEN_TEST_ARRAY(jumped);
  PHYSGEN_TEST_ARRAY(mutual);
  PHYSGEN_TEST_ARRAY(visited);
  PHYSGEN_TEST_ARRAY(allocated);
  PHYSGEN_TEST_ARRAY(placed);
};

/// A table of functions, one of which AddsToo calls, too.
template <class View>
struct Functions {
  static constexpr std::array<void (*)(const View&, index_t), 1> adding = {&add_to<View>};
};
template <class View>
struct ByTable {
  using Scalar = float;
  View view;
  Functions<View> functions = {};
  explicit ByTable(View of) : view(of) {}
  void operator()(index_t i) const { functions.adding[0](view, i); }
};
template <class View>
struct AddsToo {
  using Scalar = float;
  View view;
  void operator()(index_t i) const { add_to(view, i); }
};
PHYSGEN_TEST_KERNEL(AddsToo);

template <class View>
struct Base {
  using Scalar = float;
  View view;
  void operator()(index_t i) const { view[i].volume() = 5.0F; }
};
template <class View>
struct Inherited : Base<View> {
  using Base<View>::operator();
};

template <class View>
struct ByVolume {
  View view;
  index_t i;
  friend std::partial_ordering operator<=>(const ByVolume& a, const ByVolume& b) {
    return float(a.view[a.i].volume()) <=> float(b.view[b.i].volume());
  }
  friend bool operator==(const ByVolume& a, const ByVolume& b) {
    return a.view[a.i].dm_inverse()[0] == b.view[b.i].dm_inverse()[0];
  }
};
template <class View>
struct Compared {
  using Scalar = float;
  View view;
  struct Pair {
    ByVolume<View> first;
    friend auto operator<=>(const Pair&, const Pair&) = default;
    friend bool operator==(const Pair&, const Pair&) = default;
  };
  void operator()(index_t i) const {
    const Pair a{{view, i}}, b{{view, i + 1}};
    (void)(a < b || a != b);
  }
};
PHYSGEN_TEST_KERNEL(Compared);

template <class View>
struct Caught {
  using Scalar = float;
  View view;
  void operator()(index_t i) const {
    try {
      if (i < 0) throw 1;
    } catch (int) {
      view[i].volume() = 6.0F;
    }
  }
};
PHYSGEN_TEST_KERNEL(Caught);

template <class View>
struct Jumped {
  using Scalar = float;
  View view;
  void operator()(index_t i) const {
    goto end;
    view[i].dm_inverse()[0] = 1.0F;
  end:
    view[i].volume() = 7.0F;
  }
};
PHYSGEN_TEST_KERNEL(Jumped);

template <class View>
void even(const View& view, index_t i);
template <class View>
void odd(const View& view, index_t i) {
  if (i > 0) even(view, i - 1);
}
template <class View>
void even(const View& view, index_t i) {
  view[i].volume() = 8.0F;
  odd(view, i);
}
template <class View>
struct Mutual {
  using Scalar = float;
  View view;
  void operator()(index_t i) const { odd(view, i); }
};
PHYSGEN_TEST_KERNEL(Mutual);

template <class View>
struct Visited {
  using Scalar = float;
  View view;
  struct Visitor {
    View view;
    void operator()(index_t i) const { view[i].volume() = 9.0F; }
    void operator()(float /*x*/) const { (void)view[0].dm_inverse().get(); }
  };
  void operator()(index_t i) const { std::visit(Visitor{view}, std::variant<index_t, float>(i)); }
};
PHYSGEN_TEST_KERNEL(Visited);

template <class View>
struct Allocates {
  static inline const View* stored_to = nullptr;
  static void* operator new(std::size_t bytes) {
    (*stored_to)[0].volume() = 10.0F;
    return ::operator new(bytes);
  }
};
template <class View>
struct Allocated {
  using Scalar = float;
  View view;
  void operator()(index_t /*i*/) const { const std::unique_ptr<Allocates<View>> made(new Allocates<View>); }
};
PHYSGEN_TEST_KERNEL(Allocated);

template <class View>
struct Placed {
  using Scalar = float;
  View view;
  void operator()(index_t i) const {
    alignas(std::max_align_t) std::array<std::byte, 3 * sizeof(float)> room;
    const float* const numbers = new (room.data()) float[3]{view[i].volume(), 1.0F, 2.0F};
    view[i].dm_inverse()[0] = numbers[0];
  }
};
PHYSGEN_TEST_KERNEL(Placed);

template <class On>
void program(On& on, Arrays& a) {
  on.run(1, Coroutine{a.coroutine.view()});
  on.run(1, LambdaAsPointer{a.lambda_as_pointer.const_view()});
  on.run(1, StaticLambda{a.static_lambda.view()});
  on.run(1, BindsTuple{a.tuple_like.view()});
  on.run(1, ByFriend{a.by_friend.view()});
  on.run(1, Comma{a.comma.view()});
  on.run(1, Designated{a.designated.view()});
  on.run(1, OverRanges{a.ranges.view()});
  on.run(1, Invoked{a.invoked.view()});
  on.run(1, Applied{a.applied.view()});
  on.run(1, ByTable(a.table.view()));
  on.run(1, AddsToo{a.table.view()});
  on.run(1, Inherited<decltype(a.inherited.view())>{{a.inherited.view()}});
  on.run(1, Compared{a.compared.view()});
  on.run(1, Caught{a.caught.view()});
  on.run(1, Jumped{a.jumped.view()});
  on.run(1, Mutual{a.mutual.view()});
  on.run(1, Visited{a.visited.view()});
  on.run(1, Allocated{a.allocated.view()});
  on.run(1, Placed{a.placed.view()});
}

template void program(ProbeExecutor<Host>& on, Arrays& a);

}  // namespace unusual
