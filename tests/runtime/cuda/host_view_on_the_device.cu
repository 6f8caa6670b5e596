// Must not become device code: a kernel on the device reaches a view of host memory. Host code of the same file may.
#include <elasticity.physgen.h>
#include <physgen/cuda/parallel_for.h>

using namespace physgen;

struct Double {
  elasticity::NodePositionArray<float, Host>::View positions;
  PHYSGEN_FUNCTION void operator()(index_t i) const { positions[i].x() *= 2.0F; }
};

void run(elasticity::NodePositionArray<float, Host>& positions) {
  positions.view()[0].x() = Eigen::Vector3f(1, 2, 3);
  parallel_for(Cuda{}, positions.size(), Double{positions.view()});
}
