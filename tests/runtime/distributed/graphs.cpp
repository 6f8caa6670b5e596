// graphs on the host: see graphs_run.h.
#include <physgen/distributed/executor.h>

#include "graphs_run.h"

int main(int argc, char** argv) {
  try {
    return graphs::run<physgen::HostExecutor>(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
