# Results of examples (one with limits of a rule pack, some of them of a mask's points) against the published schema, by python3-jsonschema, and 'luxgate report' of them.
#   cmake -DLUXGATE=<binary> -DEXAMPLES=<folder> -DWORK=<scratch> -P run_result_schema.cmake
cmake_minimum_required(VERSION 3.25)

function(run expected_code output)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE code OUTPUT_VARIABLE out ERROR_VARIABLE err)
  if(NOT code EQUAL expected_code)
    list(JOIN ARGN " " words)
    message(FATAL_ERROR "${words}: exit code ${code}, expected ${expected_code}\n${out}${err}")
  endif()
  set(${output} "${out}${err}" PARENT_SCOPE)
endfunction()

file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK})
execute_process(COMMAND ${LUXGATE} schema --result OUTPUT_FILE ${WORK}/schema.json COMMAND_ERROR_IS_FATAL ANY)
file(WRITE ${WORK}/bad.xml "<luxgate")
set(projects ${EXAMPLES}/01-one-luminaire/project.xml ${EXAMPLES}/03-cornell-box/project.xml ${EXAMPLES}/09-office-by-row/project.xml ${WORK}/bad.xml)
run(2 ignored ${LUXGATE} check ${projects} --tolerance 0.2 --by-luminaire --quiet --timing --timestamp 0 --pictures off
  --format json=${WORK}/result.json --format html=${WORK}/first.html --format junit=${WORK}/first.xml)
run(0 ignored /usr/bin/python3 -m jsonschema -i ${WORK}/result.json ${WORK}/schema.json)

# A result that says something else must be found out, or the check above proves nothing.
file(READ ${WORK}/result.json text)
string(REPLACE "\"verdict\": \"pass\"" "\"verdict\": \"good\"" changed "${text}")
if(changed STREQUAL text)
  message(FATAL_ERROR "no pass in the result")
endif()
file(WRITE ${WORK}/changed.json "${changed}")
run(1 ignored /usr/bin/python3 -m jsonschema -i ${WORK}/changed.json ${WORK}/schema.json)
run(2 refusal ${LUXGATE} report ${WORK}/changed.json)
if(NOT refusal MATCHES "/verdict: one of 'pass'")
  message(FATAL_ERROR "not refused in the right words: ${refusal}")
endif()

# Rendered again, byte by byte.
run(0 ignored ${LUXGATE} report ${WORK}/result.json --quiet
  --format json=${WORK}/again.json --format html=${WORK}/again.html --format junit=${WORK}/again.xml)
run(0 ignored ${CMAKE_COMMAND} -E compare_files ${WORK}/result.json ${WORK}/again.json)
run(0 ignored ${CMAKE_COMMAND} -E compare_files ${WORK}/first.html ${WORK}/again.html)
run(0 ignored ${CMAKE_COMMAND} -E compare_files ${WORK}/first.xml ${WORK}/again.xml)
run(2 refusal ${LUXGATE} report ${WORK}/result.json --format json=${WORK}/result.json)
if(NOT refusal MATCHES "is an input and would be overwritten")
  message(FATAL_ERROR "an input was not protected: ${refusal}")
endif()
