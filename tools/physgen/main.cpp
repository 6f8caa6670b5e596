// The command physgen. Everything it does is in command.h; only this file talks to the process.
#include <exception>
#include <iostream>

#include "command.h"

int main(int argc, char** argv) {
  try {
    return physgen::command::run({argv + 1, argv + argc}, std::cout, std::cerr);
  } catch (const std::exception& error) {
    std::cerr << "physgen: internal error: " << error.what() << '\n';
    return 2;
  }
}
