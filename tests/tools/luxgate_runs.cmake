# What scripts that run the real binary share.

# run_luxgate(<exit code> [ENV NAME=VALUE...] ARGS argument...): sets out and err.
function(run_luxgate expected)
  cmake_parse_arguments(ARG "" "" "ENV;ARGS" ${ARGN})
  execute_process(
    COMMAND ${CMAKE_COMMAND} -E env --unset=LUXGATE_GL_FAULT ${ARG_ENV} ${LUXGATE} ${ARG_ARGS}
    RESULT_VARIABLE code OUTPUT_VARIABLE stdout ERROR_VARIABLE stderr)
  if(NOT code STREQUAL expected)
    message(SEND_ERROR "${ARG_ENV} ${ARG_ARGS}: exit code ${code}, expected ${expected}\n${stdout}\n${stderr}")
  endif()
  set(out "${stdout}" PARENT_SCOPE)
  set(err "${stderr}" PARENT_SCOPE)
endfunction()

# run_in_work(<exit code> argument...): in the scratch folder ${WORK}, which is emptied by
# `clear_work()`; what follows an unexpected exit code is not worth running.
function(run_in_work expected)
  execute_process(COMMAND ${LUXGATE} ${ARGN} WORKING_DIRECTORY ${WORK}
    RESULT_VARIABLE code OUTPUT_VARIABLE stdout ERROR_VARIABLE stderr)
  if(NOT code STREQUAL expected)
    message(FATAL_ERROR "${ARGN}: exit code ${code}, expected ${expected}\n${stdout}${stderr}")
  endif()
  set(out "${stdout}" PARENT_SCOPE)
  set(err "${stderr}" PARENT_SCOPE)
endfunction()

function(clear_work)
  file(REMOVE_RECURSE ${WORK})
  file(MAKE_DIRECTORY ${WORK})
endfunction()

function(expect_in text part)
  string(FIND "${text}" "${part}" place)
  if(place EQUAL -1)
    message(SEND_ERROR "'${part}' is missing in\n${text}")
  endif()
endfunction()
