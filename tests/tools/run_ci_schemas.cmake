# SARIF and JUnit XML of the samples, of every example and of projects that cannot be read, against other people's schemas.
# They are not part of this tree, environment variables name them; without any the test is skipped:
#   LUXGATE_SARIF_SCHEMA   the official JSON schema of SARIF 2.1.0; by python3-jsonschema
#   LUXGATE_JUNIT_SCHEMA   the XSD that Jenkins has had; by xmllint. It does not know what others read: place in a file
#                          (file, line) and the reason of what is skipped, which are left out of what is checked
#   cmake -DLUXGATE=<binary> -DEXAMPLES=<folder> -DSAMPLES=<folder> -DWORK=<scratch> -P run_ci_schemas.cmake
cmake_minimum_required(VERSION 3.25)

set(sarif_schema "$ENV{LUXGATE_SARIF_SCHEMA}")
set(junit_schema "$ENV{LUXGATE_JUNIT_SCHEMA}")
if(sarif_schema STREQUAL "" AND junit_schema STREQUAL "")
  message("skipped: neither LUXGATE_SARIF_SCHEMA nor LUXGATE_JUNIT_SCHEMA names a schema")
  return()
endif()
file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK})

function(expect_valid is_valid file)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE code OUTPUT_VARIABLE out ERROR_VARIABLE err)
  if(is_valid AND NOT code EQUAL 0)
    message(SEND_ERROR "${file}: ${code}\n${out}${err}")
  elseif(NOT is_valid AND code EQUAL 0)
    message(SEND_ERROR "${file} should not be valid")
  endif()
endfunction()

function(check_sarif is_valid file)
  expect_valid(${is_valid} ${file} /usr/bin/python3 -m jsonschema -i ${file} ${sarif_schema})
endfunction()

function(check_junit is_valid file)
  file(READ ${file} text)
  string(REGEX REPLACE " (file|line)=\"[^\"]*\"" "" text "${text}")
  string(REGEX REPLACE "<skipped message=\"[^\"]*\"" "<skipped" text "${text}")
  file(WRITE ${WORK}/bare.xml "${text}")
  expect_valid(${is_valid} ${file} xmllint --noout --schema ${junit_schema} ${WORK}/bare.xml)
endfunction()

file(WRITE ${WORK}/broken/project.xml "<luxgate")
file(GLOB projects ${EXAMPLES}/[0-9]*/project.xml)
foreach(project ${projects} ${WORK}/broken/project.xml ${WORK}/absent/project.xml)
  get_filename_component(name ${project} DIRECTORY)
  get_filename_component(name ${name} NAME)
  execute_process(COMMAND ${LUXGATE} check --quiet --tolerance 0.2 --redact --pictures off ${project}
    --format sarif=${WORK}/${name}.sarif --format sarif-all=${WORK}/${name}.all.sarif --format junit=${WORK}/${name}.junit.xml
    OUTPUT_QUIET ERROR_QUIET)
endforeach()
file(GLOB sarif ${WORK}/*.sarif ${SAMPLES}/*.sarif)
file(GLOB junit ${WORK}/*.junit.xml ${SAMPLES}/*.junit.xml)
list(LENGTH projects count)
list(LENGTH junit made)
math(EXPR expected "${count} + 3")  # what cannot be read, and a sample
if(NOT made EQUAL expected)
  message(FATAL_ERROR "${made} files instead of ${expected}")
endif()

# Something else must be found out, or the check proves nothing.
if(NOT sarif_schema STREQUAL "")
  foreach(file ${sarif})
    check_sarif(TRUE ${file})
  endforeach()
  file(READ ${SAMPLES}/expected.sarif text)
  string(REPLACE "\"kind\": \"" "\"kind\": \"not-" text "${text}")
  file(WRITE ${WORK}/changed.json "${text}")
  check_sarif(FALSE ${WORK}/changed.json)
  list(LENGTH sarif count)
  message(STATUS "${count} files are SARIF")
endif()
if(NOT junit_schema STREQUAL "")
  foreach(file ${junit})
    check_junit(TRUE ${file})
  endforeach()
  file(READ ${SAMPLES}/expected.junit.xml text)
  string(REPLACE "<failure " "<trouble " text "${text}")
  string(REPLACE "</failure>" "</trouble>" text "${text}")
  file(WRITE ${WORK}/changed.xml "${text}")
  check_junit(FALSE ${WORK}/changed.xml)
  list(LENGTH junit count)
  message(STATUS "${count} files are JUnit XML")
endif()
