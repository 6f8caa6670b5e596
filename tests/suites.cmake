# cmake -D PROGRAM=p -D NAME=n -D PROPERTIES=... -D FILE=f -P suites.cmake: writes for ctest one test for each test suite of the
# GoogleTest program p, which runs its cases in one process: starting one for each case is what takes time where cases are
# small. A suite of which every case is skipped counts as skipped; one with a failure never does.
execute_process(COMMAND ${PROGRAM} --gtest_list_tests OUTPUT_VARIABLE listed RESULT_VARIABLE result TIMEOUT 60)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "${PROGRAM} --gtest_list_tests ended with ${result}:\n${listed}")
endif()
string(REGEX REPLACE " +#[^\n]*" "" listed "${listed}")  # the types and values of suites and cases
string(REGEX MATCHALL "[^\n]+" lines "${listed}")
set(skipped "\\[  PASSED  \\] 0 tests[.]\n\\[  SKIPPED \\] [^\n]*\n(\\[  SKIPPED \\] [^\n]*\n)+$")
set(text "")
set(suites 0)
foreach(line IN LISTS lines)
  if(line MATCHES "^([A-Za-z0-9_/]+)[.]$")
    set(suite ${CMAKE_MATCH_1})
    math(EXPR suites "${suites} + 1")
    string(APPEND text "add_test([=[${NAME}.${suite}]=] [=[${PROGRAM}]=] [=[--gtest_filter=${suite}.*]=])\n"
      "set_tests_properties([=[${NAME}.${suite}]=] PROPERTIES ${PROPERTIES} SKIP_REGULAR_EXPRESSION [=[${skipped}]=])\n")
  elseif(NOT line MATCHES "^  [A-Za-z0-9_/]+$|^Running main")
    message(FATAL_ERROR "${PROGRAM} --gtest_list_tests says what is not understood: ${line}")
  endif()
endforeach()
if(NOT suites)
  message(FATAL_ERROR "${PROGRAM} has no test suite")
endif()
file(WRITE ${FILE} "${text}")
