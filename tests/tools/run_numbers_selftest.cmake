# The extremes of the selftest under every instruction set: the same bytes.
#   cmake -DLUXGATE=<binary> -P run_numbers_selftest.cmake
cmake_minimum_required(VERSION 3.25)

execute_process(COMMAND ${LUXGATE} version --json OUTPUT_VARIABLE version)
string(JSON count LENGTH "${version}" instruction_sets)
math(EXPR last "${count} - 1")
set(first "")
foreach(k RANGE ${last})
  string(JSON isa GET "${version}" instruction_sets ${k})
  execute_process(COMMAND ${CMAKE_COMMAND} -E env LUXGATE_ISA=${isa} --unset=LUXGATE_SHARED_DATA
      ${LUXGATE} selftest --json
    RESULT_VARIABLE code OUTPUT_VARIABLE out ERROR_VARIABLE err)
  if(NOT code EQUAL 0)
    message(FATAL_ERROR "${isa}: exit code ${code}\n${err}")
  endif()
  string(REGEX REPLACE "\"[a-z_]*seconds\": [0-9.e+-]+" "" out "${out}")  # of the clock
  string(SHA256 hash "${out}")
  message(STATUS "${isa}: ${hash}")
  if(first STREQUAL "")
    set(first ${hash})
  elseif(NOT hash STREQUAL first)
    message(SEND_ERROR "the selftest has other numbers under ${isa}")
  endif()
endforeach()
