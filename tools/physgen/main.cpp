// The command physgen. Everything it does is in command.h; only this file talks to the process.
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <new>

#include "command.h"

int main(int argc, char** argv) {
  // No exception may leave Clang half-way, as its destructors do not expect that. Nothing has been written by then.
  std::set_new_handler([] {
    std::fputs("physgen: error: this schema needs more memory than there is\n", stderr);
    std::_Exit(2);
  });
  try {
    const int status = physgen::command::run({argv + 1, argv + argc}, std::cout, std::cerr);
    if (std::cout.flush()) return status;
    std::cerr << "physgen: error: cannot write all of the output, which is cut off; is the disk full?\n";
    return 2;
  } catch (const std::exception& error) {
    std::cerr << "physgen: internal error: " << error.what() << '\n';
    return 2;
  }
}
