// Arrays of the scene relax for several ranks. Written by physgen from scenes/relax.h and the kernels that it runs:
// change these, not this file.
#pragma once

#include <physgen/distributed/distributed_scene.h>

#include <utility>

#include "relax.halos.h"
#include "relax.program.h"

namespace scenes::relax_scene {

/// The arrays of this rank, and what crosses to others: Body, with the functions of physgen::DistributedScene.
template <class Space_ = physgen::Host, class Real_ = float, class Stored_ = physgen::StoredAsDeclared>
  requires physgen::SpaceOfRanks<Space_>
struct Distributed : Body<Space_, Real_, Stored_>, physgen::DistributedScene {
  /// How many objects all ranks together have of each kind.
  struct Counts {
    physgen::index_t node = not_given;
    physgen::index_t edge = not_given;
    /// Of entries; if given, it is compared with the rows.
    physgen::index_t end = not_given;
  };

  /// @throw physgen::Error when a number of objects is not given or is negative
  Distributed(const physgen::Ranks& ranks, const Counts& counts) : DistributedScene(ranks, halos) {
    scene_.add_set("node", counts.node);
    scene_.add_set("edge", counts.edge);
    scene_.follow("edge", "node");
    scene_.add_array("body.positions", "node", this->positions);
    scene_.add_array("body.forces", "node", this->forces, {"f"});
    scene_.add_array("body.edges", "edge", this->edges);
    scene_.add_array("body.pulls", "edge", this->pulls, {"f"});
    scene_.add_array("body.ranges", "node", this->ranges);
    scene_.names(this->edges, "nodes", "node");
    scene_.rows(this->ranges, "body.ends", this->ends, "element", "edge", 0, counts.end);
  }
  void allocate() = delete;  // cut() gives the arrays their objects
};

/// The scene's program over them; `on` is a DistributedExecutor of theirs.
template <class On, class Space, class Real, class Stored, class... Parameters>
void program(On& on, Distributed<Space, Real, Stored>& all, Parameters&&... parameters) {
  fused::program(on, static_cast<Body<Space, Real, Stored>&>(all), std::forward<Parameters>(parameters)...);
}

}  // namespace scenes::relax_scene
