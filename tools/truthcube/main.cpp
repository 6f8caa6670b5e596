// truthcube: the paper's silicone cube, or a mesh of your own, compressed quasistatically.
#include "parse.h"
#include "program.h"
#include "run.h"

int main(int count, char** words) {
  using namespace physgen::truthcube;
  return run_program("truthcube", count, words, parse,
                     [](Options options, const std::string& command, const physgen::Ranks& ranks) {
                       return static_cast<int>(run(std::move(options), command, ranks));
                     });
}
