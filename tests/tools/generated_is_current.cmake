# Fails when the headers in CHECKED_IN are not those that physgen has just written to WRITTEN, and shows the difference. Tables of
# halos, and arrays for several ranks, are files of a build alone.
file(GLOB written RELATIVE ${WRITTEN} ${WRITTEN}/*.h)
list(FILTER written EXCLUDE REGEX "\\.(halos|distributed)\\.h$")
file(GLOB checked_in RELATIVE ${CHECKED_IN} ${CHECKED_IN}/*.h)
set(stale "")
foreach(header IN LISTS written checked_in)
  execute_process(COMMAND diff -u -N ${CHECKED_IN}/${header} ${WRITTEN}/${header} RESULT_VARIABLE different)
  if(different)
    list(APPEND stale ${header})
  endif()
endforeach()
list(REMOVE_DUPLICATES stale)
if(stale)
  message(FATAL_ERROR "${CHECKED_IN} is stale: ${stale}. To renew it: "
    "tools/dev build release update-generated")
endif()
