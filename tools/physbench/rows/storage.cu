// Rows of the GPU: dP from dF in every storage scheme, and over records of whole elements.
#include "../cuda_rows.h"
#include "../groups.h"
#include "../schemes.h"

namespace physgen::bench {

namespace {

template <class Scheme>
struct AddRow {
  template <class Layout>
  static void add(std::vector<Row>& rows, Dataset& data, const char* layout) {
    Row row = describe<DpFromDf, float>(layout, SpaceKind::cuda, data);
    row.storage = Scheme::name;
    row.bytes_per_object = Scheme::template bytes<float>();
    const double bytes = row.bytes_per_object * static_cast<double>(row.objects);
    row.make = [&data, bytes]() -> std::unique_ptr<Case> {
      return std::make_unique<detail::CudaCase<DpFromDf, float, Layout, Scheme>>(data, bytes);
    };
    rows.push_back(std::move(row));
  }
};

class RecordCase final : public TimedCudaCase {
 public:
  explicit RecordCase(Dataset& data)
      : TimedCudaCase(bytes_moved<DpFromDf, float>(data)),
        data_(data),
        elements_(data.count(Domain::tets, Domain::tets)) {
    elasticity::ElementRecordArray<float> loaded(elements_.size());
    load_records(data, loaded);
    physgen::copy(elements_, loaded);
  }
  double run() override {
    const auto kernel = DpFromDfRecords::make(elements_.view());
    watch().start();
    parallel_for(Cuda{}, elements_.size(), kernel);
    return watch().stop();
  }
  Accuracy check() override {
    run();
    elasticity::ElementRecordArray<float> records(elements_.size());
    physgen::copy(records, elements_);
    synchronize();
    Result<DpFromDf, float> result(elements_.size());
    for (index_t i = 0; i < result.size(); ++i) result.view()[i].dP() = records.view()[i].dP().get();
    return HostKernel<DpFromDf>::check(data_, result.storage());
  }

 private:
  Dataset& data_;
  elasticity::ElementRecordArray<float, Cuda> elements_;
};

}  // namespace

void add_cuda_storage_rows(std::vector<Row>& rows, Dataset& data) {
  detail::add_cuda_row<DpFromDf, float, detail::CudaCopyCase<DpFromDf, float>>(rows, data, "copy");
  detail::add_cuda_row<DpFromDf, float, RecordCase>(rows, data, "record");
  detail::add_cuda_row<DpFromDf, float, detail::CudaCase<DpFromDf, float, Aos>>(rows, data, "aos");
  detail::add_cuda_row<DpFromDf, float, detail::CudaCase<DpFromDf, float, Soa>>(rows, data, "soa");
  detail::add_cuda_row<DpFromDf, float, detail::CudaCase<DpFromDf, float, Aosoa<32>>>(rows, data, "aosoa32");
  detail::add_cuda_row<DpFromDf, double, detail::CudaCase<DpFromDf, double, Aosoa<32>>>(rows, data, "aosoa32");
  AllSchemes::for_each([&]<class Scheme>() { AddRow<Scheme>::template add<Aosoa<32>>(rows, data, "aosoa32"); });
  AddRow<scheme::AllHalf>::add<Aosoa<64>>(rows, data, "aosoa64");
}

}  // namespace physgen::bench
