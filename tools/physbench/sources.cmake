# The hashes of the sources that results depend on, as C++, whenever physbench is built:
# cmake -D CHECKOUT=folder -D OUTPUT=file.cpp -P sources.cmake. tools/report/sources.py says what is hashed, and how.
cmake_minimum_required(VERSION 3.25)
set(physgen_source_groups runtime generated tools/fem tools/physbench)

# Sets `result` to the sources of a group, named from the checkout's root. Further arguments are file()'s.
function(physgen_sources_of group checkout result)
  set(patterns)
  foreach(ending IN ITEMS .h .cpp .cu .in .cmake CMakeLists.txt)
    list(APPEND patterns "${checkout}/${group}/*${ending}")
  endforeach()
  file(GLOB_RECURSE found RELATIVE "${checkout}" ${ARGN} ${patterns})
  list(SORT found COMPARE STRING)
  set(${result} "${found}" PARENT_SCOPE)
endfunction()

if(CMAKE_SCRIPT_MODE_FILE STREQUAL CMAKE_CURRENT_LIST_FILE)
  set(hashes)
  foreach(group IN LISTS physgen_source_groups)
    physgen_sources_of(${group} "${CHECKOUT}" files)
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
  file(WRITE "${OUTPUT}" "// Written by tools/physbench/sources.cmake.
#include \"sources.h\"

const char* physgen::bench::source_hashes() { return \"${hashes}\"; }
")
endif()
