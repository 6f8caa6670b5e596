// Formats of a program's own for the objects of golden/everything.physgen.h, and the errors that each format is stated
// to have.
#pragma once

#include <gtest/gtest.h>
#include <physgen/runtime.h>
#include <physgen/simd/simd_access.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>

#include "everything.physgen.h"

namespace physgen::test {

using tissue::model::Frame;
using tissue::model::FrameFormats;
using tissue::model::FrameObject;
using tissue::model::Stored;
using tissue::model::StoredArray;
using tissue::model::StoredFormats;
using tissue::model::StoredObject;

// ---- Formats of a program's own -------------------------------------------------------------------------------------

struct PlainFrame : FrameFormats<Host> {
  using turn = format::Native;
  using weight = format::Native;
};
/// Everything as it is computed: what is stored in it is the value itself.
struct Plain : StoredFormats<Host> {
  using single = format::Native;
  using twice = format::Native;
  using narrowed = format::Native;
  using plain_half = format::Native;
  using load = format::Native;
  using wide = format::Native;
  using angle = format::Native;
  using stress = format::Native;
  using stretch = format::Native;
  using spin = format::Native;
  using R32 = format::Native;
  using R64 = format::Native;
  using Rhalf = format::Native;
  using Rbfloat = format::Native;
  using R16 = format::Native;
  using entries = format::Native;
  using halves = format::Native;
  using turns = format::Native;
  using many = format::Native;
  using frame = PlainFrame;
  using frames = PlainFrame;
};

struct CompactFrame : FrameFormats<Cuda> {
  using turn = format::Quaternion<format::Bfloat16>;
};
/// Some fields anew, of nested objects too; the others as the schema says for the host.
struct Compact : StoredFormats<Host> {
  using F = format::Bfloat16;
  using R = format::Quaternion16;
  using stress = format::Native;
  using frame = CompactFrame;
};

// ---- The errors that comments state ---------------------------------------------------------------------------------

struct Error {
  double relative = 0, absolute = 0;
};
constexpr Error exact{}, float32{6e-8, 0}, bfloat16{3.9e-3, 0};
constexpr Error half(double scale) {
  return {4.9e-4, 6.104e-5 * 4.9e-4 * scale};
}  // absolute below 6.1e-5 of the scale
constexpr Error steps(double low, double high) { return {0, (high - low) / 131068 * 1.0001}; }
constexpr Error quaternion16{0, 9e-5}, quaternion_half{0, 2e-3}, quaternion_bfloat16{0, 1.6e-2};
template <class Real>
constexpr double eps = std::numeric_limits<Real>::epsilon();
template <class Real>
constexpr Error quaternion{0, 10 * eps<Real>};

template <class Real>
struct FrameErrors {
  Error turn, origin, weight = steps(0, 1);
};
template <class Real>
struct Errors {
  Error temperature, stress, F, R, entries;
  FrameErrors<Real> frame, frames;
};

template <class Real, class Formats>
constexpr Errors<Real> errors() {
  constexpr FrameErrors<Real> host_frame{quaternion<Real>, exact}, cuda_frame{quaternion16, half(1)};
  if (std::is_same_v<Formats, StoredFormats<Cuda>>) {
    return {steps(273, 373), bfloat16, half(1), quaternion<Real>, steps(-1, 1), cuda_frame, cuda_frame};
  }
  if (std::is_same_v<Formats, Compact>) {
    return {exact, exact, bfloat16, quaternion16, half(1), {quaternion_bfloat16, half(1)}, host_frame};
  }
  return {exact, half(512), exact, exact, half(1), host_frame, host_frame};
}

/// `read` may differ by the error, and by rounding to the precision computed in.
template <std::floating_point Real>
void expect_within(Error error, Real read, Real written, const char* name) {
  const bool is_exact = error.relative == 0 && error.absolute == 0;
  const double size = std::abs(static_cast<double>(written));
  const double allowed = is_exact ? 0 : error.relative * size + error.absolute + 2 * eps<Real> * size;
  EXPECT_LE(std::abs(static_cast<double>(read) - static_cast<double>(written)), allowed) << name << " = " << written;
}
template <class A, class B>
void expect_within(Error error, const Eigen::MatrixBase<A>& read, const Eigen::MatrixBase<B>& written,
                   const char* name) {
  for (int c = 0; c < written.cols(); ++c) {
    for (int r = 0; r < written.rows(); ++r) expect_within(error, read(r, c), written(r, c), name);
  }
}

template <class Real>
void expect_within(const FrameErrors<Real>& errors, const Frame<Real>& read, const Frame<Real>& written) {
  expect_within(errors.turn, read.turn, written.turn, "turn");
  expect_within(errors.origin, read.origin, written.origin, "origin");
  expect_within(errors.weight, read.weight, written.weight, "weight");
}

template <class Formats, class Real>
void expect_within(const Stored<Real>& read, const Stored<Real>& written) {
  constexpr Errors<Real> stated = errors<Real, Formats>();
  expect_within(float32, read.single, written.single, "single");
  expect_within(exact, read.twice, written.twice, "twice");
  expect_within(float32, read.narrowed, written.narrowed, "narrowed");
  expect_within(half(1), read.plain_half, written.plain_half, "plain_half");
  expect_within(half(32), read.load, written.load, "load");
  expect_within(bfloat16, read.wide, written.wide, "wide");
  expect_within(steps(-3.25, 3.25), read.angle, written.angle, "angle");
  expect_within(stated.temperature, read.temperature, written.temperature, "temperature");
  expect_within(stated.stress, read.stress, written.stress, "stress");
  expect_within(stated.F, read.F, written.F, "F");
  expect_within(half(1), read.stretch, written.stretch, "stretch");
  expect_within(steps(-8, 8), read.spin, written.spin, "spin");
  expect_within(stated.R, read.R, written.R, "R");
  expect_within({0, 1.2e-6}, read.R32, written.R32, "R32");
  expect_within(quaternion<Real>, read.R64, written.R64, "R64");
  expect_within(quaternion_half, read.Rhalf, written.Rhalf, "Rhalf");
  expect_within(quaternion_bfloat16, read.Rbfloat, written.Rbfloat, "Rbfloat");
  expect_within(quaternion16, read.R16, written.R16, "R16");
  expect_within(stated.entries, read.entries, written.entries, "entries");
  for (int e = 0; e < 5; ++e) expect_within(half(1), read.halves[e], written.halves[e], "halves");
  for (int e = 0; e < 3; ++e) expect_within(quaternion_half, read.turns[e], written.turns[e], "turns");
  for (int e = 0; e < 33; ++e) expect_within(quaternion16, read.many[e], written.many[e], "many");
  EXPECT_EQ(read.count, written.count);
  expect_within(stated.frame, read.frame, written.frame);
  for (int e = 0; e < 2; ++e) expect_within(stated.frames, read.frames[e], written.frames[e]);
}

// ---- Random values --------------------------------------------------------------------------------------------------

class Random {
 public:
  explicit Random(unsigned seed) : random_(seed) {}

