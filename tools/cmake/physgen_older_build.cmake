# A build folder that an older checkout filled: headers of schemas and scenes that were renamed, moved or dropped since would
# still be found by #include, beside those that the build writes today.

# physgen_remove_older_headers(folder)
# Removes from `folder`, which is within the build folder, what physgen wrote of schemas and scenes that no call of
# physgen_generate() or physgen_generate_scenes() names now, and says which. Call it after those calls. Code that includes a
# removed header then does not compile, in place of compiling with two states of one object.
function(physgen_remove_older_headers folder)
  get_property(written GLOBAL PROPERTY PHYSGEN_WRITTEN_HEADERS)
  set(endings physgen.h python.cpp scene.h program.h everything.h halos.h distributed.h digest need.txt need.json usage.json)
  list(TRANSFORM endings PREPEND ${folder}/*. OUTPUT_VARIABLE patterns)
  file(GLOB found ${patterns})
  set(removed "")
  foreach(file IN LISTS found)
    set(of_schema "${file}")  # the header beside which physgen wrote it
    string(REGEX REPLACE "[.]python[.]cpp$" ".physgen.h" of_schema "${of_schema}")
    string(REGEX REPLACE "[.](program[.]h|everything[.]h|halos[.]h|distributed[.]h|digest|need[.]txt|need[.]json|usage[.]json)$" ".scene.h" of_schema "${of_schema}")
    if(NOT of_schema IN_LIST written)
      file(REMOVE "${file}")
      cmake_path(GET file FILENAME name)
      list(APPEND removed ${name})
    endif()
  endforeach()
  if(removed)
    list(JOIN removed ", " removed)
    message(STATUS "physgen: removed from ${folder} what an older checkout wrote there: ${removed}. No schema or scene has these "
      "names now; CHANGELOG.md says what replaces them")
  endif()
endfunction()
