// Faces of meshes from files are flat but for rounding, and so are angles between them right.
#include <fem/mesh/geometry.h>
#include <fem/solver/number_text.h>
#include <fem/solver/rigid_motions.h>
#include <fem/solver/support_axes.h>
#include <physgen/error.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace physgen::fem {

namespace {

constexpr double same = 1e-5;  // of directions, the sine of the angle between them
constexpr double flat = 1e-3;  // of faces, the angle between a normal and the mean

double length(const Point& a) { return std::hypot(a[0], a[1], a[2]); }
Point scaled(const Point& a, double factor) { return {factor * a[0], factor * a[1], factor * a[2]}; }
/// a less its part along b. @pre b has the length 1
Point across(const Point& a, const Point& b) { return difference(a, scaled(b, dot(a, b))); }

std::string text_of(const Point& a) {
  return "(" + number_text(a[0]) + ", " + number_text(a[1]) + ", " + number_text(a[2]) + ")";
}

/// The direction of a vector; exactly that of x, y or z where it is one but for rounding.
Point direction_of(const std::string& whose, const Point& a) {
  const double most = std::max({std::abs(a[0]), std::abs(a[1]), std::abs(a[2])});
  if (!(most > 0) || !std::isfinite(a[0] + a[1] + a[2])) {
    throw Error("the axis of group '" + whose + "' is " + text_of(a) +
                " and must be a direction: three finite numbers, not all of them 0");
  }
  const Point x = scaled(a, 1 / most);
  const Point unit = scaled(x, 1 / length(x));
  for (const Point& e : coordinate_axes) {
    if (length(across(unit, e)) < 1e-12) return scaled(e, dot(unit, e) < 0 ? -1 : 1);
  }
  return unit;
}

Point normal_of(const MeshLevel& level, const MeshGroup& group) {
  if (group.faces.empty()) {
    throw Error("group '" + group.name + "' has no faces, and the axis \"normal\" is theirs; take a group of a " +
                "surface, or write the axis as three numbers");
  }
  const std::vector<Face> faces = outward_faces(level.mesh, level.rest, group);
  const auto normal = [&](const Face& face) {
    const auto x = [&](std::size_t k) -> const Point& { return level.rest[static_cast<std::size_t>(face[k])]; };
    return cross(difference(x(1), x(0)), difference(x(2), x(0)));
  };
  Point mean{};
  for (const Face& face : faces) {
    const Point n = normal(face);
    for (std::size_t k = 0; k < 3; ++k) mean[k] += n[k];
  }
  double most = 0;
  const double size = length(mean);
  for (const Face& face : faces) {
    const Point n = normal(face);
    const double cosine = size > 0 ? dot(n, mean) / (length(n) * size) : -1;
    const double sine = size > 0 ? length(across(n, scaled(mean, 1 / size))) / length(n) : 1;
    most = std::max(most, std::atan2(sine, cosine));
  }
  if (most > flat) {
    throw Error(
        "the faces of group '" + group.name + "' are not flat: normals are up to " +
        number_text(most * 180 / std::numbers::pi) +
        " degrees from their mean, and the axis \"normal\" is one direction; split the group into flat ones, or "
        "write the axis as three numbers");
  }
  return direction_of(group.name, mean);
}

/// Whether what is prescribed in a direction that others span is what follows from them.
void require_agreement(const NodeComponents& node, const NodeComponents::Component& more,
                       std::span<const SupportComponents> supports, const Point& rest) {
  const auto curve = [&](const NodeComponents::Component& c) { return supports[c.support].curve; };
  const auto all = node.all();
  const NodeComponents::Component* other = &all.front();
  double largest = std::abs(more.prescribed.displacement), most = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const double part = std::abs(dot(more.prescribed.direction, node.dual(i)));
    largest = std::max(largest, std::abs(all[i].prescribed.displacement));
    if (part > most) most = part, other = &all[i];
  }
  const auto differs = [&](std::size_t of) {
    double follows = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (curve(all[i]) == of) follows += dot(more.prescribed.direction, node.dual(i)) * all[i].prescribed.displacement;
    }
    return std::abs(follows - (curve(more) == of ? more.prescribed.displacement : 0)) > same * largest;
  };
  double follows = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    follows += dot(more.prescribed.direction, node.dual(i)) * all[i].prescribed.displacement;
  }
  const bool any = differs(curve(more)) || std::ranges::any_of(all, [&](const auto& c) { return differs(curve(c)); });
  if (!any) return;
  throw Error(
      "groups '" + supports[other->support].group + "' and '" + supports[more.support].group + "' share the node at " +
      text_of(rest) + " m at rest and prescribe different displacements along " + text_of(more.prescribed.direction) +
      " there, " + number_text(follows) + " and " + number_text(more.prescribed.displacement) + " m" +
      (curve(*other) == curve(more) ? "" : ", along other curves") + "; leave that component free in one of them");
}

}  // namespace

Point axis_of(const Support& support, const MeshLevel& level, const MeshGroup& group) {
  const SupportAxis axis = support.axis.value_or(SupportAxis());
  return axis.is_normal ? normal_of(level, group) : direction_of(support.group, axis.direction);
}

