# Compiles a generated header against a runtime that calls itself another version: must fail with the header's own #error;
# against the real one it must compile, else the failure would prove nothing.
file(REMOVE_RECURSE ${WORK})
file(COPY ${RUNTIME}/physgen DESTINATION ${WORK})
get_filename_component(name ${HEADER} NAME)
file(WRITE ${WORK}/main.cpp "#include \"${HEADER}\"\nint main() {}\n")

function(compile result_variable output_variable)
  execute_process(COMMAND ${COMPILER} -std=c++20 -fsyntax-only -I${WORK} -isystem ${EIGEN} ${WORK}/main.cpp
    RESULT_VARIABLE result ERROR_VARIABLE output)
  set(${result_variable} ${result} PARENT_SCOPE)
  set(${output_variable} "${output}" PARENT_SCOPE)
endfunction()

compile(result output)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "the header does not compile against its own runtime:\n${output}")
endif()
file(READ ${WORK}/physgen/config.h config)
string(REGEX REPLACE "(#define PHYSGEN_RUNTIME_VERSION) [0-9]+" "\\1 999" config "${config}")
file(WRITE ${WORK}/physgen/config.h "${config}")
compile(result output)
if(result EQUAL 0 OR NOT output MATCHES "${name} is for version [0-9]+ of the physgen runtime")
  message(FATAL_ERROR "a runtime of version 999 was accepted, or the message is unclear:\n${output}")
endif()
