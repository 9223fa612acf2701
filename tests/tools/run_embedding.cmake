# Installs into an empty folder and builds examples/embed against that and nothing else.
#   cmake -DBUILD=... -DSOURCE=... -DGENERATOR=... -DCXX_FLAGS=... -DCOMPILER=... -DWORK=<scratch> -P run_embedding.cmake
cmake_minimum_required(VERSION 3.25)

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "${ARGN}\nended with ${result}:\n${output}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

file(REMOVE_RECURSE ${WORK})
file(COPY ${SOURCE}/examples/embed DESTINATION ${WORK})  # nothing of the tree beside it
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/prefix)
set(flags ${CXX_FLAGS})
if(SANITIZE)
  string(APPEND flags " -fsanitize=${SANITIZE}")
endif()
run(${CMAKE_COMMAND} -G ${GENERATOR} -S ${WORK}/embed -B ${WORK}/build -DCMAKE_PREFIX_PATH=${WORK}/prefix
  -DCMAKE_CXX_COMPILER=${COMPILER} "-DCMAKE_CXX_FLAGS=${flags}")
run(${CMAKE_COMMAND} --build ${WORK}/build)
run(${WORK}/build/embed ${SOURCE}/examples/04-office/project.xml)
foreach(expected "office/task-west: [0-9]+ points, average [0-9.]+ lx" "average: pass" "Uo .min/avg.: pass")
  if(NOT output MATCHES "${expected}")
    message(SEND_ERROR "'${expected}' is not in:\n${output}")
  endif()
endforeach()

# The installed program works, and finds nothing missing.
run(${WORK}/prefix/bin/luxgate check ${SOURCE}/examples/04-office/project.xml --quiet)
# No header of the command line, and none that leads out of the folder.
file(GLOB_RECURSE headers RELATIVE ${WORK}/prefix/include/luxgate ${WORK}/prefix/include/luxgate/*)
foreach(header IN LISTS headers)
  if(header MATCHES "^report/(shell|tools|cli|python)/")
    message(SEND_ERROR "${header} is installed")
  endif()
  file(STRINGS ${WORK}/prefix/include/luxgate/${header} includes REGEX "^#include \"")
  foreach(line IN LISTS includes)
    string(REGEX REPLACE "^#include \"(.*)\".*" "\\1" name "${line}")
    if(NOT EXISTS ${WORK}/prefix/include/luxgate/${name})
      message(SEND_ERROR "${header}: ${name} is not installed")
    endif()
  endforeach()
endforeach()
