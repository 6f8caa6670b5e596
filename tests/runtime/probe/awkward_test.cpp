// Kernels whose reads and writes are hard to find for whoever reads their text: probes find them all. What must not
// compile stands in refused_probes.cpp.
#include <physgen/executor.h>

#include <algorithm>
#include <functional>
#include <tuple>

#include "probe_checks.h"

namespace physgen {
namespace {

using namespace test;

template <class View>
struct WholeObject {
  using Scalar = float;
  View view;
  template <class I>
  void operator()(I i) const {
    const auto svd = view.get(i);
    (void)svd.s;
  }
};
template <class View>
WholeObject(View) -> WholeObject<View>;

PHYSGEN_TEST_ARRAY(whole);
TEST(Probes, take_a_whole_object_for_all_of_its_fields) {
  Svds<whole> svds;
  ProbeExecutor<Host>().run(1, WholeObject{svds.const_view()});
  EXPECT_EQ(fields_of("whole"), all_of_svd);
}

template <class From, class To>
struct StructuredBinding {
  using Scalar = float;
  From from;
  To to;
  template <class I>
  void operator()(I i) const {
    const auto [U, V, s] = from.get(i);
    to.put(i, {V, U, s});
  }
};
template <class From, class To>
StructuredBinding(From, To) -> StructuredBinding<From, To>;

PHYSGEN_TEST_ARRAY(bound);
PHYSGEN_TEST_ARRAY(put);
TEST(Probes, take_a_structured_binding_for_all_fields) {
  Svds<bound> from;
  Svds<put> to;
  ProbeExecutor<Host>().run(1, StructuredBinding{from.const_view(), to.view()});
  EXPECT_EQ(fields_of("bound"), all_of_svd);
  EXPECT_EQ(fields_of("put"), (Fields{"U W", "V W", "s W"}));
}

template <class View>
struct GenericLambda {
  using Scalar = float;
  View view;
  template <class I>
  void operator()(I i) const {
    using Vector = Eigen::Matrix<lanes_t<float, I>, 3, 1>;
    const auto made = [](auto&& field) { return Vector(std::forward<decltype(field)>(field).get()); };
    view[i].s() = Vector(made(view[i].s()) + made(view[i].s()));
  }
};
template <class View>
GenericLambda(View) -> GenericLambda<View>;

PHYSGEN_TEST_ARRAY(lambda);
TEST(Probes, see_through_a_generic_lambda_around_a_constructor) {
  Svds<lambda> svds;
  ProbeExecutor<Host>().run(1, GenericLambda{svds.view()});
  EXPECT_EQ(fields_of("lambda"), Fields{"s RW"});
}

template <class View>
struct InFunctionObject {
  View view;
  void operator()(index_t i) const {
    const std::function<float(index_t)> read = [this](index_t k) -> float { return view[k].x2121(); };
    view[i].x2112() = read(i);
  }
};
template <class View>
InFunctionObject(View) -> InFunctionObject<View>;

PHYSGEN_TEST_ARRAY(function);
TEST(Probes, see_through_std_function) {
  Derivatives<function> derivatives;
  Perform()(InFunctionObject{derivatives.view()});
  EXPECT_EQ(fields_of("function"), (Fields{"x2112 W", "x2121 R"}));
}

template <class View>
struct InAlgorithm {
  View view;
  void operator()(index_t i) const {
    const std::array<index_t, 3> neighbours{i, i + 1, i + 2};
    std::for_each(neighbours.begin(), neighbours.end(), [this](index_t k) { view[k].x3333() = 1.0F; });
  }
};
template <class View>
InAlgorithm(View) -> InAlgorithm<View>;

PHYSGEN_TEST_ARRAY(algorithm);
TEST(Probes, see_through_std_algorithms) {
  Derivatives<algorithm> derivatives;
  Perform()(InAlgorithm{derivatives.view()});
  EXPECT_EQ(fields_of("algorithm"), Fields{"x3333 W"});
}

struct Reader {
  Reader() = default;
  Reader(const Reader&) = default;
  virtual ~Reader() = default;
  [[nodiscard]] virtual float read(index_t i) const = 0;
};
template <class View>
struct VolumeReader final : Reader {
  View view;
  explicit VolumeReader(const View& from) : view(from) {}
  [[nodiscard]] float read(index_t i) const override { return view[i].volume(); }
};
template <class View>
struct VirtualCall {
  View view;
  void operator()(index_t i) const {
    const VolumeReader<View> volumes(view);
    const Reader& reader = volumes;
    EXPECT_EQ(reader.read(i), 0);
  }
};
template <class View>
VirtualCall(View) -> VirtualCall<View>;

PHYSGEN_TEST_ARRAY(by_virtual_call);
TEST(Probes, see_through_virtual_calls) {
  Shapes<by_virtual_call> shapes;
  Perform()(VirtualCall{shapes.const_view()});
  EXPECT_EQ(fields_of("by_virtual_call"), Fields{"volume R"});
}

template <class View>
float volume_of(const View& view, index_t i) {
  return view[i].volume();
}
template <class View>
struct FunctionPointer {
  View view;
  void operator()(index_t i) const {
    float (*const pointer)(const View&, index_t) = &volume_of<View>;
    EXPECT_EQ(pointer(view, i), 0);
  }
};
template <class View>
FunctionPointer(View) -> FunctionPointer<View>;

PHYSGEN_TEST_ARRAY(by_pointer);
TEST(Probes, see_through_function_pointers) {
  Shapes<by_pointer> shapes;
  Perform()(FunctionPointer{shapes.const_view()});
  EXPECT_EQ(fields_of("by_pointer"), Fields{"volume R"});
}

template <class First, class Second>
struct InTuple {
  using Scalar = float;
  std::tuple<First, Second> views;
  template <class I>
  void operator()(I i) const {
    using S = lanes_t<float, I>;
    const auto& [first, second] = views;
    second[i].volume() = S(std::get<0>(views)[i].x1111());
    (void)first;
  }
};
template <class First, class Second>
InTuple(std::tuple<First, Second>) -> InTuple<First, Second>;

PHYSGEN_TEST_ARRAY(first_of_tuple);
PHYSGEN_TEST_ARRAY(second_of_tuple);
TEST(Probes, see_through_tuples) {
  Derivatives<first_of_tuple> first;
  Shapes<second_of_tuple> second;
  ProbeExecutor<Host>().run(1, InTuple{std::tuple(first.const_view(), second.view())});
  EXPECT_EQ(fields_of("first_of_tuple"), Fields{"x1111 R"});
  EXPECT_EQ(fields_of("second_of_tuple"), Fields{"volume W"});
}

template <class View>
struct EitherView {
  View v, w;
  void operator()(index_t i) const {
    const View& chosen = i % 2 == 0 ? v : w;
    chosen[i].x2211() = i == 7 ? float(v[i].x3311()) : float(w[i].x3322());
  }
};
template <class View>
EitherView(View, View) -> EitherView<View>;

PHYSGEN_TEST_ARRAY(either);
TEST(Probes, unite_both_sides_of_a_condition) {
  Derivatives<either> derivatives;
  Perform()(EitherView{derivatives.view(), derivatives.view()});
  EXPECT_EQ(fields_of("either"), (Fields{"x2211 W", "x3311 R", "x3322 R"}));
}

template <bool kWithVolume, class View>
struct Operands {
  using Scalar = float;
  View view;
  template <class I>
  void operator()(I i) const {
    using Matrix = std::remove_cvref_t<decltype(view[i].dm_inverse().get())>;
    static_assert(sizeof(view[i].volume()) > 0);
    if constexpr (kWithVolume) view[i].volume() = lanes_t<float, I>(1.0F);
    view[i].dm_inverse() = Matrix(Matrix::Constant(lanes_t<float, I>(0.0F)));
  }
};

PHYSGEN_TEST_ARRAY(unevaluated);
PHYSGEN_TEST_ARRAY(evaluated);
TEST(Probes, leave_out_what_is_not_evaluated_and_what_if_constexpr_leaves_out) {
  Shapes<unevaluated> without;
  Shapes<evaluated> with;
  ProbeExecutor<Host> on;
  on.run(1, Operands<false, Shapes<unevaluated>::View>{without.view()});
  on.run(1, Operands<true, Shapes<evaluated>::View>{with.view()});
  EXPECT_EQ(fields_of("unevaluated"), Fields{"dm_inverse W"});
  EXPECT_EQ(fields_of("evaluated"), (Fields{"dm_inverse W", "volume W"}));
}

template <class TetView, class ForceView>
struct ReferenceAsIndex {
  using Scalar = float;
  TetView tets;
  ForceView forces;
  template <class I>
  void operator()(I i) const {
    const auto value = forces[tets[i].nodes()[0]].f().get();
    add(i, forces[tets[i].nodes()[1]].f(), value);
    forces.put(tets[i].nodes()[2], forces.get(tets[i].nodes()[3]));
  }
};
template <class TetView, class ForceView>
ReferenceAsIndex(TetView, ForceView) -> ReferenceAsIndex<TetView, ForceView>;

PHYSGEN_TEST_ARRAY(corners);
PHYSGEN_TEST_ARRAY(corner_forces);
TEST(Probes, take_references_as_indices) {
  Tets<corners> tets;
  Forces<corner_forces> forces;
  ProbeExecutor<Host>().run(1, ReferenceAsIndex{tets.const_view(), forces.view()});
  EXPECT_EQ(fields_of("corners"), Fields{"nodes R"});
  EXPECT_EQ(fields_of("corner_forces"), Fields{"f RW"});
}

// The same kernel where it runs: with indices of single objects and of packs.
TEST(Probes, leave_references_as_indices_what_they_are_without_probes) {
  constexpr index_t tets = 37;
  elasticity::TetArray<float> corners(tets);
  elasticity::NodeForceArray<float> packs(4 * tets), singles(4 * tets);
  for (index_t t = 0; t < tets; ++t) {
    for (int c = 0; c < 4; ++c) corners.view()[t].nodes()[c] = static_cast<std::int32_t>(4 * t + c);
  }
  for (index_t n = 0; n < 4 * tets; ++n) {
    packs.view()[n].f() = Eigen::Vector3f(float(n) + 1.0F, 2.0F * float(n), -3.0F);
    singles.view()[n].f() = packs.view()[n].f().get();
  }
  parallel_for(Host{}, tets, ReferenceAsIndex{corners.const_view(), packs.view()});
  parallel_for(Host{}, tets, lanes<1>(ReferenceAsIndex{corners.const_view(), singles.view()}));
  for (index_t t = 0; t < tets; ++t) {
    const auto at = [t](int c) { return Eigen::Vector3f(float(4 * t + c) + 1.0F, 2.0F * float(4 * t + c), -3.0F); };
    for (const auto* forces : {&packs, &singles}) {
      EXPECT_EQ(forces->const_view()[4 * t].f().get(), at(0));
      EXPECT_EQ(forces->const_view()[4 * t + 1].f().get(), at(0) + at(1));
      EXPECT_EQ(forces->const_view()[4 * t + 2].f().get(), at(3));
    }
  }
}

}  // namespace
}  // namespace physgen
