// The sources with which a result was measured. tools/report/sources.py prints the same of a checkout.
#pragma once

namespace physgen::bench {

/// A hash of each group of sources that rows depend on: "runtime 0123456789abcdef, generated ...".
[[nodiscard]] const char* source_hashes();

}  // namespace physgen::bench
