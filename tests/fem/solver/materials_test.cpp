// Bodies of several materials: bars in series and in parallel, which are exact; and what no solver takes.
#include <fem/materials/material.h>
#include <fem/mesh/material_order.h>
#include <gtest/gtest.h>
#include <physgen/error.h>

#include <cmath>

#include "grouped_bar.h"

namespace physgen::fem {
namespace {

/// The bar as a file would have it, its tets shuffled, with a group of those beyond the middle along an axis.
ReadMesh halved_bar(std::size_t axis) {
  const Tets box = shuffled(irregular_box({2, 2, 4}, size, 0, 5), 11);
  ReadMesh mesh;
  mesh.rest = box.rest;
  mesh.tets = box.tets;
  MeshGroup beyond;
  beyond.name = "beyond";
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    mesh.tet_tags.push_back(100 + t);
    double middle = 0;
    for (const Index n : mesh.tets[t]) middle += mesh.rest[static_cast<std::size_t>(n)][axis] / 4;
    if (middle > size[axis] / 2) beyond.tets.push_back(static_cast<Index>(t));
  }
  complete(beyond, mesh.tets);
  mesh.groups.push_back(beyond);
  return mesh;
}

struct HalvedBar {
  std::vector<MeshLevel> levels{1};
  std::vector<std::vector<MeshGroup>> groups;

