# --backend gpu through the real binary: same results as the CPU, same bytes again, clear errors.
#   cmake -DLUXGATE=<binary> -DCOMPARE_CSV=<binary> -DEXAMPLES=<folder> -DWORK=<scratch> -P run_gpu_backend.cmake
# Says "skipped:" where EGL knows no device at all.
cmake_minimum_required(VERSION 3.25)

include(${CMAKE_CURRENT_LIST_DIR}/luxgate_runs.cmake)

# Compiled shaders of this test alone.
file(REMOVE_RECURSE ${WORK}/programs)
set(ENV{LUXGATE_PROGRAM_CACHE} ${WORK}/programs)

execute_process(COMMAND ${LUXGATE} devices OUTPUT_VARIABLE devices RESULT_VARIABLE code)
if(devices MATCHES "^no OpenGL device: (.*)\n")
  message("skipped: ${CMAKE_MATCH_1}")
  return()
endif()
if(NOT code EQUAL 0)
  message(SEND_ERROR "no device is usable:\n${devices}")
endif()

run_luxgate(0 ARGS devices --json)
string(JSON index GET "${out}" devices 0 index)
string(JSON usable GET "${out}" devices 0 usable)
if(NOT index EQUAL 0 OR NOT usable MATCHES "^(ON|OFF)$")
  message(SEND_ERROR "devices --json is\n${out}")
endif()
run_luxgate(0 ARGS version --json)
string(JSON renderer GET "${out}" opengl_devices 0 renderer)

# The same work by both backends.
set(cornell ${EXAMPLES}/03-cornell-box/project.xml)
set(work check --quiet --max-paths 128 --goal accuracy --tolerance 0.1%)
file(MAKE_DIRECTORY ${WORK})
execute_process(COMMAND ${LUXGATE} ${work} ${cornell} --backend cpu --format points-csv=${WORK}/cpu.csv)
foreach(jobs 1 2 8)
  execute_process(COMMAND ${LUXGATE} ${work} ${cornell} --backend gpu --jobs ${jobs} --format points-csv=${WORK}/gpu${jobs}.csv)
  file(SHA256 ${WORK}/gpu${jobs}.csv hash${jobs})
  if(NOT hash${jobs} STREQUAL hash1)
    message(SEND_ERROR "--backend gpu --jobs ${jobs} gives other bytes than --jobs 1")
  endif()
endforeach()
# Light paths carry rounding on, and a vertex that changes places with its neighbour in the sorted
# pool is another draw of the same sum: a few values then differ by more than rounding.
execute_process(COMMAND ${COMPARE_CSV} ${WORK}/cpu.csv ${WORK}/gpu1.csv 2e-3
  RESULT_VARIABLE difference OUTPUT_VARIABLE report ERROR_VARIABLE report)
if(NOT difference EQUAL 0)
  message(SEND_ERROR "cpu and gpu differ: ${report}")
endif()
# Stage by stage.
foreach(stages direct-light light-paths connections near-field)
  execute_process(COMMAND ${LUXGATE} ${work} ${cornell} --backend gpu --gpu-stages ${stages} --format points-csv=${WORK}/${stages}.csv)
  set(tolerance 1e-4)
  if(stages STREQUAL "light-paths")
    set(tolerance 2e-3)
  endif()
  execute_process(COMMAND ${COMPARE_CSV} ${WORK}/cpu.csv ${WORK}/${stages}.csv ${tolerance}
    RESULT_VARIABLE difference OUTPUT_VARIABLE report ERROR_VARIABLE report)
  if(NOT difference EQUAL 0)
    message(SEND_ERROR "cpu and gpu differ in ${stages}: ${report}")
  endif()
endforeach()
run_luxgate(0 ARGS check ${cornell} --backend gpu --gpu-stages near-field,light-paths --format json)
expect_in("${out}" "): light-paths, near-field; cpu: ")
expect_in("${out}" "--backend gpu --gpu-stages light-paths,near-field")
run_luxgate(0 ARGS plan ${cornell} --backend gpu --gpu-stages near-field)
expect_in("${out}" "gpu stages: near-field")

# The same verdicts, whatever the kind of project: points, reflections, spots, a road, an escape route. The sums of all
# examples are GlSolve.GivesTheSameSumForEveryExample.
set(projects "")
foreach(example 01-one-luminaire 02-direct-and-indirect 04-office 05-failing-corridor 07-spot-and-wall-washer 13-escape-route 16-road)
  list(APPEND projects ${EXAMPLES}/${example}/project.xml)
endforeach()
foreach(backend cpu gpu)
  execute_process(COMMAND ${LUXGATE} check --quiet --no-config --max-paths 128 ${projects} --backend ${backend} --format csv
    OUTPUT_VARIABLE table RESULT_VARIABLE code_${backend})
  string(REGEX MATCHALL ",(pass|fail|undecided)," verdicts_${backend} "${table}")
