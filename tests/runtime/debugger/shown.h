// The text that gdb should show of objects, made of values that the library reads. It is written as gdb writes arrays
// and structs: {a = 1, v [m] = {1, 2, 3}}.
#pragma once

#include <everything.physgen.h>

#include <cstdio>
#include <string>

namespace physgen::test {

inline std::string shown(float number) {
  char text[32];
  std::snprintf(static_cast<char*>(text), sizeof text, "%.9g", static_cast<double>(number));
  return static_cast<const char*>(text);
}
inline std::string shown(double number) {
  char text[32];
  std::snprintf(static_cast<char*>(text), sizeof text, "%.17g", number);
  return static_cast<const char*>(text);
}
inline std::string shown(std::int32_t number) { return std::to_string(number); }
inline std::string shown(std::int64_t number) { return std::to_string(number); }
inline std::string shown(std::uint64_t number) { return std::to_string(number); }
inline std::string shown(bool flag) { return flag ? "true" : "false"; }

/// {first, second, ...} of `count` parts, which part(k) gives.
template <class Part>
std::string listed(Eigen::Index count, const Part& part) {
  std::string text = "{";
  for (Eigen::Index k = 0; k < count; ++k) text += (k > 0 ? ", " : "") + part(k);
  return text + "}";
}
template <class Derived>
std::string shown(const Eigen::MatrixBase<Derived>& matrix) {
  const auto entry = [&](Eigen::Index r, Eigen::Index c) { return shown(matrix.derived().coeff(r, c)); };
  if (matrix.cols() == 1) return listed(matrix.rows(), [&](Eigen::Index r) { return entry(r, 0); });
  return listed(matrix.rows(),
                [&](Eigen::Index r) { return listed(matrix.cols(), [&](Eigen::Index c) { return entry(r, c); }); });
}
template <class T, std::size_t N>
std::string shown(const T (&entries)[N]) {
  return listed(Eigen::Index{N}, [&](Eigen::Index k) { return shown(entries[k]); });
}

/// "name = value, name = value" of the members of values.
class Members {
 public:
  template <class Value>
  Members& add(const char* name, const Value& value) {
    text_ += (text_.empty() ? "" : ", ") + std::string(name) + " = " + shown(value);
    return *this;
  }
  [[nodiscard]] std::string text() const { return "{" + text_ + "}"; }

 private:
  std::string text_;
};

template <class Real>
std::string shown(const tissue::model::Shapes<Real>& x) {
  return Members()
      .add("a", x.a)
      .add("v", x.v)
      .add("nodes", x.nodes)
      .add("F [1]", x.F)
      .add("B", x.B)
      .add("row", x.row)
      .add("K [N/m]", x.K)
      .add("C2", x.C2)
      .add("s", x.s)
      .add("W [1/s]", x.W)
      .add("U", x.U)
      .add("V", x.V)
      .add("count", x.count)
      .add("M", x.M)
      .text();
}
template <class Real>
std::string shown(const tissue::model::Stored<Real>& x) {
  return Members()
      .add("single", x.single)
      .add("twice", x.twice)
      .add("narrowed", x.narrowed)
      .add("plain_half", x.plain_half)
      .add("load [N]", x.load)
      .add("wide", x.wide)
      .add("angle [rad]", x.angle)
      .add("temperature [K]", x.temperature)
      .add("stress [Pa]", x.stress)
      .add("F", x.F)
      .add("stretch", x.stretch)
      .add("spin", x.spin)
      .add("R", x.R)
      .add("R32", x.R32)
      .add("R64", x.R64)
      .add("Rhalf", x.Rhalf)
      .add("Rbfloat", x.Rbfloat)
      .add("R16", x.R16)
      .add("entries", x.entries)
      .add("halves", x.halves)
      .add("turns", x.turns)
      .add("many", x.many)
      .add("count", x.count)
      .add("frame.turn", x.frame.turn)
      .add("frame.origin [m]", x.frame.origin)
      .add("frame.weight", x.frame.weight)
      .add("frames[0].turn", x.frames[0].turn)
      .add("frames[0].origin [m]", x.frames[0].origin)
      .add("frames[0].weight", x.frames[0].weight)
      .add("frames[1].turn", x.frames[1].turn)
      .add("frames[1].origin [m]", x.frames[1].origin)
      .add("frames[1].weight", x.frames[1].weight)
      .text();
}

template <class Real>
std::string shown(const tissue::model::Marks<Real>& x) {
  return Members()
      .add("lowest", x.lowest)
      .add("key", x.key)
      .add("alive", x.alive)
      .add("fixed", x.fixed)
      .add("counts", x.counts)
      .add("touches", x.touches)
      .add("hashes", x.hashes)
      .add("turns", x.turns)
      .add("flags", x.flags)
      .add("history", x.history)
      .add("weight [kg]", x.weight)
      .text();
}

/// Prints what gdb should show of an expression.
template <class Value>
void expect(const std::string& expression, const Value& value) {
  std::printf("expected %s = %s\n", expression.c_str(), shown(value).c_str());
}
template <class Array>
void expect(const std::string& name, Array& array, index_t i) {
  expect(name + "[" + std::to_string(i) + "]", array.view().get(i));
}

}  // namespace physgen::test
