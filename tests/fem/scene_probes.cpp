// Prints what the compiler of the other source, a scene's program over probes, has found: a line for each field.
#include <physgen/probe/registry.h>

#include <cstdio>

int main() {
  for (const physgen::probe::FieldAccess& row : physgen::probe::registered()) {
    std::printf("%s %s%s%s%s\n", row.array.c_str(), row.field.c_str(), row.read ? " read" : "",
                row.written ? " written" : "", row.address_taken ? " address_taken" : "");
  }
}
