# Every golden project as a result, and the result read again: to the byte, and none is refused.
#   cmake -DLUXGATE=<binary> -DGOLDEN=<folder> -DWORK=<scratch> -P run_results_are_read.cmake
cmake_minimum_required(VERSION 3.25)

file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK})
file(GLOB cases LIST_DIRECTORIES true ${GOLDEN}/*)
set(results 0)
foreach(case IN LISTS cases)
  get_filename_component(name ${case} NAME)
  set(args check --quiet project.xml)
  if(EXISTS ${case}/args)
    file(STRINGS ${case}/args args)
  endif()
  list(GET args 0 command)
  # Cases of outputs are about files that must not be written.
  if(NOT command STREQUAL "check" OR name MATCHES "^output-")
    continue()
  endif()
  set(environment)
  if(EXISTS ${case}/environment)
    file(STRINGS ${case}/environment environment)
  endif()
  execute_process(COMMAND ${CMAKE_COMMAND} -E env --unset=SOURCE_DATE_EPOCH ${environment}
    ${LUXGATE} ${args} --pictures off --format json=${WORK}/${name}.json
    WORKING_DIRECTORY ${case} OUTPUT_QUIET ERROR_QUIET)
  if(NOT EXISTS ${WORK}/${name}.json)
    continue()
  endif()
  math(EXPR results "${results} + 1")
  execute_process(COMMAND ${LUXGATE} report ${WORK}/${name}.json --quiet --format json=${WORK}/again.json
    RESULT_VARIABLE code OUTPUT_QUIET ERROR_VARIABLE refusal)
  execute_process(COMMAND ${CMAKE_COMMAND} -E compare_files ${WORK}/${name}.json ${WORK}/again.json
    RESULT_VARIABLE difference OUTPUT_QUIET ERROR_QUIET)
  if(NOT code EQUAL 0 OR NOT difference EQUAL 0)
    message(SEND_ERROR "${name}: exit code ${code}, difference ${difference}\n${refusal}")
  endif()
endforeach()
if(results LESS 35)
  message(FATAL_ERROR "only ${results} results were made")
endif()

# One that says something else gives no report.
file(READ ${WORK}/exact-direct-light.json text)
string(REPLACE "\"verdict\": \"pass\"" "\"verdict\": \"fail\"" changed "${text}")
file(WRITE ${WORK}/changed.json "${changed}")
foreach(command "report;${WORK}/changed.json;--format;html=${WORK}/changed.html"
                "compare;${WORK}/exact-direct-light.json;${WORK}/changed.json")
  execute_process(COMMAND ${LUXGATE} ${command} RESULT_VARIABLE code OUTPUT_VARIABLE out ERROR_VARIABLE err)
  if(NOT code EQUAL 2 OR NOT "${out}${err}" MATCHES "changed.json' is not a luxgate result: /projects/0/.*plane '[^']+', requirement '[^']+'")
    message(SEND_ERROR "${command}: exit code ${code}\n${out}${err}")
  endif()
endforeach()
if(EXISTS ${WORK}/changed.html)
  message(SEND_ERROR "a report of it was written")
endif()
