// The list of the kernels whose error is measured beside their speed, in the order in which they run and are printed.
#pragma once

#include <vector>

#include "../kernel_list.h"

namespace physgen::fem {
struct Unfiltered;
struct ClampEigenvalues;
struct AbsoluteEigenvalues;
}  // namespace physgen::fem

namespace physgen::bench {

class InputSets;
template <int kSweeps>
struct SvdVariant;
struct SvdQuaternions;
struct SingularValues;
struct PolarRotation;
struct SvdWithoutU;
struct SvdWithoutV;
template <class Filter, class KernelFilter>
struct StressDerivativeVariant;
struct DpFromDfVariant;
namespace filter {
struct None;
struct Clamp;
struct Absolute;
}  // namespace filter

using PlainStressDerivative = StressDerivativeVariant<filter::None, fem::Unfiltered>;
using ClampedStressDerivative = StressDerivativeVariant<filter::Clamp, fem::ClampEigenvalues>;
using AbsoluteStressDerivative = StressDerivativeVariant<filter::Absolute, fem::AbsoluteEigenvalues>;

using AllVariants = KernelList<SvdVariant<4>, SvdVariant<3>, SvdVariant<5>, SvdQuaternions, SvdWithoutU, SvdWithoutV,
                               SingularValues, PolarRotation, PlainStressDerivative, ClampedStressDerivative,
                               AbsoluteStressDerivative, DpFromDfVariant>;

}  // namespace physgen::bench
