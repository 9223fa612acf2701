# check_includes must see a name whose header is missing, and a precompiled header that it has no names of.
#   cmake -DCHECK=<check_includes> -DWORK=<scratch> -P check_includes_fails.cmake
cmake_minimum_required(VERSION 3.25)

function(expect_result wanted text)
  file(REMOVE_RECURSE ${WORK})
  file(WRITE ${WORK}/calc/base/has_vector.h "#pragma once\n#include <vector>\n")
  file(WRITE ${WORK}/calc/base/a.cpp "${text}")
  execute_process(COMMAND ${CHECK} ${WORK} ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output)
  if(NOT result EQUAL wanted)
    message(SEND_ERROR "${result} instead of ${wanted} for:\n${text}${output}")
  endif()
endfunction()

expect_result(0 "#include <vector>\nstd::vector<int> v;\n" "<vector>")
expect_result(0 "#include \"calc/base/has_vector.h\"\nstd::vector<int> v;\n" "<vector>")
expect_result(1 "std::vector<int> v;\n" "<vector>")
expect_result(1 "#include <array>\nstd::vector<int> v;\n" "<vector>" "<array>")
expect_result(1 "double x = glm::length(v);\n" "<glm/glm.hpp>")
expect_result(0 "// std::vector<int> v;\nconst char* t = \"std::vector \\\" std::vector\";\n" "<vector>")
expect_result(1 "const char* t = R\"x(\")x\"; std::vector<int> v;\n" "<vector>")
expect_result(0 "int a = 1'000; my::std::vector v; std::vector_like w;\n" "<vector>")
expect_result(1 "int a;\n" "<regex>")
