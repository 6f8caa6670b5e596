// The product with the assembled stiffness from its symmetric half.
#pragma once

#include <fem/kernels/symmetric_product.h>

#include <memory>

#include "kernels/force_differential.h"
#include "measure/kernel_case.h"
#include "measure/registry.h"
#include "measure/scene_data.h"

namespace physgen::bench {

struct SymmetricForceDifferential {
  static constexpr const char* name = AddForceDifferential::name;
  static constexpr Domain domain = Domain::nodes;
  using CheckedAs = AddForceDifferential;
  using Reads = Operands<Tiled<OutputOf<NodeStiffness>>, Tiled<OutputOf<EdgeStiffness>>, Tiled<source::Edges>,
                         Gathered<source::Displacements>>;
  using Writes = AddForceDifferential::Writes;
  template <class Real, class... View>
  static auto run(const View&... view) {
    return fem::SymmetricProduct{view...};
  }
  /// Where the order of sums is fixed, from lists that are no part of the product.
  static void perform(const auto& product) { multiply(Host{}, product, fem::EdgeSums(), fem::SumOrder::fixed); }
};

/// On the GPU, the mesh on which products are compared has 1,030,301 nodes.
inline Sizes sizes_of_forces(Sizes sizes) {
  if (!sizes.given) sizes.cuda = 6000000;
  return sizes;
}

/// @param multiply multiply(product, sums) runs it
template <class Device, class Real, class Multiply>
void add_symmetric_row(std::vector<Row>& rows, index_t tets, const char* layout, const Multiply& multiply) {
  using Provider = OnScene<SymmetricForceDifferential, Real>;
  const Provider provider(scene_of(tets));
  Adder<Device, Provider>(rows, provider).add(layout, [provider, multiply] {
    const auto sums =
        std::make_shared<fem::EdgeSums>(provider.scene()->cube().mesh, Device::Space::kind, int{sizeof(Real)});
    return kernel_case<Device, Aos>(
        provider, [sums, multiply](index_t /*objects*/, const auto& product) { multiply(product, *sums); });
  });
}

}  // namespace physgen::bench
