# The JSON of a sweep, with a variant that is no project and luminaires with a price, against the published schema, by python3-jsonschema.
#   cmake -DLUXGATE=<binary> -DEXAMPLES=<folder> -DWORK=<scratch> -P run_sweep_schema.cmake
cmake_minimum_required(VERSION 3.25)

function(run expected_code)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE code OUTPUT_VARIABLE out ERROR_VARIABLE err)
  if(NOT code EQUAL expected_code)
    list(JOIN ARGN " " words)
    message(FATAL_ERROR "${words}: exit code ${code}, expected ${expected_code}\n${out}${err}")
  endif()
endfunction()

file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK})
execute_process(COMMAND ${LUXGATE} schema --sweep OUTPUT_FILE ${WORK}/schema.json COMMAND_ERROR_IS_FATAL ANY)
run(2 ${LUXGATE} schema --sweep --result)
set(validate /usr/bin/python3 -m jsonschema ${WORK}/schema.json -i)
run(2 ${LUXGATE} sweep ${EXAMPLES}/04-office/project.xml --set linear.llmf=0.9 --vary linear.price=0,89.90 --vary W.count=0,4
  --tolerance 0.2 --quiet --front price --format json=${WORK}/sweep.json)
run(0 ${validate} ${WORK}/sweep.json)
run(0 ${LUXGATE} sweep ${EXAMPLES}/04-office/project.xml --vary W.count=4 --tolerance 0.2 --quiet --format json=${WORK}/bare.json)
run(0 ${validate} ${WORK}/bare.json)

# A sweep that says something else must be found out, or the checks above prove nothing.
file(READ ${WORK}/sweep.json text)
foreach(change "\"verdict\": \"not-judged\"|\"verdict\": \"good\"" "\"front_of\": \"price\"|\"front_of\": \"cost\"" "\"front_of\"|\"of\""
    "\"price\": 0|\"price\": -1" "\"price\": |\"price\": \"x\", \"was\": " "\"margin\": null|\"margin\": 0" "\"low\"|\"least\"" "\"variant\": 1|\"variant\": 0"
    "\"luminaires_without_price\"|\"without_price\"" "\"format_version\": 1|\"format_version\": 2" "\"W.count\": \"0\"|\"W.count\": 0")
  string(REPLACE "|" ";" change "${change}")
  list(GET change 0 from)
  list(GET change 1 to)
  string(REPLACE "${from}" "${to}" changed "${text}")
  if(changed STREQUAL text)
    message(FATAL_ERROR "no ${from} in the sweep")
  endif()
  file(WRITE ${WORK}/changed.json "${changed}")
  run(1 ${validate} ${WORK}/changed.json)
endforeach()
