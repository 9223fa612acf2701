# What validation_report writes is the kept text: WHAT is open or sweeps. The tables of the open cases are not part of
# this tree, LUXGATE_SHARED_DATA names the folder that holds them; without it their test is skipped.
#   cmake -DVALIDATION_REPORT=<binary> -DWHAT=open|sweeps -DCOMPARE_REPORT=<binary> -DKEPT=<FILE.md> -DWORK=<scratch>
#     -P run_validation_report.cmake
cmake_minimum_required(VERSION 3.25)

if(WHAT STREQUAL "open" AND NOT EXISTS "$ENV{LUXGATE_SHARED_DATA}/validation/cases.csv")
  message("skipped: LUXGATE_SHARED_DATA names no folder with validation/cases.csv")
  return()
endif()
file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK})
cmake_path(GET KEPT STEM name)
foreach(command "${VALIDATION_REPORT};${WHAT};${WORK}" "${COMPARE_REPORT};${WORK}/${name}.md;${KEPT}")
  execute_process(COMMAND ${command} RESULT_VARIABLE code OUTPUT_VARIABLE out ERROR_VARIABLE err)
  if(NOT code EQUAL 0)
    message(FATAL_ERROR "${command}: ${code}\n${out}${err}")
  endif()
endforeach()
if(NOT EXISTS ${WORK}/${name}.html)
  message(SEND_ERROR "${name}.html was not written")
endif()
