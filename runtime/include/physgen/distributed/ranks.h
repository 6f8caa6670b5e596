// The ranks of a program: the processes that mpirun started, how they agree, and how they end together. A program
// without MPI, or that was started by itself, has one.
#pragma once

#include <physgen/config.h>
#include <physgen/error.h>

#include <exception>
#include <string>
#include <string_view>

#ifndef PHYSGEN_ANY_MODE
#include <physgen/detail/build_of_program.h>
#endif

namespace physgen {

/// Made once, first thing in main(): it begins MPI, and ends it when it goes out of scope. Where no launcher started
/// the program, and MPI has not begun, it does without MPI.
///
/// When one rank cannot go on, all end: where an exception leaves the scope of Ranks, in fail(), and where a kernel
/// throws. With one rank an exception is an ordinary one.
class Ranks {
 public:
  /// @param argc, argv of main(), from which MPI may take arguments of its own
  /// @param build compared among all ranks
  /// @throw Error when the program was started as one of several processes, but by the launcher of another MPI, or of a
  /// build without MPI: each of them would be the only rank, and write the same files
  Ranks(int& argc, char**& argv, const std::string& build);
#ifndef PHYSGEN_ANY_MODE
  Ranks(int& argc, char**& argv) : Ranks(argc, argv, detail::build_of_program()) {}
#endif
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;
  ~Ranks();

  [[nodiscard]] int rank() const { return rank_; }
  [[nodiscard]] int count() const { return count_; }
  [[nodiscard]] bool is_first() const { return rank_ == 0; }
  /// The name of this rank's machine.
  [[nodiscard]] const std::string& host() const { return host_; }
  /// "rank 2 of 4 on HOST"
  [[nodiscard]] std::string name() const;

  /// Every rank calls this with its value: a text, or a digest of a schema, of options or of a file. Where one has
  /// another value than the first rank, all ranks end with a message that has both values.
  /// @param what the value is of, for the message: "options"
  /// @throw nothing with one rank
  void agree(std::string_view what, std::string_view value) const;

  /// Ends all ranks, with the message and the name of this one on the standard error output. Where several ranks find
  /// the same within two seconds, the lowest of them says it. With one rank:
  /// @throw Error with the message
  [[noreturn]] void fail(const std::string& message) const;

  /// body(), whose exceptions end all ranks with their messages. With one rank they are passed on.
  template <class Body>
  decltype(auto) guard(const Body& body) const {
    if (count_ == 1) return body();
    try {
      return body();
    } catch (const std::exception& error) {
      fail(error.what());
    }
  }

 private:
  int rank_ = 0, count_ = 1;
  std::string host_;
  bool ends_mpi_ = false;
  int exceptions_ = std::uncaught_exceptions();
};

}  // namespace physgen