  double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  template <class Real>
  Eigen::Matrix<Real, 3, 3> rotation() {
    std::normal_distribution<double> normal;
    const Eigen::Quaterniond q(normal(random_), normal(random_), normal(random_), normal(random_));
    return q.normalized().toRotationMatrix().cast<Real>();
  }
  template <class Matrix>
  Matrix matrix(double low, double high) {
    return Matrix::NullaryExpr([&] { return static_cast<typename Matrix::Scalar>(between(low, high)); });
  }
  template <class Real>
  Frame<Real> frame() {
    return {rotation<Real>(), matrix<Eigen::Matrix<Real, 3, 1>>(-2, 2), static_cast<Real>(between(0, 1))};
  }
  template <class Real>
  Stored<Real> stored() {
    using Matrix = Eigen::Matrix<Real, 3, 3>;
    Stored<Real> value;
    value.single = static_cast<Real>(between(-1e9, 1e9));
    value.twice = static_cast<Real>(between(-1e9, 1e9));
    value.narrowed = between(-1, 1);
    value.plain_half = static_cast<Real>(between(-65504, 65504));
    value.load = static_cast<Real>(between(0, 1e6));
    value.wide = static_cast<Real>(std::pow(10.0, between(-30, 30)));
    value.angle = static_cast<Real>(between(-3.25, 3.25));
    value.temperature = static_cast<Real>(between(273, 373));
    value.stress = matrix<Matrix>(-1e7, 1e7).template selfadjointView<Eigen::Lower>();
    value.F = matrix<Matrix>(-3, 3);
    value.stretch = matrix<Eigen::Matrix<Real, 3, 1>>(-2, 4);
    const Matrix any = matrix<Matrix>(-4, 4);
    value.spin = any - any.transpose();
    for (auto* R : {&value.R, &value.R32, &value.R64, &value.Rhalf, &value.Rbfloat, &value.R16, &value.entries}) {
      *R = rotation<Real>();
    }
    for (Real& entry : value.halves) entry = static_cast<Real>(between(-100, 100));
    for (auto& entry : value.turns) entry = rotation<Real>();
    for (auto& entry : value.many) entry = rotation<Real>();
    value.count = static_cast<std::int32_t>(random_());
    value.frame = frame<Real>();
    for (Frame<Real>& entry : value.frames) entry = frame<Real>();
    return value;
  }

 private:
  std::mt19937 random_;
};

}  // namespace physgen::test
