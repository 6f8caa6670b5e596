// Choices of a program for the generated arrays of a scene: their precision, layouts and formats; and their bytes,
// which are known before.
#include <derivative_chain.scene.h>
#include <gtest/gtest.h>
#include <physgen/format/half.h>

namespace physgen::test {
namespace {

namespace scene = scenes::derivative_chain_scene;

constexpr index_t tets = 103;  // the last pack is not whole

TEST(GeneratedScene, knows_its_bytes_before_it_holds_them) {
  for (const index_t n : {index_t{0}, index_t{1}, tets}) {
    scene::Body<Host, double> body;
    scene::State<> state;
    body.allocate({.node = n, .tet = 2 * n});
    state.allocate({.tet = n});
    EXPECT_EQ((scene::Body<Host, double>::bytes({.node = n, .tet = 2 * n})), body.bytes()) << n;
    EXPECT_EQ(scene::State<>::bytes({.tet = n}), state.bytes()) << n;
  }
  EXPECT_EQ(scene::State<>::bytes({.tet = tets}), 128 * (36 + 12 + 12 + 8)) << "103 objects take the room of 128";
}

template <class Formats>
struct StretchesInHalf : Formats {
  using s = format::Half<>;
  using U = format::Half<>;  // is pruned
};
/// Stretches in half, and derivatives as records.
struct Compact {
  template <class Tag, class Array>
  struct OfArray {
    using type = Array;
  };
  template <class Tag, class Array>
    requires(is_named<Tag>("state.svds"))
  struct OfArray<Tag, Array> {
    using type = WithFormats<Array, StretchesInHalf<typename Array::Formats>>;
  };
  template <class Tag, class Array>
    requires(is_named<Tag>("state.derivatives"))
  struct OfArray<Tag, Array> {
    using type = WithLayout<Array, Aos>;
  };
  template <class Tag, class Array>
  using Of = typename OfArray<Tag, Array>::type;
};

TEST(GeneratedScene, has_the_precision_layouts_and_formats_that_a_program_chooses) {
  using State = scene::State<Host, double, Compact>;
  static_assert(std::is_same_v<decltype(State::gradients), elasticity::DeformationGradientArray<double>>);
  EXPECT_EQ(decltype(State::svds)::record_bytes, 6) << "s in half; U and V stay pruned";
  static_assert(std::is_same_v<decltype(State::svds)::View::Precision, double>);
  static_assert(std::is_same_v<decltype(State::derivatives)::View::Layout, Aos>);
  EXPECT_EQ(decltype(State::derivatives)::record_bytes, 16);
  static_assert(std::is_same_v<decltype(State::stretches), elasticity::PrincipalStretchesArray<double>>);

  State state;
  state.allocate({.tet = tets});
  state.svds.view()[index_t{3}].s() = Eigen::Vector3d(0.5, 1, 1.0 + 1e-9);
  EXPECT_EQ(state.svds.view()[index_t{3}].s().get()[2], 1.0) << "as half has it";
  EXPECT_EQ(state.bytes(), State::bytes({.tet = tets}));
}

}  // namespace
}  // namespace physgen::test
