// Packs against single numbers and narrower packs, through the file of results.
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "agreement_checks.h"
#include "run_case.h"

namespace physgen::fem {
namespace {

template <class Real, class Layout, int kLanes>
using Case = RunCase<Real, Host, Layout, kLanes>;
using Cases = testing::Types<Case<float, Aosoa<32>, 8>, Case<float, Aos, 1>, Case<float, Soa, 4>, Case<double, Aos, 1>,
                             Case<double, Soa, 4>>;
INSTANTIATE_TYPED_TEST_SUITE_P(Host, Agreement, Cases);

TEST(AgreementFile, that_is_none_or_cut_short_is_refused) {
  const auto folder = std::filesystem::temp_directory_path();
  const std::string path = (folder / ("physgen_no_results_" + std::to_string(::getpid()))).string();
  EXPECT_THROW((void)agreement::read<float>(path + "_absent"), std::runtime_error);
  std::ofstream(path) << "something else\n";
  EXPECT_THROW((void)agreement::read<float>(path), std::runtime_error);
  agreement::write<float>(path, {{"F", {1, 2, 3}}});
  EXPECT_EQ(agreement::read<float>(path).at("F"), (std::vector<float>{1, 2, 3}));
  EXPECT_THROW((void)agreement::read<double>(path), std::runtime_error);
  std::filesystem::resize_file(path, std::filesystem::file_size(path) - 1);
  EXPECT_THROW((void)agreement::read<float>(path), std::runtime_error);
  std::filesystem::remove(path);
}

TEST(AgreementFile, shows_a_difference_of_one_ulp) {
  agreement::Results<float> a{{"dP", std::vector<float>(18, 1)}}, b = a;
  EXPECT_EQ(agreement::compare<float>(a, b).at("dP").differing, 0u);
  b["dP"][11] = std::nextafter(1.F, 2.F);
  const agreement::Difference d = agreement::compare<float>(a, b).at("dP");
  EXPECT_EQ(d.objects, 2u);
  EXPECT_EQ(d.differing, 1u);
  EXPECT_DOUBLE_EQ(d.worst, 1);
  b["dP"][11] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_TRUE(std::isnan(agreement::compare<float>(a, b).at("dP").worst));
}

}  // namespace
}  // namespace physgen::fem