endforeach()
if(NOT verdicts_cpu MATCHES "pass.*fail" OR NOT verdicts_cpu STREQUAL verdicts_gpu OR
   NOT code_cpu STREQUAL code_gpu)
  message(SEND_ERROR "verdicts of examples: ${code_cpu} ${verdicts_cpu}, ${code_gpu} ${verdicts_gpu}")
endif()

# Shaders were kept, and damaged files do not matter.
file(GLOB programs LIST_DIRECTORIES false ${WORK}/programs/*)
if(programs STREQUAL "" AND renderer MATCHES "llvmpipe")
  message(SEND_ERROR "no compiled shaders in ${WORK}/programs")
endif()
foreach(program IN LISTS programs)
  file(WRITE ${program} "damaged")
endforeach()
# One stage has few shaders: software OpenGL takes nine seconds to compile all of them.
file(SHA256 ${WORK}/connections.csv hash_of_stage)
foreach(folder ${WORK}/programs off /proc/none)
  run_luxgate(0 ENV LUXGATE_PROGRAM_CACHE=${folder}
    ARGS ${work} ${cornell} --backend gpu --gpu-stages connections --format points-csv=${WORK}/cached.csv)
  file(SHA256 ${WORK}/cached.csv hash)
  if(NOT hash STREQUAL hash_of_stage)
    message(SEND_ERROR "LUXGATE_PROGRAM_CACHE=${folder} changes results")
  endif()
endforeach()
file(REMOVE_RECURSE ${WORK}/cache)
run_luxgate(0 ENV LUXGATE_PROGRAM_CACHE= XDG_CACHE_HOME=${WORK}/cache
  ARGS check --quiet --max-paths 256 ${cornell} --backend gpu --gpu-stages connections)
file(GLOB programs_in_cache LIST_DIRECTORIES false ${WORK}/cache/luxgate/programs/*)
list(LENGTH programs kept)
if(kept GREATER 0 AND programs_in_cache STREQUAL "")
  message(SEND_ERROR "no compiled shaders in XDG_CACHE_HOME")
endif()

# What ran is written down; software is said to be software.
run_luxgate(0 ARGS check ${cornell} --backend gpu --format json)
expect_in("${out}" "\"backend\": \"gpu (")
expect_in("${out}" "--backend gpu")
if(NOT devices MATCHES "hardware")
  expect_in("${err}" "warning[backend-is-software]")
  run_luxgate(0 ARGS check ${cornell} --explain-cost)
  expect_in("${err}" "backend: cpu: ")
  run_luxgate(0 ARGS plan ${cornell})
  expect_in("${out}" "backend: cpu: ")
endif()

# Failures end in words and exit code 2, never in a run on the CPU.
function(expect_failure part)
  cmake_parse_arguments(ARG "" "" "ENV;ARGS" ${ARGN})
  run_luxgate(2 ENV ${ARG_ENV} ARGS check --quiet --format csv ${cornell} --backend gpu ${ARG_ARGS})
  expect_in("${err}" "${part}")
  if(out MATCHES ",(pass|fail|undecided),")
    message(SEND_ERROR "a verdict without a backend:\n${out}")
  endif()
endfunction()
expect_failure("the backend failed: the device is out of memory" ENV LUXGATE_GL_FAULT=out-of-memory)
expect_failure("the backend failed: the device was reset" ENV LUXGATE_GL_FAULT=context-lost)
foreach(stages direct-light light-paths connections near-field)
  expect_failure("the backend failed: the device was reset" ENV LUXGATE_GL_FAULT=context-lost
    ARGS --gpu-stages ${stages})
  expect_failure("the backend failed: the device has not answered" ENV LUXGATE_GL_FAULT=fence-lost
    ARGS --gpu-stages ${stages})
  expect_failure("the backend failed: the device did not finish its work" ENV LUXGATE_GL_FAULT=results-lost
    ARGS --gpu-stages ${stages})
endforeach()
expect_failure("04-office/project.xml: error[backend-failed]" ENV LUXGATE_GL_FAULT=context-lost
  ARGS ${EXAMPLES}/04-office/project.xml)
expect_failure("'gpu' cannot be used: there is no EGL library" ENV LUXGATE_GL_FAULT=no-egl)
expect_failure("'gpu' cannot be used: there is no OpenGL device 1000" ARGS --gl-device 1000)
expect_failure("LUXGATE_GL_FAULT, which is for tests, is 'other'" ENV LUXGATE_GL_FAULT=other)
run_luxgate(2 ENV LUXGATE_GL_FAULT=no-egl ARGS devices)
expect_in("${out}" "no OpenGL device: there is no EGL library")
if(renderer MATCHES "llvmpipe" AND NOT devices MATCHES "hardware")
  # What Mesa offers when told to be old, and EGL without any driver.
  expect_failure("OpenGL 3.3 has no compute shaders: 4.3 is needed" ENV MESA_GL_VERSION_OVERRIDE=3.3)
  expect_failure("EGL knows no device: __EGL_VENDOR_LIBRARY_FILENAMES leads it to no OpenGL driver"
    ENV __EGL_VENDOR_LIBRARY_FILENAMES=${WORK}/none.json)
endif()
