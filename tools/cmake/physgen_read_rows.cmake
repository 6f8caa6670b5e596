# physgen_read_rows(variable header TABLE FILES path...): the rows of a catalogue, which stand in a header as
#
#   #define PHYSGEN_TABLE(ROW, ...)
#     ROW(first, second, "third", __VA_ARGS__)
#
# Sets the variable to a list with a text a row, "first|second|third". CMake runs again when the header changes. Each path
# must exist, in which @1@ and so on are the columns of a row.
include_guard(DIRECTORY)

function(physgen_read_rows variable header table)
  cmake_parse_arguments(PARSE_ARGV 3 arg "" "" "FILES")
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${header})
  file(READ ${header} text)
  if(NOT text MATCHES "#define PHYSGEN_${table}\\(ROW[^\n]*\n((  ROW\\([^\n]*\n)+)")
    message(FATAL_ERROR "${header}: there is no '#define PHYSGEN_${table}(ROW, ...)' with a line 'ROW(...)' for each row")
  endif()
  string(REGEX MATCHALL "ROW\\([^)\n]*" lines "${CMAKE_MATCH_1}")
  set(rows "")
  foreach(line IN LISTS lines)
    string(REGEX REPLACE "ROW\\((.*), __VA_ARGS__.*" "\\1" row "${line}")
    string(REGEX REPLACE "[ \"]" "" row "${row}")
    string(REPLACE "," ";" columns "${row}")
    list(GET columns 0 name)
    foreach(path IN LISTS arg_FILES)
      set(number 0)
      foreach(column IN LISTS columns)
        math(EXPR number "${number} + 1")
        string(REPLACE "@${number}@" "${column}" path "${path}")
      endforeach()
      if(NOT EXISTS ${path})
        message(FATAL_ERROR "${header}: the row ${name} of PHYSGEN_${table} names ${path}, which does not exist; write that "
          "file, or remove the row")
      endif()
    endforeach()
    list(JOIN columns "|" row)
    list(APPEND rows "${row}")
  endforeach()
  set(${variable} "${rows}" PARENT_SCOPE)
endfunction()
