// dP from dF on the CPU in every storage scheme: speed against error.
#include <limits>

#include "groups/schemes.h"
#include "measure/host_rows.h"
#include "measure/row_bytes.h"

namespace physgen::bench {

// For the GPU's rows, too.
template double OnScene<DpFromDf, float>::bytes_in<scheme::QuaternionFloat>() const;
template double OnScene<DpFromDf, float>::bytes_in<scheme::Quaternion16Float>() const;
template double OnScene<DpFromDf, float>::bytes_in<scheme::HalfDerivative>() const;
template double OnScene<DpFromDf, float>::bytes_in<scheme::Bfloat16Derivative>() const;
template double OnScene<DpFromDf, float>::bytes_in<scheme::QuaternionHalf>() const;
template double OnScene<DpFromDf, float>::bytes_in<scheme::Quaternion16Half>() const;
template double OnScene<DpFromDf, float>::bytes_in<scheme::AllHalf>() const;
template double OnScene<DpFromDf, float>::bytes_in<scheme::MatricesHalf>() const;
template double OnScene<DpFromDf, float>::bytes_in<scheme::AllBfloat16>() const;

void load_records(Scene& scene, elasticity::ElementRecordArray<float>& records) {
  const auto inputs = OnScene<DpFromDf, float>(std::shared_ptr<Scene>(&scene, [](Scene*) {})).inputs();
  const auto view = records.view();
  using Matrix = Eigen::Matrix3f;
  physgen::detail::host_loop(view.size(), [&](index_t i) {
    const auto [svd, x, differential] = values_at(inputs, i);
    const auto rounded = [](double value) { return static_cast<float>(value); };
    const Matrix U = svd.U.template cast<float>(), V = svd.V.template cast<float>();
    const Matrix dF = differential.dF.template cast<float>();
    view.put(i, {U, V, rounded(x.x1111), rounded(x.x2211), rounded(x.x3311), rounded(x.x2222), rounded(x.x3322),
                 rounded(x.x3333), rounded(x.x2121), rounded(x.x2112), rounded(x.x3131), rounded(x.x3113),
                 rounded(x.x3232), rounded(x.x3223), dF, Matrix::Constant(std::numeric_limits<float>::quiet_NaN())});
  });
}

namespace {

void add_rows(std::vector<Row>& rows, const Sizes& sizes) {
  const auto usual = rows_of_kernel("dp_from_df", "host", sizes,
                                    {"float/copy", "float/aos_scalar", "float/aos", "float/aosoa16", "double/aosoa16"});
  rows.insert(rows.end(), usual.begin(), usual.end());
  const Adder<HostDevice, OnScene<DpFromDf, float>> of(rows, OnScene<DpFromDf, float>(scene_of(sizes.host)));
  AllSchemes::for_each([&]<class Scheme>() { of.template scheme<Scheme, Aosoa<16>>("aosoa16"); });
}

[[maybe_unused]] const bool group = add(Group{"storage", "dP from dF in every storage scheme: speed against error", 2});
[[maybe_unused]] const bool rows = add(Part{"storage", 0, "dp_from_df", "host", add_rows});

}  // namespace

}  // namespace physgen::bench
