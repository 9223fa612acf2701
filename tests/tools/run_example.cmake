# Runs one example from its own folder, with what its file `arguments` says, a word a line, if it has one, and compares the
# exit code with the file expected_exit.
#   cmake -DLUXGATE=<binary> -DEXAMPLE=<folder> -DWORK=<scratch> -P run_example.cmake
cmake_minimum_required(VERSION 3.25)

foreach(file README.md project.xml expected_exit)
  if(NOT EXISTS ${EXAMPLE}/${file})
    message(FATAL_ERROR "${EXAMPLE} has no ${file}")
  endif()
endforeach()
file(STRINGS ${EXAMPLE}/expected_exit expected)
file(REMOVE_RECURSE ${WORK})
set(arguments)
if(EXISTS ${EXAMPLE}/arguments)
  file(STRINGS ${EXAMPLE}/arguments arguments)
endif()
execute_process(COMMAND ${LUXGATE} check project.xml ${arguments} --output ${WORK} --images --pictures off
  WORKING_DIRECTORY ${EXAMPLE} RESULT_VARIABLE exit_code OUTPUT_VARIABLE out ERROR_VARIABLE err)
message("${out}${err}")
if(NOT exit_code STREQUAL expected)
  message(FATAL_ERROR "exit code ${exit_code}, expected ${expected}")
endif()
string(REGEX REPLACE "luxgate: wrote [^\n]*\n" "" err "${err}")
if(NOT err STREQUAL "")
  message(FATAL_ERROR "an example must run without warnings")
endif()
# Whatever the program writes as a result it must read again, to the byte.
execute_process(COMMAND ${LUXGATE} report ${WORK}/result.json --quiet --format json=${WORK}/again.json
  COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_COMMAND} -E compare_files ${WORK}/result.json ${WORK}/again.json
  COMMAND_ERROR_IS_FATAL ANY)
foreach(file results.csv points.csv result.json report.html)
  if(NOT EXISTS ${WORK}/${file})
    message(FATAL_ERROR "${file} was not written")
  endif()
endforeach()
