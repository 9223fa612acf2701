# luxgate selftest: all cases are right, and the kept report is what it writes.
#   cmake -DLUXGATE=<binary> -DCOMPARE_REPORT=<binary> -DKEPT=<report.md> -DWORK=<scratch> -P run_selftest.cmake
cmake_minimum_required(VERSION 3.25)

file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK})

function(run expected_exit)
  execute_process(COMMAND ${ARGN} WORKING_DIRECTORY ${WORK}
    RESULT_VARIABLE exit_code OUTPUT_VARIABLE out ERROR_VARIABLE err)
  if(NOT exit_code STREQUAL expected_exit)
    message(FATAL_ERROR "${ARGN}: exit code ${exit_code}, expected ${expected_exit}\n${out}${err}")
  endif()
  set(out "${out}" PARENT_SCOPE)
  set(err "${err}" PARENT_SCOPE)
endfunction()

run(0 ${LUXGATE} selftest --report out)
run(0 ${COMPARE_REPORT} out/validation.md ${KEPT})
# Another count or word is no rounding.
file(READ ${WORK}/out/validation.md written)
function(expect_noticed from to)
  string(REGEX REPLACE "${from}" "${to}" changed "${written}")
  file(WRITE ${WORK}/changed.md "${changed}")
  run(1 ${COMPARE_REPORT} changed.md out/validation.md)
endfunction()
expect_noticed("([0-9]+) numbers, seed" "1\\1 numbers, seed")
expect_noticed("All are right" "All are wrong")
if(NOT EXISTS ${WORK}/out/validation.html)
  message(SEND_ERROR "validation.html was not written")
endif()

# The same bytes for any number of threads; a case alone gives the same numbers.
run(0 ${LUXGATE} selftest --only shadow --json)
set(first "${out}")
run(0 ${LUXGATE} selftest --only shadow --json --jobs 1)
if(NOT out STREQUAL first)
  message(SEND_ERROR "the selftest depends on the number of threads")
endif()
run(0 ${LUXGATE} selftest --only cie171-5.4 --list)
if(NOT out MATCHES "cie171-5.4" OR out MATCHES "cie171-5.2")
  message(SEND_ERROR "--list: ${out}")
endif()
run(2 ${LUXGATE} selftest --only cie)
if(NOT err MATCHES "cie171-5.2")
  message(SEND_ERROR "an unknown case is not explained: ${err}")
endif()
run(2 ${LUXGATE} selftest --list --json)
