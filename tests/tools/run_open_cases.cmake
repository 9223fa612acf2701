# The open validation cases: the kept text is what validation_report writes. Their tables are not part of this tree,
# LUXGATE_SHARED_DATA names the folder that holds them; without it the test is skipped.
#   cmake -DVALIDATION_REPORT=<binary> -DCOMPARE_REPORT=<binary> -DKEPT=<open-cases.md> -DWORK=<scratch>
#     -P run_open_cases.cmake
cmake_minimum_required(VERSION 3.25)

if(NOT EXISTS "$ENV{LUXGATE_SHARED_DATA}/validation/cases.csv")
  message("skipped: LUXGATE_SHARED_DATA names no folder with validation/cases.csv")
  return()
endif()
file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK})
foreach(command "${VALIDATION_REPORT};open;${WORK}" "${COMPARE_REPORT};${WORK}/open-cases.md;${KEPT}")
  execute_process(COMMAND ${command} RESULT_VARIABLE code OUTPUT_VARIABLE out ERROR_VARIABLE err)
  if(NOT code EQUAL 0)
    message(FATAL_ERROR "${command}: ${code}\n${out}${err}")
  endif()
endforeach()
if(NOT EXISTS ${WORK}/open-cases.html)
  message(SEND_ERROR "open-cases.html was not written")
endif()
