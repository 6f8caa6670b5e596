# Copies the headers and digests of scenes from WRITTEN to CHECKED_IN, and removes what no scene has written there, such as
# reports of an older checkout, which are files of a build now. Tables of halos, and arrays for several ranks, are
# files of a build, too.
cmake_minimum_required(VERSION 3.25)

file(GLOB written ${WRITTEN}/*.scene.h ${WRITTEN}/*.program.h ${WRITTEN}/*.digest)
if(NOT written)
  message(FATAL_ERROR "${WRITTEN} has no headers of scenes; ${CHECKED_IN} stays as it is")
endif()
file(GLOB former ${CHECKED_IN}/*)
file(COPY ${written} DESTINATION ${CHECKED_IN})
foreach(file IN LISTS former)
  cmake_path(GET file FILENAME name)
  if(NOT ${WRITTEN}/${name} IN_LIST written)
    message(STATUS "Removing ${file}")
    file(REMOVE ${file})
  endif()
endforeach()
