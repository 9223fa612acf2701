# --goal verdict stops where the verdicts are decided, --goal accuracy where the intervals are narrow enough, and the
# reports say which it was.
#   cmake -DLUXGATE=<binary> -DPROJECT=<project.xml> -P run_goals.cmake
cmake_minimum_required(VERSION 3.25)

function(expect_stop goal stop)
  execute_process(COMMAND ${LUXGATE} check --format json ${PROJECT} ${ARGN} OUTPUT_VARIABLE json)
  string(JSON used GET "${json}" provenance goal)
  string(JSON found GET "${json}" projects 0 spaces 0 planes 0 stop)
  if(NOT used STREQUAL goal OR NOT found STREQUAL stop)
    message(SEND_ERROR "${ARGN}: goal ${used}, stop ${found}; expected ${goal}, ${stop}")
  endif()
endfunction()

expect_stop(verdict decided)
expect_stop(verdict decided --goal verdict --tolerance 0.000001)
expect_stop(accuracy accurate --goal accuracy --tolerance 5%)
expect_stop(accuracy path-limit --goal accuracy --tolerance 0.000001 --max-paths 1024)
