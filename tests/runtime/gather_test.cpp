// Gather from and scatter to objects that were allocated one by one, as simulators have them.
#include <physgen/gather.h>

#include <memory>

#include "test_objects.h"

namespace physgen::test {
namespace {

// A simulator's own class: nothing of physgen in it.
struct Particle {
  Eigen::Vector3d place;
  int label;
};

class Gather : public ::testing::Test {
 protected:
  explicit Gather(int count = 1003) {
    std::mt19937 random(seed());
    std::uniform_real_distribution<double> coordinate(-1, 1);
    for (int i = 0; i < count; ++i) {
      auto particle = std::make_unique<Particle>();
      particle->place = Eigen::Vector3d(coordinate(random), coordinate(random), coordinate(random));
      particle->label = i;
      owned_.push_back(std::move(particle));
    }
    std::shuffle(owned_.begin(), owned_.end(), random);
    for (const auto& particle : owned_) pointers_.push_back(particle.get());
  }

  static elasticity::NodePosition<double> to_value(const Particle& particle) { return {particle.place}; }
  [[nodiscard]] std::span<Particle* const> pointers() const { return pointers_; }

  std::vector<std::unique_ptr<Particle>> owned_;
  std::vector<Particle*> pointers_;
};

TEST_F(Gather, builds_an_array_in_the_order_of_the_pointers) {
  elasticity::NodePositionArray<double> array;
  gather(array, pointers(), to_value);
  ASSERT_EQ(array.size(), 1003);
  for (std::size_t i = 0; i < pointers_.size(); ++i) {
    const Eigen::Vector3d x = array.view()[static_cast<index_t>(i)].x();
    ASSERT_EQ(x, pointers_[i]->place);
  }
}

TEST_F(Gather, scatter_writes_changed_objects_back_and_leaves_the_rest_of_them) {
  elasticity::NodePositionArray<double, Host, Soa> array;
  gather(array, pointers_, to_value);  // a vector of pointers as it is
  const auto view = array.view();
  for (index_t i = 0; i < view.size(); ++i) view[i].x() = 2 * view[i].x().get();
  std::vector<Particle> before;
  for (const Particle* particle : pointers_) before.push_back(*particle);
  scatter(pointers(), array, [](Particle& particle, const auto& value) { particle.place = value.x; });
  for (std::size_t i = 0; i < pointers_.size(); ++i) {
    ASSERT_EQ(pointers_[i]->place, 2 * before[i].place);
    ASSERT_EQ(pointers_[i]->label, before[i].label);
  }
}

TEST_F(Gather, takes_handles_of_any_kind) {
  elasticity::NodePositionArray<double> array;
  gather_by(array, 10, [&](index_t i) { return to_value(*pointers_[static_cast<std::size_t>(100 * i)]); });
  ASSERT_EQ(array.size(), 10);
  const Eigen::Vector3d x = array.view()[7].x();
  EXPECT_EQ(x, pointers_[700]->place);
}

TEST_F(Gather, refuses_a_null_pointer_by_its_number_and_keeps_the_array) {
  elasticity::NodePositionArray<double> array(3);
  array.putdata(2, 1, 5);
  pointers_[17] = nullptr;
  try {
    gather(array, pointers(), to_value);
    FAIL() << "a null pointer was taken";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("pointer 17 of 1003 is null"), std::string::npos) << error.what();
  }
  EXPECT_EQ(array.size(), 3);
  EXPECT_EQ(array.getdata(2, 1), 5);
}

TEST_F(Gather, scatter_refuses_a_null_pointer_and_writes_nothing) {
  const elasticity::NodePositionArray<double> array(1003);
  pointers_[5] = nullptr;
  EXPECT_NE(message_of([&] {
              scatter(pointers(), array, [](Particle&, const auto&) { FAIL() << "an object was written"; });
            }).find("pointer 5 of 1003 is null"),
            std::string::npos);
}

TEST_F(Gather, keeps_the_array_when_an_object_cannot_be_had) {
  elasticity::NodePositionArray<double> array(1003);
  array.putdata(2, 1, 5);
  const auto failing = [](const Particle& particle) {
    if (particle.label == 700) throw std::runtime_error("object 700 is broken");
    return to_value(particle);
  };
  EXPECT_THROW(gather(array, pointers(), failing), std::runtime_error);
  EXPECT_EQ(array.getdata(2, 1), 5);
}

TEST_F(Gather, scatter_refuses_another_number_of_objects) {
  const elasticity::NodePositionArray<double> array(3);
  EXPECT_THROW(scatter(pointers(), array, [](Particle&, const auto&) { FAIL() << "an object was written"; }), Error);
}

}  // namespace
}  // namespace physgen::test