SupportComponents components_of(const Support& support, const MeshLevel& finest, const MeshGroup& group,
                                std::size_t curve) {
  SupportComponents result{support.group, {}, curve};
  if (support.axis) {
    result.components.push_back({axis_of(support, finest, group), support.axis->displacement});
    return result;
  }
  const auto& [x, y, z] = support.displacement;
  const std::array values{x, y, z};
  for (std::size_t k = 0; k < 3; ++k) {
    if (values[k]) result.components.push_back({coordinate_axes[k], *values[k]});
  }
  return result;
}

bool NodeComponents::take(const Component& more) {
  const Point& d = more.prescribed.direction;
  if (count_ == 3) return false;
  if (count_ == 1 && length(across(d, components_[0].prescribed.direction)) < same) return false;
  if (count_ == 2 && std::abs(dot(d, line())) < same) return false;
  components_[count_++] = more;
  return true;
}

Point NodeComponents::line() const {
  const Point& d = components_[0].prescribed.direction;
  if (count_ == 1) return d;
  const Point normal = cross(d, components_[1].prescribed.direction);
  return scaled(normal, 1 / length(normal));
}

std::array<Point, 3> NodeComponents::basis() const {
  std::array<Point, 3> d{components_[0].prescribed.direction, components_[1].prescribed.direction,
                         components_[2].prescribed.direction};
  if (count_ == 2) d[2] = line();
  return d;
}

Point NodeComponents::dual(std::size_t i) const {
  if (count_ == 1) return components_[0].prescribed.direction;
  const auto d = basis();
  const Point normal = cross(d[(i + 1) % 3], d[(i + 2) % 3]);
  return scaled(normal, 1 / dot(normal, d[i]));
}

std::vector<NodeComponents> components_of_nodes(std::span<const SupportComponents> supports,
                                                std::span<const std::span<const Index>> nodes,
                                                std::span<const Point> rest) {
  std::vector<NodeComponents> result(rest.size());
  for (std::size_t s = 0; s < supports.size(); ++s) {
    for (const Index n : nodes[s]) {
      NodeComponents& node = result[static_cast<std::size_t>(n)];
      for (const PrescribedComponent& component : supports[s].components) {
        const NodeComponents::Component more{component, s};
        if (!node.take(more)) require_agreement(node, more, supports, rest[static_cast<std::size_t>(n)]);
      }
    }
  }
  return result;
}

std::optional<std::array<Point, 3>> common_axes(std::span<const NodeComponents> nodes,
                                                std::span<const SupportComponents> supports) {
  struct Line {
    Point direction;
    std::string groups;
  };
  std::vector<Line> lines;
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    const auto all = nodes[n].all();
    if (all.empty() || all.size() == 3) continue;
    const Point line = nodes[n].line();
    const auto is_it = [&](const Line& known) { return length(across(line, known.direction)) < same; };
    if (std::ranges::any_of(lines, is_it)) continue;
    std::string groups = "group '" + supports[all[0].support].group + "'";
    if (all.size() == 2) groups += " with '" + supports[all[1].support].group + "'";
    for (const Line& known : lines) {
      const double cosine = std::abs(dot(line, known.direction));
      if (cosine < same) continue;
      const double degrees = std::acos(std::min(1.0, cosine)) * 180 / std::numbers::pi;
      throw Error(
          "supports of one body must have directions that are parallel or perpendicular to each other where they "
          "leave a node free to move: those of " +
          known.groups + ", " + text_of(known.direction) + ", and of " + groups + ", " + text_of(line) + ", are at " +
          number_text(std::round(1e4 * degrees) / 1e4) +
          " degrees; turn one of the axes, or fix all components of one group");
    }
    lines.push_back({line, groups});
  }
  std::vector<Point> found;
  const auto add = [&](Point x) {
    for (const Point& known : found) x = across(x, known);
    found.push_back(scaled(x, 1 / length(x)));
  };
  for (const Line& line : lines) add(line.direction);
  while (found.size() < 3) {
    const auto left = [&](Point e) {
      for (const Point& known : found) e = across(e, known);
      return length(e);
    };
    add(*std::ranges::max_element(coordinate_axes, {}, left));
  }
  std::array<Point, 3> axes{};
  for (std::size_t k = 0; k < 3; ++k) {  // each next to the coordinate axis of its number
    const auto most = std::ranges::max_element(found, {}, [&](const Point& x) { return std::abs(x[k]); });
    axes[k] = scaled(*most, (*most)[k] < 0 ? -1 : 1);
    found.erase(most);
  }
  if (axes == coordinate_axes) return std::nullopt;
  if (dot(cross(axes[0], axes[1]), axes[2]) < 0) axes[2] = scaled(axes[2], -1);
  return axes;
}

std::uint8_t fixed_along(const std::array<Point, 3>& axes, const NodeComponents& node) {
  const std::size_t count = node.all().size();
  if (count == 0 || count == 3) return count == 0 ? 0 : 7;
  unsigned bits = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const bool along = std::abs(dot(node.line(), axes[k])) > 0.5;  // the others are perpendicular
    if (along == (count == 1)) bits |= 1U << k;
  }
  return static_cast<std::uint8_t>(bits);
}

}  // namespace physgen::fem
