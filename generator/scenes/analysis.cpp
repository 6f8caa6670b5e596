// See analysis.h. What is needed on any side is known when all have been read over probes: the unit of each side waits
// for it while the next one is analysed, and goes on then.
#include "scenes/analysis.h"

#include "scenes/probe_unit.h"

namespace physgen::scenes {
namespace {

class Analyser {
 public:
  Analyser(const Scene& scene, const std::string& declaration, const std::vector<std::string>& flags,
           const std::vector<usage::Side>& sides, const usage::Reader& reader)
      : scene_(scene), declaration_(declaration), flags_(flags), sides_(sides), reader_(reader) {}

  Analysis analyse() && {
    Analysis result;
    diagnostics_.resize(sides_.size());
    result.usage = from(0);
    result.diagnostics = std::move(diagnostics_);
    return result;
  }

 private:
  /// Analyses the side of this number and those behind it. @return their uses, united; none: a unit has errors
  std::optional<usage::Usage> from(std::size_t number) {
    const usage::Side side = sides_[number];
    std::optional<usage::Usage> others = usage::Usage();
    const usage::Rest rest = [&](const usage::Usage& found) {
      over_probes_ = usage::unite(over_probes_, found);
      if (number + 1 < sides_.size()) others = from(number + 1);
      return others ? rest_of_unit(scene_, over_probes_) : std::string();
    };
    const auto usage =
        usage::analyse("probes_of_" + scene_.name + ".cpp",
                       probe_unit(scene_, side == usage::Side::host ? "Host" : "Cuda", declaration_), flags_, side,
                       diagnostics_[number], number == 0 ? reader_ : usage::Reader(), rest);
    if (!usage || !others) return std::nullopt;
    return usage::unite(*usage, *others);
  }

  const Scene& scene_;
  const std::string& declaration_;
  const std::vector<std::string>& flags_;
  const std::vector<usage::Side>& sides_;
  const usage::Reader& reader_;
  std::vector<usage::Diagnostics> diagnostics_;
  usage::Usage over_probes_;
};

}  // namespace

Analysis analyse(const Scene& scene, const std::string& declaration, const std::vector<std::string>& flags,
                 const std::vector<usage::Side>& sides, const usage::Reader& reader) {
  return Analyser(scene, declaration, flags, sides, reader).analyse();
}

}  // namespace physgen::scenes
