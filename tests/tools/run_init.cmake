# `luxgate init` gives a project that passes, and never touches a file that is there.
#   cmake -DLUXGATE=<binary> -DWORK=<scratch> -P run_init.cmake
cmake_minimum_required(VERSION 3.25)

file(REMOVE_RECURSE ${WORK})
function(expect_exit expected)
  execute_process(COMMAND ${LUXGATE} ${ARGN} RESULT_VARIABLE exit_code
    OUTPUT_VARIABLE out ERROR_VARIABLE err)
  if(NOT exit_code EQUAL expected)
    message(FATAL_ERROR "luxgate ${ARGN}: exit code ${exit_code}, expected ${expected}\n${out}${err}")
  endif()
endfunction()

expect_exit(0 init ${WORK}/new)
expect_exit(0 validate ${WORK}/new/project.xml)
expect_exit(0 check ${WORK}/new/project.xml)
file(SHA256 ${WORK}/new/project.xml before)
expect_exit(2 init ${WORK}/new)
file(SHA256 ${WORK}/new/project.xml after)
if(NOT before STREQUAL after)
  message(FATAL_ERROR "init changed an existing file")
endif()