  HalvedBar(std::size_t axis, bool patches, int refinements) {
    ReadMesh mesh = halved_bar(axis);
    levels[0].material_ends = sort_by_material(mesh, std::vector<std::string>{"beyond"});
    levels[0].mesh = make_tet_mesh(static_cast<Index>(mesh.rest.size()), mesh.tets);
    levels[0].rest = mesh.rest;
    for (std::size_t k = 0; k < 3; ++k) {
      for (const double at : {0.0, size[k]}) {
        MeshGroup& group = mesh.groups.emplace_back();
        group.name = std::string(1, "xyz"[k]) + (at > 0 ? "1" : "0");
        for (const Face& face : boundary_faces(levels[0].mesh)) {
          const auto on = [&](Index n) { return levels[0].rest[static_cast<std::size_t>(n)][k] == at; };
          if (std::ranges::all_of(face, on)) group.faces.push_back(face);
        }
        complete(group, mesh.tets);
      }
    }
    groups.push_back(mesh.groups);
    for (int r = 0; r < refinements; ++r) {
      groups.insert(groups.begin(), refine_groups(levels[0].mesh, groups[0]));
      Refined finer = refine(levels[0].mesh, levels[0].rest);
      MeshLevel level;
      level.mesh = std::move(finer.mesh);
      level.rest = std::move(finer.rest);
      level.parents = std::move(finer.parents);
      for (const Index end : levels[0].material_ends) level.material_ends.push_back(8 * end);
      levels.insert(levels.begin(), std::move(level));
    }
    for (MeshLevel& level : levels) {
      if (patches) level.patches = greedy_patches(level.mesh, level.material_ends);
    }
  }
};

SolverSettings two_materials(double first_nu, double second_nu, bool nested) {
  SolverSettings settings = settings_of();
  settings.materials = {{1e4, first_nu}, {3e4, second_nu}};
  settings.nested = nested;
  settings.coarsest_nested = 0;
  return settings;
}

/// The stretch of a Neo-Hookean bar whose sides are held, under a stress at rest.
double held_stretch(double young, double nu, double stress) {
  const LameParameters lame = lame_parameters(young, nu, "test");
  double low = 0.5, high = 2;
  for (int k = 0; k < 200; ++k) {
    const double s = (low + high) / 2;
    (lame.mu * (s - 1 / s) + lame.lambda * std::log(s) / s < stress ? low : high) = s;
  }
  return low;
}

TEST(Materials, in_series_stretch_as_each_does_for_itself) {
  // Sides are held, so that each material has one stretch, though Poisson's ratios differ.
  for (const auto& [patches, refinements] : {std::pair{false, 0}, std::pair{true, 0}, std::pair{true, 1}}) {
    HalvedBar bar(2, patches, refinements);
    constexpr double pull = 4000;
    LoadCase load_case{{{"z0"}}, {}, {{"z1", {0, 0, pull}}}, {}, {}, 0};
    for (const char* side : {"x0", "x1"}) load_case.supports.push_back({side, {.x = 0.0}});
    for (const char* side : {"y0", "y1"}) load_case.supports.push_back({side, {.y = 0.0}});
    const Loading loading = apply_load_case(load_case, bar.levels, bar.groups);
    const auto solver = make_solver(bar.levels, loading, two_materials(0.2, 0.4, refinements > 0));
    ASSERT_EQ(solver->solve_to(1, {}).status, NewtonStatus::converged);
    const double first = held_stretch(1e4, 0.2, pull), second = held_stretch(3e4, 0.4, pull), half = size[2] / 2;
    EXPECT_GT(first, second + 0.1);
    const auto positions = solver->positions();
    for (std::size_t n = 0; n < positions.size(); ++n) {
      const Point& x = bar.levels[0].rest[n];
      const double z = x[2] <= half ? first * x[2] : first * half + second * (x[2] - half);
      EXPECT_NEAR(positions[n][0], x[0], 1e-9);
      EXPECT_NEAR(positions[n][2], z, 1e-8) << patches << refinements << " node " << n;
    }
    const Point held = reaction_of(group_named(bar.groups[0], "z0").nodes, bar.levels[0], solver->forces());
    EXPECT_NEAR(held[2], -pull * size[0] * size[1], 1e-7);
    // Stresses of both, along z.
    for (const auto& stress : solver->stresses()) EXPECT_NEAR(stress[8], pull, 1e-4);
  }
}

TEST(Materials, in_parallel_share_the_force_as_their_stiffness_says) {
  for (const auto& [patches, refinements] : {std::pair{false, 0}, std::pair{true, 1}}) {
    HalvedBar bar(0, patches, refinements);
    constexpr double stretch = 1.3, nu = 0.3;
    const LoadCase load_case{
        {{"x0", {.x = 0.0}}, {"y0", {.y = 0.0}}, {"z0", {.z = 0.0}}, {"z1", {.z = (stretch - 1) * size[2]}}},
        {},
        {},
        {},
        {},
        0};
    const Loading loading = apply_load_case(load_case, bar.levels, bar.groups);
    const auto solver = make_solver(bar.levels, loading, two_materials(nu, nu, refinements > 0));
    ASSERT_EQ(solver->solve_to(1, {}).status, NewtonStatus::converged);
    // mu (w - 1/w) + lambda ln(w^2 s) / w = 0 across; the stress along z is that of the stretch s.
    const auto stress_of = [&](double young, double* across) {
      const LameParameters lame = lame_parameters(young, nu, "test");
      double low = 0.5, high = 1;
      for (int k = 0; k < 200; ++k) {
        const double w = (low + high) / 2;
        (lame.mu * (w - 1 / w) + lame.lambda * std::log(w * w * stretch) / w < 0 ? low : high) = w;
      }
      *across = low;
      return lame.mu * (stretch - 1 / stretch) + lame.lambda * std::log(low * low * stretch) / stretch;
    };
    double across = 0, same = 0;
    const double area = size[0] * size[1] / 2, force = area * (stress_of(1e4, &across) + stress_of(3e4, &same));
    EXPECT_NEAR(across, same, 1e-12);
    const auto positions = solver->positions();
    for (std::size_t n = 0; n < positions.size(); ++n) {
      const Point& x = bar.levels[0].rest[n];
      const Point expected{across * x[0], across * x[1], stretch * x[2]};
      for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(positions[n][k], expected[k], 1e-8) << patches << n;
    }
    for (const auto& [group, sign] : {std::pair{"z1", 1}, std::pair{"z0", -1}}) {
      const Point held = reaction_of(group_named(bar.groups[0], group).nodes, bar.levels[0], solver->forces());
      EXPECT_NEAR(held[2], sign * force, 1e-7 * force);
    }
  }
}

TEST(Materials, that_are_alike_give_what_one_gives) {
  HalvedBar one(1, true, 0), two(1, true, 0);
  one.levels[0].material_ends.clear();
  const LoadCase load_case{{{"z0"}}, {{"z1", {1, 2, -3}}}, {}, {}, {}, 0};
  SolverSettings settings = settings_of(0.45);
  const auto first = make_solver(one.levels, apply_load_case(load_case, one.levels, one.groups), settings);
  settings.materials = {{settings.youngs_modulus, 0.45}, {settings.youngs_modulus, 0.45}};
  const auto second = make_solver(two.levels, apply_load_case(load_case, two.levels, two.groups), settings);
  ASSERT_EQ(first->solve_to(1, {}).status, NewtonStatus::converged);
  ASSERT_EQ(second->solve_to(1, {}).status, NewtonStatus::converged);
  EXPECT_LT(largest_distance(first->positions(), second->positions()), 1e-9);
  EXPECT_EQ(first->bytes(), second->bytes() + first->bytes() - second->bytes());
}

TEST(Materials, that_do_not_fit_the_mesh_or_the_solver_are_refused) {
  const auto refusal = [](const auto& change, bool patches = true) {
    HalvedBar bar(0, patches, 0);
    SolverSettings settings = two_materials(0.3, 0.3, false);
    const Loading loading = apply_load_case({{{"z0"}}, {}, {}, {}, {}, 0}, bar.levels, bar.groups);
    try {
      change(bar.levels[0], settings);
      static_cast<void>(make_solver(bar.levels, loading, settings));
    } catch (const Error& error) {
      return std::string(error.what()).substr(std::string("physgen: ").size());
    }
    return std::string("accepted");
  };
  EXPECT_EQ(refusal([](MeshLevel&, SolverSettings&) {}), "accepted");
  EXPECT_EQ(refusal([](MeshLevel&, SolverSettings& s) { s.materials.pop_back(); }),
            "level 0: its tets have 2 materials, and the settings have 1; give the same number");
  EXPECT_EQ(refusal([](MeshLevel& level, SolverSettings&) { --level.material_ends.back(); }, false),
            "level 0: the ends of materials among its 96 tets must ascend to that number");
  EXPECT_EQ(refusal([](MeshLevel& level, SolverSettings&) { level.averages_at_nodes = true; }, false),
            "level 0: volumes averaged at nodes would mix the materials around a node; average them over patches");
  EXPECT_EQ(refusal([](MeshLevel&, SolverSettings& s) { s.newton.product = Product::matrix_free; }),
            "several materials require the assembled product; take it, or give the body one material");
  EXPECT_TRUE(refusal([](MeshLevel& level, SolverSettings&) {
                level.patches = greedy_patches(level.mesh);
              }).ends_with("and one of another material; make patches by greedy_patches(mesh, material_ends)"));
  EXPECT_TRUE(refusal([](MeshLevel&, SolverSettings& s) {
                s.materials[1].poissons_ratio = 0.5;
              }).starts_with("Neo-Hookean: Poisson's ratio nu = 0.5 is out of range"));
}

TEST(Materials, of_groups_that_overlap_or_have_no_tets_are_refused_with_their_names) {
  const auto refusal = [](const std::vector<std::string>& groups) {
    ReadMesh mesh = halved_bar(0);
    MeshGroup one;
    one.name = "one";
    one.tets = {mesh.groups[0].tets[3]};
    mesh.groups.push_back(one);
    mesh.groups.emplace_back().name = "none";
    try {
      static_cast<void>(sort_by_material(mesh, groups));
    } catch (const Error& error) {
      return std::string(error.what()).substr(std::string("physgen: ").size());
    }
    return std::string("accepted");
  };
  EXPECT_EQ(refusal({"beyond"}), "accepted");
  EXPECT_EQ(refusal({"none"}), "group 'none' has no tets, and a material needs them; take a group of a volume");
  const ReadMesh mesh = halved_bar(0);
  EXPECT_EQ(refusal({"beyond", "one"}),
            "element " + std::to_string(100 + mesh.groups[0].tets[3]) +
                " is in the groups 'beyond' and 'one', which have materials; give each tet one");
  EXPECT_TRUE(refusal({"beyont"}).starts_with("the mesh has no group 'beyont'; did you mean 'beyond'?"));
}

}  // namespace
}  // namespace physgen::fem
