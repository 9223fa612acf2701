# Runs one golden case through the real binary, inside the case's folder, so that messages name relative paths.
#   cmake -DLUXGATE=<binary> -DCOMPARE_CSV=<binary> -DCASE=<folder> -DWORK=<scratch> -P run_golden.cmake
# The case holds:
#   args              one argument per line; default: check, --quiet, project.xml
#   environment       NAME=VALUE, one per line; optional
#   expected.exit     the exit code; a case without it fails
#   expected.stderr   standard error, byte by byte; without the file it must be empty
#   expected.stdout   standard output, byte by byte; optional
#   expected.csv      optional: standard output as CSV, words exactly and numbers within the relative
#   tolerance         tolerance that this file states (e.g. 1e-9)
cmake_minimum_required(VERSION 3.25)

if(NOT EXISTS ${CASE}/expected.exit)
  message(FATAL_ERROR "${CASE} has no expected.exit")
endif()
set(args check --quiet project.xml)
if(EXISTS ${CASE}/args)
  file(STRINGS ${CASE}/args args)
endif()

set(environment)
foreach(variable SOURCE_DATE_EPOCH NO_COLOR CLICOLOR_FORCE)
  list(APPEND environment --unset=${variable})
endforeach()
if(EXISTS ${CASE}/environment)
  file(STRINGS ${CASE}/environment more)
  list(APPEND environment ${more})
endif()
execute_process(
  COMMAND ${CMAKE_COMMAND} -E env ${environment} ${LUXGATE} ${args}
  WORKING_DIRECTORY ${CASE}
  RESULT_VARIABLE exit_code OUTPUT_VARIABLE stdout ERROR_VARIABLE stderr)

file(STRINGS ${CASE}/expected.exit expected_exit)
if(NOT exit_code STREQUAL expected_exit)
  message(SEND_ERROR "exit code ${exit_code}, expected ${expected_exit}")
endif()

set(expected_stderr "")
if(EXISTS ${CASE}/expected.stderr)
  file(READ ${CASE}/expected.stderr expected_stderr)
endif()
if(NOT stderr STREQUAL expected_stderr)
  message(SEND_ERROR "standard error is\n${stderr}\nexpected\n${expected_stderr}")
endif()

if(EXISTS ${CASE}/expected.stdout)
  file(READ ${CASE}/expected.stdout expected_stdout)
  if(NOT stdout STREQUAL expected_stdout)
    message(SEND_ERROR "standard output is\n${stdout}\nexpected\n${expected_stdout}")
  endif()
endif()

if(EXISTS ${CASE}/expected.csv)
  file(STRINGS ${CASE}/tolerance tolerance)
  get_filename_component(name ${CASE} NAME)
  set(actual ${WORK}/${name}.csv)
  file(WRITE ${actual} "${stdout}")
  execute_process(COMMAND ${COMPARE_CSV} ${CASE}/expected.csv ${actual} ${tolerance}
    RESULT_VARIABLE difference OUTPUT_VARIABLE report ERROR_VARIABLE report)
  if(NOT difference EQUAL 0)
    message(SEND_ERROR "${report}")
  endif()
endif()
