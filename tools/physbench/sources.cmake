# Writes the hashes of the sources that results depend on as C++: cmake -D CHECKOUT=folder -D OUTPUT=file.cpp -P
# sources.cmake. tools/report/sources.py says what is hashed, and how.
cmake_minimum_required(VERSION 3.25)

set(hashes)
foreach(group IN ITEMS runtime generated/elasticity.physgen.h tools/fem/kernels tools/fem/materials tools/fem/mesh
    tools/fem/numerics tools/fem/reference tools/physbench)
  set(patterns "${CHECKOUT}/${group}")  # where it is a file
  foreach(ending IN ITEMS .h .cpp .cu .in .cmake CMakeLists.txt)
    list(APPEND patterns "${CHECKOUT}/${group}/*${ending}")
  endforeach()
  file(GLOB_RECURSE files LIST_DIRECTORIES false RELATIVE "${CHECKOUT}" ${patterns})
  list(SORT files COMPARE STRING)
  set(lines "")
  foreach(file IN LISTS files)
    file(READ "${CHECKOUT}/${file}" content)
    string(REPLACE "\r\n" "\n" content "${content}")
    string(SHA256 hash "${content}")
    string(APPEND lines "${hash}  ${file}\n")
  endforeach()
  string(SHA256 hash "${lines}")
  string(SUBSTRING ${hash} 0 16 hash)
  list(APPEND hashes "${group} ${hash}")
endforeach()
list(JOIN hashes ", " hashes)

# Leaves the file alone where nothing has changed.
file(CONFIGURE OUTPUT "${OUTPUT}" @ONLY CONTENT "// Written by tools/physbench/sources.cmake.
#include \"report/sources.h\"

const char* physgen::bench::source_hashes() { return \"${hashes}\"; }
")
