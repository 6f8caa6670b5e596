// Formats that prune some fields of the tests' objects, of every shape, and names for them.
#pragma once

#include <elasticity.physgen.h>
#include <everything.physgen.h>

#include "own_formats.h"

namespace physgen::test {

struct TestScene;
struct TestArray;
namespace field {
struct U;
struct V;
struct s;
struct x1111;
struct x2222;
struct x3232;
struct weights;
struct history;
struct density;
struct nu;
struct spin;
struct metric;
struct fixed;
struct mu;
struct lambda;
struct direction;
struct time;
struct a;
struct F;
struct C2;
struct W;
struct volume;
struct nodes;
struct flags;
struct element;
struct local;
struct flag;
struct label;
struct weight;
}  // namespace field
template <class Field>
using Gone = format::Pruned<TestScene, TestArray, Field>;

/// The fields of an SVD that an explicit step of an elastic body keeps.
struct StretchesOnly : elasticity::DeformationSvdFormats<Host> {
  using U = Gone<field::U>;
  using V = Gone<field::V>;
};
struct NoSvd : StretchesOnly {
  using s = Gone<field::s>;
};
/// Without saying that this is meant.
struct LostStretches : elasticity::DeformationSvdFormats<Host> {
  using s = format::Nothing;
};
/// A pruned field beside quaternions, of which there are fewer than code sees.
struct RightOnly : elasticity::DeformationSvdFormats<Host> {
  using U = Gone<field::U>;
  using V = format::Quaternion<>;
};
/// Elements of 0, 2, 4 and 8 bytes.
struct PartOfDerivative : elasticity::StressDerivativeFormats<Host> {
  using x1111 = Gone<field::x1111>;
  using x3311 = format::Float64;
  using x2222 = Gone<field::x2222>;
  using x3322 = format::Half<>;
  using x3232 = Gone<field::x3232>;
};
/// PartOfDerivative, and what it prunes in any format.
struct FullDerivative : elasticity::StressDerivativeFormats<Host> {
  using x3311 = format::Float64;
  using x2222 = format::Snorm16<format::Interval{0, 4}>;
  using x3322 = format::Half<>;
};

/// Fixed arrays, one of them of indices.
struct PartOfEntries : tissue::model::EntriesFormats<Host> {
  using flags = Gone<field::flags>;
  using weights = Gone<field::weights>;
  using history = Gone<field::history>;
};
/// The only field, of indices.
struct NoNodes : elasticity::TetFormats<Host> {
  using nodes = Gone<field::nodes>;
};
/// Formats of a program's own, of a field that is pruned and beside it.
struct OwnOfPart : elasticity::StressDerivativeFormats<Host> {
  using x1111 = Gone<field::x1111>;
  using x2211 = Thousandths;
};
struct OwnOfAll : elasticity::StressDerivativeFormats<Host> {
  using x1111 = Thousandths;
  using x2211 = Thousandths;
};
/// Entries of rows that name nothing, and some that name elements alone.
struct NoElement : elasticity::IncidenceFormats<Host> {
  using element = Gone<field::element>;
};
struct ElementOnly : elasticity::IncidenceFormats<Host> {
  using local = Gone<field::local>;
};
/// Initial values.
struct PartOfOptions : tissue::model::OptionsFormats<Host> {
  using density = Gone<field::density>;
  using metric = Gone<field::metric>;
  using label = Gone<field::label>;
  using fixed = Gone<field::fixed>;
};
struct IndicesOfOptions : PartOfOptions {
  using nu = Gone<field::nu>;
  using direction = Gone<field::direction>;
  using spin = Gone<field::spin>;
  using label = format::Native;
};
struct NoLame : material::LameFormats<Host> {
  using mu = Gone<field::mu>;
  using lambda = Gone<field::lambda>;
};
struct PartOfFibre : material::FibreFormats<Host> {
  using direction = Gone<field::direction>;
};
struct PartOfStamp : tissue::StampFormats<Host> {
  using time = Gone<field::time>;
};
struct PartOfShapes : tissue::model::ShapesFormats<Host> {
  using a = Gone<field::a>;
  using nodes = Gone<field::nodes>;
  using F = Gone<field::F>;
  using C2 = Gone<field::C2>;
  using s = Gone<field::s>;
  using W = Gone<field::W>;
  using U = Gone<field::U>;
};
/// Nested objects, one of them without any bytes.
struct PartOfElement : tissue::model::ElementFormats<Host> {
  using flag = Gone<field::flag>;
  using lame = NoLame;
  using fibres = PartOfFibre;
  using stamp = PartOfStamp;
  using shapes = PartOfShapes;
  using volume = Gone<field::volume>;
};
struct PartOfPatch : tissue::other::PatchFormats<Host> {
  using elements = PartOfElement;
  using weight = Gone<field::weight>;
  using options = PartOfOptions;
};

}  // namespace physgen::test
