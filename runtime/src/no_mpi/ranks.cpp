// Ranks of a build without MPI: one.
#include <physgen/distributed/ranks.h>
#include <unistd.h>

#include <array>

#include "../distributed/launcher.h"

namespace physgen {

Ranks::Ranks(int& /*argc*/, char**& /*argv*/, const std::string& /*build*/) {
  std::array<char, 256> host{};
  if (gethostname(host.data(), host.size() - 1) == 0) host_ = host.data();
  const std::string several = detail::told_of_several_processes();
  if (!several.empty()) {
    throw Error("this program was started as one of several processes (" + several +
                "), but physgen was built without MPI; install libopenmpi-dev and build physgen and the program again, "
                "or start the program by itself");
  }
}

Ranks::~Ranks() = default;

void Ranks::agree(std::string_view /*what*/, std::string_view /*value*/) const {}

void Ranks::fail(const std::string& message) const { throw Error(message); }

}  // namespace physgen
