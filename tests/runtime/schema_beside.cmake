# Compiles programs that include a schema and its generated header, in both orders: the first error must be the #error that
# says which to remove. The generated header alone, and the vocabulary beside the runtime, must compile.
function(compile result_variable output_variable)  # compile(result output header...)
  list(JOIN ARGN ">\n#include <" headers)
  file(WRITE ${WORK}/main.cpp "#include <${headers}>\nint main() {}\n")
  execute_process(
    COMMAND ${COMPILER} -std=c++20 -fsyntax-only -I${ROOT}/runtime/include -I${ROOT}/generated -I${ROOT}/schemas
      -isystem ${EIGEN} ${WORK}/main.cpp
    RESULT_VARIABLE result ERROR_VARIABLE output)
  set(${result_variable} ${result} PARENT_SCOPE)
  set(${output_variable} "${output}" PARENT_SCOPE)
endfunction()

foreach(headers "contact.physgen.h" "physgen/schema.h;physgen/runtime.h" "physgen/runtime.h;physgen/schema.h" "contact.h")
  compile(result output ${headers})
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "${headers} must compile:\n${output}")
  endif()
endforeach()
foreach(headers "contact.h;contact.physgen.h" "contact.physgen.h;contact.h")
  compile(result output ${headers})
  string(REGEX MATCH "error: [^\n]*" first "${output}")
  if(result EQUAL 0 OR NOT first MATCHES "remove the #include of the schema")
    message(FATAL_ERROR "${headers} was accepted, or the first error does not say what to do: ${first}\n${output}")
  endif()
endforeach()
