// Nodes gathered on the GPU.
#include "groups/gathers.h"
#include "measure/cuda_rows.h"

namespace physgen::bench {

namespace {

[[maybe_unused]] const bool rows =
    add(Part{"gathers", 0, "gather_nodes", "cuda", [](std::vector<Row>& rows, const Sizes& sizes) {
               add_gather_rows<CudaKernels, Aos>(rows, sizes.cuda, "aos");
               add_gather_rows<CudaKernels, AosPadded>(rows, sizes.cuda, "aos_padded");
               add_gather_rows<CudaKernels, Soa>(rows, sizes.cuda, "soa");
               add_gather_rows<CudaKernels, Aosoa<32>>(rows, sizes.cuda, "aosoa32");
             }});

}  // namespace

}  // namespace physgen::bench
