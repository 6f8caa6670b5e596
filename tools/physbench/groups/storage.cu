// dP from dF on the GPU in every storage scheme, and over records of whole elements.
#include "groups/schemes.h"
#include "measure/cuda_rows.h"

namespace physgen::bench {

namespace {

Case record_case(const OnScene<DpFromDf, float>& provider) {
  struct State {
    OnScene<DpFromDf, float> provider;
    elasticity::ElementRecordArray<float, Cuda> elements;
  };
  const index_t n = provider.objects();
  const auto state = std::make_shared<State>(State{provider, elasticity::ElementRecordArray<float, Cuda>(n)});
  elasticity::ElementRecordArray<float> loaded(n);
  load_records(*provider.scene(), loaded);
  physgen::copy(state->elements, loaded);
  Case made;
  made.bytes = provider.bytes();
  made.run = [state, n] {
    const auto view = state->elements.view();
    const fem::ComputeStressDifferential kernel{view, view, view, view};
    return CudaDevice::time([&] { parallel_for(Cuda{}, n, kernel); });
  };
  made.copy = CudaDevice::copy(made.bytes);
  made.check = [state, n, run = made.run] {
    run();
    elasticity::ElementRecordArray<float> records(n);
    physgen::copy(records, state->elements);
    synchronize();
    auto results = make_arrays<HostArrays<DpFromDf::Writes, float>>([n](std::size_t /*k*/) { return n; });
    for (index_t i = 0; i < n; ++i) std::get<0>(results).view()[i].dP() = records.view()[i].dP().get();
    return state->provider.check(results);
  };
  return made;
}

void add_rows(std::vector<Row>& rows, const Sizes& sizes) {
  const OnScene<DpFromDf, float> provider(scene_of(sizes.cuda));
  const std::size_t before = rows.size();
  const auto usual = rows_of_kernel("dp_from_df", "cuda", sizes,
                                    {"float/copy", "float/aos", "float/soa", "float/aosoa32", "double/aosoa32"});
  rows.insert(rows.end(), usual.begin(), usual.end());
  const Adder<CudaKernels, OnScene<DpFromDf, float>> of(rows, provider);
  of.add("record", [provider] { return record_case(provider); });
  AllSchemes::for_each([&]<class Scheme>() { of.template scheme<Scheme, Aosoa<32>>("aosoa32"); });
  of.template scheme<scheme::AllHalf, Aosoa<64>>("aosoa64");
  for (std::size_t k = before; k < rows.size(); ++k) rows[k].model = model_of(rows[k]);
}

[[maybe_unused]] const bool rows = add(Part{"storage", 0, "dp_from_df", "cuda", add_rows});

}  // namespace

}  // namespace physgen::bench
