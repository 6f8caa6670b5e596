// See results_file.h.
#include "report/results_file.h"

#include "report/kernel_hashes.h"

namespace physgen::bench {

int RowsOnLines::overflow(int character) {
  if (character == traits_type::eof()) return traits_type::not_eof(character);
  line_ += traits_type::to_char_type(character);
  if (line_.back() == '\n') end_line();
  return character;
}

int RowsOnLines::sync() {
  out_.flush();
  return out_ ? 0 : -1;
}

void RowsOnLines::end_line() {
  const std::size_t indent = line_.find_first_not_of(' ');
  const std::string text = line_.substr(indent, line_.size() - indent - 1);
  if (row_.empty() && text == "{" && !is_first_) {
    row_ = line_.substr(0, indent) + text;
    last_of_row_ = last_;
  } else if (row_.empty()) {
    out_ << line_;
  } else {
    const bool ends = text == "}" || text == "},";
    if (ends && !last_of_row_.empty()) row_ += ", " + last_of_row_;
    row_ += (ends || row_.back() == '{' ? "" : " ") + text;
    if (ends) out_ << row_ << '\n', row_.clear();
  }
  line_.clear();
  is_first_ = false;
}

bool ResultsReporter::ReportContext(const Context& context) {
  lines_.emplace(GetOutputStream());
  stream_.rdbuf(&*lines_);
  SetOutputStream(&stream_);
  return JSONReporter::ReportContext(context);
}

void ResultsReporter::ReportRuns(const std::vector<Run>& runs) {
  for (const Run& run : runs) {
    const std::string kernels = kernels_of(group_, run.benchmark_name());
    lines_->set_last(kernels.empty() ? "" : R"("kernels": ")" + kernels + '"');
    JSONReporter::ReportRuns({run});
  }
}

void ResultsReporter::Finalize() {
  JSONReporter::Finalize();
  stream_.flush();
}

}  // namespace physgen::bench
