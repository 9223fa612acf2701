# A plane's points must not depend on which other planes are computed, nor on their order.
#   cmake -DLUXGATE=<binary> -DFOLDER=<folder with all.xml and fewer.xml> -P run_plane_independence.cmake
# fewer.xml holds planes of all.xml, in another order. Every row of its points must be a row of all.xml's.
cmake_minimum_required(VERSION 3.25)

foreach(project all fewer)
  execute_process(COMMAND ${LUXGATE} check --quiet ${project}.xml --format points-csv
    WORKING_DIRECTORY ${FOLDER} RESULT_VARIABLE exit_code OUTPUT_VARIABLE csv ERROR_VARIABLE err)
  if(NOT exit_code EQUAL 0)
    message(FATAL_ERROR "${project}.xml: exit code ${exit_code}\n${err}")
  endif()
  string(REPLACE "${project}.xml" "project.xml" csv "${csv}")
  string(REGEX REPLACE "\r?\n" ";" rows_of_${project} "${csv}")
endforeach()

list(LENGTH rows_of_all all_count)
list(LENGTH rows_of_fewer fewer_count)
if(fewer_count LESS 10 OR NOT fewer_count LESS all_count)
  message(FATAL_ERROR "${fewer_count} of ${all_count} rows: the projects do not test what they should")
endif()
foreach(row IN LISTS rows_of_fewer)
  if(NOT row IN_LIST rows_of_all)
    message(SEND_ERROR "not among the rows of all.xml: ${row}")
  endif()
endforeach()
