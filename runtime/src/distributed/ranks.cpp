// What does not depend on MPI; the rest is in mpi/ranks.cpp and no_mpi/ranks.cpp.
#include <physgen/distributed/ranks.h>

namespace physgen {

std::string Ranks::name() const {
  return "rank " + std::to_string(rank_) + " of " + std::to_string(count_) + " on " + host_;
}

}  // namespace physgen
