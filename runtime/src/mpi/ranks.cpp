// Ranks of MPI.
#include <mpi.h>
#include <physgen/distributed/ranks.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <thread>
#include <vector>

#include "../distributed/launcher.h"

namespace physgen {

namespace {

std::string name_of_library() {
  std::array<char, MPI_MAX_LIBRARY_VERSION_STRING> text{};
  int length = 0;
  MPI_Get_library_version(text.data(), &length);
  const std::string all(text.data(), static_cast<std::size_t>(length));
  return all.substr(0, all.find_first_of(",\n"));
}

/// The texts of all ranks.
std::vector<std::string> texts_of_all(std::string_view mine, int ranks) {
  const auto count = static_cast<std::size_t>(ranks);
  const int length = static_cast<int>(mine.size());
  std::vector<int> lengths(count), begins(count, 0);
  MPI_Allgather(&length, 1, MPI_INT, lengths.data(), 1, MPI_INT, MPI_COMM_WORLD);
  for (std::size_t r = 1; r < count; ++r) begins[r] = begins[r - 1] + lengths[r - 1];
  std::string all(static_cast<std::size_t>(begins.back() + lengths.back()), ' ');
  MPI_Allgatherv(mine.data(), length, MPI_CHAR, all.data(), lengths.data(), begins.data(), MPI_CHAR, MPI_COMM_WORLD);
  std::vector<std::string> texts;
  for (std::size_t r = 0; r < count; ++r) {
    texts.push_back(all.substr(static_cast<std::size_t>(begins[r]), static_cast<std::size_t>(lengths[r])));
  }
  return texts;
}

/// Tells ranks above that this one fails, and whether one below does with the same message, which then says it. What
/// all ranks find, they find at about the same time: this waits for two seconds.
bool is_said_below(const std::string& message, int rank, int ranks) {
  constexpr int tag = 2049;
  static std::uint64_t mine;  // until the process ends, as messages on their way have it
  mine = std::hash<std::string>()(message);
  for (int above = rank + 1; above < ranks; ++above) {
    MPI_Request request = MPI_REQUEST_NULL;
    MPI_Isend(&mine, 1, MPI_UINT64_T, above, tag, MPI_COMM_WORLD, &request);
  }
  const auto until = std::chrono::steady_clock::now() + std::chrono::seconds(2);
  while (rank > 0 && std::chrono::steady_clock::now() < until) {
    int has_come = 0;
    MPI_Status status;
    MPI_Iprobe(MPI_ANY_SOURCE, tag, MPI_COMM_WORLD, &has_come, &status);
    if (has_come == 0) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      continue;
    }
    std::uint64_t other = 0;
    MPI_Recv(&other, 1, MPI_UINT64_T, status.MPI_SOURCE, tag, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    if (other == mine) return true;
  }
  return false;
}

}  // namespace

Ranks::Ranks(int& argc, char**& argv, const std::string& build) {
  std::array<char, 256> host{};
  if (gethostname(host.data(), host.size() - 1) == 0) host_ = host.data();
  int is_begun = 0;
  MPI_Initialized(&is_begun);
  if (is_begun == 0) {
    if (!detail::may_be_launched()) return;
    int level = 0;
    MPI_Init_thread(&argc, &argv, MPI_THREAD_FUNNELED, &level);
    ends_mpi_ = true;
  }
  MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
  MPI_Comm_size(MPI_COMM_WORLD, &count_);
  if (count_ == 1) {
    const std::string several = detail::told_of_several_processes();
    if (several.empty()) return;
    const std::string library = name_of_library();
    if (ends_mpi_) MPI_Finalize();
    throw Error("this program was started as one of several processes (" + several +
                "), but not by the launcher of its MPI, so that each of them would be the only rank; start it with the "
                "mpirun of " +
                library + ", or build physgen and the program with the other MPI");
  }
  agree("build", build);
}

Ranks::~Ranks() {
  // The others may wait for this rank for ever.
  if (count_ > 1 && std::uncaught_exceptions() > exceptions_) {
    try {
      fail("an exception left the scope of Ranks; catch it inside, by guard(), to have its message here");
    } catch (...) {
      std::abort();
    }
  }
  int is_ended = 0;
  MPI_Finalized(&is_ended);
  if (ends_mpi_ && is_ended == 0) MPI_Finalize();
}

void Ranks::agree(std::string_view what, std::string_view value) const {
  if (count_ == 1) return;
  const std::vector<std::string> values = texts_of_all(value, count_), hosts = texts_of_all(host_, count_);
  for (std::size_t r = 1; r < values.size(); ++r) {
    if (values[r] == values[0]) continue;
    if (is_first()) {
      fail("rank " + std::to_string(r) + " on " + hosts[r] + " has another " + std::string(what) + ": \"" + values[r] +
           "\", and rank 0 has \"" + values[0] + "\"; start all ranks with equal programs, options and files");
    }
    MPI_Barrier(MPI_COMM_WORLD);  // which the first rank does not reach: it ends all
  }
}

void Ranks::fail(const std::string& message) const {
  if (count_ == 1) throw Error(message);
  if (is_said_below(message, rank_, count_)) {
    std::this_thread::sleep_for(std::chrono::seconds(30));  // that rank ends all
  } else {
    std::fprintf(stderr, "%s: %s\n", name().c_str(), message.c_str());
    std::fflush(stderr);
  }
  MPI_Abort(MPI_COMM_WORLD, 1);
  std::abort();
}

}  // namespace physgen
