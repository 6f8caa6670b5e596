// The Truth Cube as data of rows: the elements of the tetrahedralised, compressed cube. Made on first use, once, in
// double. It knows no kernel: what kernels make of it, they keep here.
#pragma once

#include <elasticity.physgen.h>
#include <fem/mesh/truth_cube.h>

#include <memory>
#include <string>

#include "data/kept.h"

namespace physgen::bench {

/// The things that an array has an object for; the last three are incidences, (object, element) pairs.
enum class Domain { tets, nodes, edges, node_tets, node_edges, edge_tets };

/// A numbering of nodes and tets: as the mesh was made, at random, or the random ones renumbered for locality.
enum class Numbering { ordered, random, renumbered };
[[nodiscard]] const char* name(Numbering numbering);

/// Values of one object type for all of a mesh. Rows take them from here, rounded to their storage.
template <class Object>
using Master = Array<Object, double, Host, Aosoa<16>>;

/// The smallest cube of cells^3 x 6 tets with at least as many tets as wanted. Kernels over tets run over the first
/// wanted ones, kernels over nodes and edges over all of the mesh.
class Scene : public Kept {
 public:
  /// Nothing is made yet. @param tets how many are wanted, 1 or more
  explicit Scene(index_t tets, Numbering numbering = Numbering::ordered);

  /// Objects of `domain` in an array that takes part in a kernel over `kernel_domain`.
  [[nodiscard]] index_t count(Domain domain, Domain kernel_domain) const;
  /// Bytes that the mesh takes before any row, about.
  [[nodiscard]] double memory() const;
  /// @throw Error when there is not enough memory
  const fem::TruthCube& cube();

 private:
  index_t wanted_;
  fem::Index cells_ = 1;
  Numbering numbering_;
  std::unique_ptr<const fem::TruthCube> cube_;
};

/// The scene of these tets and numbers that rows share.
[[nodiscard]] inline std::shared_ptr<Scene> scene_of(index_t tets, Numbering numbering = Numbering::ordered) {
  return shared<Scene>(tets, numbering);
}

// The arrays of the scene itself, each with its object, its domain and its values.
namespace source {

template <class Object_, Domain kDomain>
struct Of {
  using Object = Object_;
  static constexpr Domain domain = kDomain;
};
struct Tets : Of<elasticity::TetObject, Domain::tets> {
  static const Master<Object>& of(Scene& scene);
};
struct RestShapes : Of<elasticity::RestShapeObject, Domain::tets> {
  static const Master<Object>& of(Scene& scene);
};
/// dF of the displacements.
struct Differentials : Of<elasticity::DeformationGradientDifferentialObject, Domain::tets> {
  static const Master<Object>& of(Scene& scene);
};
struct Edges : Of<elasticity::EdgeObject, Domain::edges> {
  static const Master<Object>& of(Scene& scene);
};
struct Positions : Of<elasticity::NodePositionObject, Domain::nodes> {
  static const Master<Object>& of(Scene& scene);
};
/// Smooth, with noise, to 1e-3 of the side.
struct Displacements : Of<elasticity::NodeDisplacementObject, Domain::nodes> {
  static const Master<Object>& of(Scene& scene);
};

/// Incidences of a domain: a range of entries for each node or edge.
struct Incidences {
  Master<elasticity::IncidenceRangeObject> ranges;
  Master<elasticity::IncidenceObject> entries;
};
const Incidences& incidences(Scene& scene, Domain entries);

// The elements that touch an object: the range of each, and the entries of all ranges.
template <Domain kObjects, Domain kEntries>
struct Ranges : Of<elasticity::IncidenceRangeObject, kObjects> {
  static const auto& of(Scene& scene) { return incidences(scene, kEntries).ranges; }
};
template <Domain kEntries>
struct Entries : Of<elasticity::IncidenceObject, kEntries> {
  static const auto& of(Scene& scene) { return incidences(scene, kEntries).entries; }
};

/// Where tets' corners stand among the entries of nodes.
struct TetPlaces : Of<elasticity::TetPlacesObject, Domain::tets> {
  static const Master<Object>& of(Scene& scene);
};

}  // namespace source

}  // namespace physgen::bench
