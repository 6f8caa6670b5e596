// The catalogue of materials. Tests, the solvers, their build and the command line read its rows: a new model is a
// header, its #include and a row here, and its plain energy in reference/energy.h.
#pragma once

#include <fem/materials/corotated.h>
#include <fem/materials/fixed_corotated.h>
#include <fem/materials/mooney_rivlin.h>
#include <fem/materials/neo_hookean.h>
#include <fem/materials/st_venant_kirchhoff.h>
#include <fem/materials/stable_neo_hookean.h>
#include <fem/materials/stable_neo_hookean_full.h>

#include <concepts>
#include <tuple>

/// A row: the model, its header in this folder, and the name by which users choose it. ROW is a macro that takes them,
/// and behind them what else is given here. CMake reads these lines, too (physgen_read_rows).
#define PHYSGEN_MATERIALS(ROW, ...)                                                          \
  ROW(NeoHookean, neo_hookean, "neo-hookean", __VA_ARGS__)                                   \
  ROW(StVenantKirchhoff, st_venant_kirchhoff, "st-venant-kirchhoff", __VA_ARGS__)            \
  ROW(Corotated, corotated, "corotated", __VA_ARGS__)                                        \
  ROW(FixedCorotated, fixed_corotated, "fixed-corotated", __VA_ARGS__)                       \
  ROW(StableNeoHookean, stable_neo_hookean, "stable-neo-hookean", __VA_ARGS__)               \
  ROW(StableNeoHookeanFull, stable_neo_hookean_full, "stable-neo-hookean-full", __VA_ARGS__) \
  ROW(MooneyRivlin, mooney_rivlin, "mooney-rivlin", __VA_ARGS__)

namespace physgen::fem {

/// Whether a model has what material.h asks of it.
template <class Model>
concept IsMaterial = requires(const Model& model, const Vector3<typename Model::Scalar>& s) {
  { Model::from(1.0, 0.3) } -> std::same_as<Model>;
  { model.energy(s) } -> std::convertible_to<typename Model::Scalar>;
  { model.stress(s) } -> std::convertible_to<Vector3<typename Model::Scalar>>;
  { model.derivative(s) } -> std::same_as<PrincipalDerivative<typename Model::Scalar>>;
};

#define PHYSGEN_CHECK_MATERIAL(Model, header, word, ...)                  \
  static_assert(IsMaterial<Model<double>>,                                \
                "the row " #Model                                         \
                " of PHYSGEN_MATERIALS names a model that lacks from(), " \
                "energy(), stress() or derivative(); materials/material.h says what they are");
PHYSGEN_MATERIALS(PHYSGEN_CHECK_MATERIAL)
#undef PHYSGEN_CHECK_MATERIAL

template <class... Models>
struct MaterialList {};

namespace detail {
template <class First, class... Models>
MaterialList<Models...> without_first(std::tuple<First, Models...>);
}  // namespace detail

#define PHYSGEN_LIST_MATERIAL(Model, header, word, ...) , Model<Real>
template <class Real>
using AllMaterials = decltype(detail::without_first(std::tuple<void* PHYSGEN_MATERIALS(PHYSGEN_LIST_MATERIAL)>()));
#undef PHYSGEN_LIST_MATERIAL

}  // namespace physgen::fem
