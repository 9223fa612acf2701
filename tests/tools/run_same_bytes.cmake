# The number of threads must not show in any result.
#   cmake -DLUXGATE=<binary> -DPROJECT=<project.xml> -DWORK=<scratch> -P run_same_bytes.cmake
cmake_minimum_required(VERSION 3.25)

file(REMOVE_RECURSE ${WORK})
foreach(jobs 1 2 8)
  execute_process(COMMAND ${LUXGATE} check --quiet ${PROJECT} --jobs ${jobs} --output ${WORK}/${jobs}
            --pictures off  # run_pictures.cmake has them
    RESULT_VARIABLE exit_code ERROR_VARIABLE err)
  if(NOT exit_code EQUAL 0)
    message(FATAL_ERROR "--jobs ${jobs}: exit code ${exit_code}\n${err}")
  endif()
endforeach()
foreach(file results.csv points.csv result.json report.html)
  file(SHA256 ${WORK}/1/${file} one)
  foreach(jobs 2 8)
    file(SHA256 ${WORK}/${jobs}/${file} many)
    if(NOT many STREQUAL one)
      message(SEND_ERROR "${file} differs between --jobs 1 and --jobs ${jobs}")
    endif()
  endforeach()
endforeach()
