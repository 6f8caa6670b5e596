// The inputs of all kernels: the elements of the tetrahedralised Truth Cube, compressed. Made on first use, once, in
// double.
#pragma once

#include <elasticity.physgen.h>
#include <fem/truth_cube.h>

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>

namespace physgen::bench {

/// What the objects of an array belong to; the last three are incidences, (object, element) pairs.
enum class Domain { tets, nodes, edges, node_tets, node_edges, edge_tets };

struct MeshSizes {
  double tets, nodes, edges;
};

/// Values of one object type for all of a mesh. Rows take them from here, rounded to their storage.
template <class Object>
using Master = Array<Object, double, Host, Aosoa<16>>;

/// The smallest cube of cells^3 x 6 tets with at least as many tets as wanted. Kernels over tets run over the first
/// wanted ones, kernels over nodes and edges over all of the mesh.
class Dataset {
 public:
  /// Nothing is made yet. @param tets how many are wanted, 1 or more
  explicit Dataset(index_t tets);

  /// Objects of `domain` in an array that takes part in a kernel over `kernel_domain`.
  [[nodiscard]] index_t count(Domain domain, Domain kernel_domain) const;
  /// The same, of all objects.
  [[nodiscard]] MeshSizes sizes(Domain kernel_domain) const;
  [[nodiscard]] fem::Index cells() const { return cells_; }
  const fem::TetMesh& mesh() { return cube().mesh; }

  /// Incidences of a domain: a range of entries for each node or edge.
  struct Incidences {
    Master<elasticity::IncidenceRangeObject> ranges;
    Master<elasticity::IncidenceObject> entries;
  };
  const Incidences& incidences(Domain entries);

  // All of these throw Error when there is not enough memory.
  const Master<elasticity::TetObject>& tets();
  const Master<elasticity::EdgeObject>& edges();
  const Master<elasticity::NodePositionObject>& positions();
  const Master<elasticity::NodeDisplacementObject>& displacements();  ///< smooth, with noise, to 1e-3 of the side
  const Master<elasticity::RestShapeObject>& rest_shapes();
  const Master<elasticity::DeformationGradientObject>& deformation_gradients();
  const Master<elasticity::DeformationGradientDifferentialObject>& differentials();
  const Master<elasticity::DeformationSvdObject>& svds();
  const Master<elasticity::StressDerivativeObject>& stress_derivatives();
  const Master<elasticity::StressObject>& stresses();
  const Master<elasticity::CornerForcesObject>& corner_forces();
  const Master<elasticity::TetStiffnessObject>& tet_stiffness();
  const Master<elasticity::NodeStiffnessObject>& node_stiffness();
  const Master<elasticity::EdgeStiffnessObject>& edge_stiffness();

  /// The reference that was asked for last is kept, so that all layouts of a kernel share it.
  template <class Values>
  const Values& reference(const std::string& key, const std::function<Values()>& make) {
    if (key != reference_key_) {
      reference_.reset();
      reference_ = std::make_shared<Values>(make());
      reference_key_ = key;
    }
    return *static_cast<const Values*>(reference_.get());
  }

 private:
  /// The member of this type, made by make() -> T when it is asked for first.
  template <class T, class Make>
  const T& once(const Make& make, int key = 0);
  template <class Kernel>
  const auto& output_of();
  const fem::TruthCube& cube();

  index_t wanted_;
  fem::Index cells_;
  std::optional<fem::TruthCube> cube_;
  std::map<std::string, std::shared_ptr<const void>> made_;
  std::shared_ptr<const void> reference_;
  std::string reference_key_;
};

}  // namespace physgen::bench
