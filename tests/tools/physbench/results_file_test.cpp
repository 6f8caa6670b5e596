// The file of results: a row is one line, which says which compiled kernels it measured.
#include "report/results_file.h"

#include <gtest/gtest.h>

#include <sstream>

#include "report/kernel_hashes.h"

namespace physgen::bench {
namespace {

const bool are_known = add_kernel_hashes(
    "scene/host/svd 0123456789abcdef\nset/host/svd 1123456789abcdef\nscene/cuda/svd 2123456789abcdef\n"
    "storage/host 3123456789abcdef\nscene/host/dp_from_df 4123456789abcdef\nscene/host/svd/double 5123456789abcdef\n");

TEST(KernelHashes, are_those_of_the_files_that_may_have_a_row) {
  EXPECT_EQ(kernels_of("kernels", "svd/aosoa16/float/host/1000"), "scene/host/svd 0123456789abcdef");
  EXPECT_EQ(kernels_of("kernels", "svd/aosoa16/double/host/1000"), "scene/host/svd/double 5123456789abcdef");
  EXPECT_EQ(kernels_of("kernels", "svd/aos/double/cuda/1000"), "scene/cuda/svd 2123456789abcdef");
  EXPECT_EQ(kernels_of("errors", "svd/aosoa16/float/host/1000/hard"), "set/host/svd 1123456789abcdef");
  EXPECT_EQ(kernels_of("storage", "dp_from_df/aosoa16/half/host/1000"),
            "storage/host 3123456789abcdef, scene/host/dp_from_df 4123456789abcdef");
  EXPECT_EQ(kernels_of("kernels", "stress/aos/float/host/1000"), "") << "no file of the build is known to have it";
  EXPECT_EQ(kernels_of("kernels", "svd"), "");
}

std::vector<benchmark::BenchmarkReporter::Run> runs_of(const std::vector<std::string>& names) {
  std::vector<benchmark::BenchmarkReporter::Run> runs;
  for (const std::string& name : names) {
    benchmark::BenchmarkReporter::Run run;
    run.run_name.function_name = name;
    run.counters["median_ms"] = 0.25;
    run.report_label = "{ a, \"b\"\n}";
    runs.push_back(run);
  }
  return runs;
}

TEST(ResultsFile, has_a_row_a_line_with_its_kernels_last) {
  std::ostringstream out;
  ResultsReporter reporter("kernels");
  reporter.SetOutputStream(&out);
  ASSERT_TRUE(reporter.ReportContext(benchmark::BenchmarkReporter::Context()));
  reporter.ReportRuns(runs_of({"svd/aosoa16/float/host/1000", "stress/aos/float/host/1000"}));
  reporter.ReportRuns(runs_of({"svd/aos/float/cuda/1000"}));
  reporter.Finalize();
  std::vector<std::string> rows;
  std::istringstream in(out.str());
  for (std::string line; std::getline(in, line);)
    if (line.find("\"median_ms\"") != std::string::npos) rows.push_back(line);
  ASSERT_EQ(rows.size(), 3U) << out.str();
  for (const std::string& row : rows) EXPECT_TRUE(row.starts_with("    {\"name\": \"")) << row;
  EXPECT_TRUE(rows[0].ends_with(", \"kernels\": \"scene/host/svd 0123456789abcdef\"},")) << rows[0];
  EXPECT_TRUE(rows[1].ends_with("},")) << rows[1];
  EXPECT_EQ(rows[1].find("kernels"), std::string::npos) << rows[1];
  EXPECT_TRUE(rows[2].ends_with(", \"kernels\": \"scene/cuda/svd 2123456789abcdef\"}")) << rows[2];
  EXPECT_TRUE(out.str().ends_with("}\n  ]\n}\n")) << out.str();
}

}  // namespace
}  // namespace physgen::bench
