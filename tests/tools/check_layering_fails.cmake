# check_layering.cmake must refuse forbidden includes: a small tree with one of each kind.
#   cmake -DSCRIPT=<check_layering.cmake> -DWORK=<scratch> -P check_layering_fails.cmake
cmake_minimum_required(VERSION 3.25)

function(expect_refused file include)
  file(REMOVE_RECURSE ${WORK})
  foreach(i RANGE 1 30)  # the check wants to see a real tree
    file(WRITE ${WORK}/calc/file${i}.h "#pragma once\n")
  endforeach()
  file(WRITE ${WORK}/${file} "#include ${include}\n")
  execute_process(COMMAND ${CMAKE_COMMAND} -DROOT=${WORK} -P ${SCRIPT}
    RESULT_VARIABLE result OUTPUT_QUIET ERROR_QUIET)
  if(result EQUAL 0)
    message(SEND_ERROR "${file} may include ${include}")
  endif()
endfunction()

expect_refused(calc/a.cpp "\"rules/judge.h\"")
expect_refused(calc/scene/a.cpp "\"calc/radiosity/solve.h\"")
expect_refused(calc/scene/a.cpp "\"calc/planner/predicates.h\"")
expect_refused(calc/planner/predicates.cpp "\"calc/radiosity/rays.h\"")
expect_refused(rules/a.cpp "\"calc/radiosity/rays.h\"")
expect_refused(report/a.cpp "\"calc/planner/scene_plan.h\"")
expect_refused(rules/a.h "\"report/document.h\"")
expect_refused(report/a.cpp "\"report/cli/options.h\"")
expect_refused(report/a.cpp "\"gpu/gl_gatherer.h\"")
expect_refused(gpu/a.cpp "\"rules/judge.h\"")
expect_refused(calc/radiosity/solve.cpp "<embree3/rtcore.h>")
expect_refused(report/cli/run.cpp "<CLI/CLI.hpp>")
expect_refused(report/cli/run.cpp "\"run.h\"")
