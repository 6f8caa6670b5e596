// Packs without the header that they need: a compiler must refuse them, and name the header. refused.py compares what
// it reports.
#include <elasticity.physgen.h>
#include <physgen/kernels/lanes.h>
#include <physgen/kernels/math.h>
#include <physgen/rows.h>

using namespace physgen;

namespace {
using Derivatives = elasticity::StressDerivativeArray<float>;
/// Stands for a batch of a SIMD library.
struct Batch {};
}  // namespace

/// refused a_pack_of_an_array: SIMD access on the CPU needs <physgen/simd/simd_access.h>
void a_pack_of_an_array(const Derivatives::View& view) { (void)view[Pack<8>{0}]; }
/// refused the_lanes_of_a_pack: SIMD access on the CPU needs <physgen/simd/simd_access.h>
using the_lanes_of_a_pack = lanes_t<float, PartialPack<8>>;
/// refused a_root_of_a_pack: include <physgen/simd/simd.h> for packs
using a_root_of_a_pack = math::ScalarTraits<Batch>::Real;

// ---- What is not refused ----
void accepted(const Derivatives::View& view) { (void)view[0].x1111(); }
