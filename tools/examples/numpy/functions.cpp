// What Python calls: the bodies' motion, as a kernel over the memory that NumPy sees.
#include <physgen/kernel.h>
#include <physgen/parallel_for.h>
#include <physgen/python/module.h>
#include <solar.physgen.h>

using namespace physgen;  // where kernels stand: their words are found for one object and for packs
using namespace physgen::math;

/// Steps of one body: v -= dt GM x / |x|^3, then x += dt v.
template <class View>
struct Move {
  using Scalar = typename View::Precision;
  View bodies;
  Scalar dt, pull;  ///< step [year], GM of the sun [au^3/year^2]
  int steps;

  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    using S = lanes_t<Scalar, I>;
    using Vector = Eigen::Matrix<S, 3, 1>;
    Vector x = bodies[i].x(), v = bodies[i].v();
    for (int step = 0; step < steps; ++step) {
      const S square = x.squaredNorm();
      v -= x * S(S(dt * pull) / (square * sqrt(square)));
      x += v * S(dt);
    }
    bodies[i].x() = x;
    bodies[i].v() = v;
  }
};

/// Moves all bodies. @throw Error where they are not what the kernel is compiled for
void move(const python::Objects<model::BodyObject>& bodies, double dt, int steps, double pull) {
  const auto view = bodies.view<model::BodyArray<double>>();
  parallel_for(Host{}, view.size(), Move<std::remove_const_t<decltype(view)>>{view, dt, pull, steps});
}

void physgen::python::add_functions(py::module_& module) {
  module.def("move", &move, py::arg("bodies"), py::arg("dt"), py::arg("steps"), py::arg("pull"),
             "Moves bodies (in double) by so many steps of dt years.");
}
