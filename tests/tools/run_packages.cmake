# What needs no root: which files the Debian packages have, with which rights; the archive runs from a folder of any name.
#   cmake -DBUILD=<build folder> -DSOURCE=<tree> -DSANITIZE=<sanitizers or nothing> -DPYTHON=<of the module, or nothing>
#     -DWORK=<scratch> -P run_packages.cmake
# Says "skipped:" where Debian's tools are missing, or the build has sanitizers, whose libraries nobody is given.
cmake_minimum_required(VERSION 3.25)

if(SANITIZE)
  message("skipped: a build with sanitizers")
  return()
endif()
foreach(tool dpkg-deb dpkg-shlibdeps dpkg-query file)
  find_program(path_of_${tool} ${tool})
  if(NOT path_of_${tool})
    message("skipped: ${tool} is not installed")
    return()
  endif()
endforeach()

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "${ARGN}\nended with ${result}:\n${output}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()
function(expect_in text)
  foreach(part IN LISTS ARGN)
    if(NOT text MATCHES "${part}")
      message(SEND_ERROR "'${part}' is not in:\n${text}")
    endif()
  endforeach()
endfunction()
function(expect_none_in text)
  foreach(part IN LISTS ARGN)
    if(text MATCHES "([^\n]*${part}[^\n]*)")
      message(SEND_ERROR "'${CMAKE_MATCH_1}' should not be there")
    endif()
  endforeach()
endfunction()

file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK})
set(ENV{SOURCE_DATE_EPOCH} 1700000000)  # 14 November 2023
find_program(cpack cpack REQUIRED)

# Not compressed: it is the files that count here.
run(${cpack} --config ${BUILD}/CPackConfig.cmake -G DEB -B ${WORK}/deb -D CPACK_DEBIAN_COMPRESSION_TYPE=none)
file(GLOB program ${WORK}/deb/luxgate_*.deb)
file(GLOB development ${WORK}/deb/luxgate-dev_*.deb)
file(GLOB module ${WORK}/deb/python3-luxgate_*.deb)
file(GLOB all ${WORK}/deb/*.deb)
list(LENGTH all count)
set(expected_count 2)
if(PYTHON)
  set(expected_count 3)
endif()
if(NOT count EQUAL expected_count)
  message(FATAL_ERROR "${expected_count} packages are expected: ${all}")
endif()

run(dpkg-deb --contents ${program})
expect_in("${output}" "-rwxr-xr-x root/root +[0-9]+ 2023-11-14 [0-9:]+ ./usr/bin/luxgate\n"
  "-rw-r--r-- [^\n]* ./usr/share/luxgate/rules/en12464-1-2021.xml\n" " ./usr/share/luxgate/luxgate-project-1.xsd\n"
  " ./usr/share/luxgate/examples/04-office/project.xml\n" " ./usr/share/doc/luxgate/copyright\n"
  " ./usr/share/doc/luxgate/changelog.gz\n" " ./usr/share/doc/luxgate/changelog.Debian.gz\n"
  " ./usr/share/doc/luxgate/compiled-in/libglm-dev\n" " ./usr/share/lintian/overrides/luxgate\n")
expect_none_in("${output}" "python3" "/usr/include" "\\.a\n" "\\.cmake\n" "/LICENSE\n" "/run\n" "expected_exit" "^-.......w" "^-....w"
  "share/man/[^\n]*[^z/]\n")
run(dpkg-deb --contents ${development})
expect_in("${output}" " ./usr/include/luxgate/report/check/check_project.h\n" "/luxgate/libreport_check.a\n" "/cmake/luxgate/luxgateConfig.cmake\n"
  " ./usr/share/doc/luxgate-dev/copyright\n")
expect_none_in("${output}" "/usr/bin" "python3" "share/luxgate/" "/usr/include/luxgate/report/(shell|tools|cli|python|packages)/" "\\.cpp\n")

run(dpkg-deb --field ${program})
expect_in("${output}" "Package: luxgate\n" "Depends: [^\n]*libembree[34]-" "Depends: [^\n]*libgit2-1" "Suggests: [^\n]*chromium" "Section: science\n"
  "Description: checker")
expect_none_in("${output}" "Depends: [^\n]*(chromium|python|-dev)")
run(dpkg-deb --field ${development})
expect_in("${output}" "Package: luxgate-dev\n" "Section: libdevel\n")
# Every library that the static libraries are linked with comes along: what Debian calls the packages of the files named there.
file(GLOB_RECURSE targets ${WORK}/deb/_CPack_Packages/*/luxgateTargets.cmake)
if(targets STREQUAL "")
  message(FATAL_ERROR "no luxgateTargets.cmake")
endif()
file(READ ${targets} text)
string(REGEX MATCHALL "/[^;>\"]*\\.so" libraries "${text}")
list(REMOVE_DUPLICATES libraries)
execute_process(COMMAND dpkg-query --search ${libraries} OUTPUT_VARIABLE owners COMMAND_ERROR_IS_FATAL ANY)
foreach(library IN LISTS libraries)
  if(NOT "\n${owners}" MATCHES "\n([^:,\n]+)[^\n]*: ${library}\n")
    message(FATAL_ERROR "no package has ${library}")
  endif()
  set(owner ${CMAKE_MATCH_1})
  if(NOT output MATCHES "Depends: [^\n]*${owner}")
    message(SEND_ERROR "luxgate-dev is linked with ${library} and does not depend on ${owner}")
  endif()
endforeach()

# The Python module, unpacked elsewhere and run; it stands by itself, and only under the Python it is compiled for.
if(PYTHON)
  run(dpkg-deb --contents ${module})
  expect_in("${output}" " ./usr/lib/python3/dist-packages/luxgate/__init__.py\n" "/luxgate/__init__.pyi\n" "/luxgate/py.typed\n"
    "-rw-r--r-- root/root +[0-9]+ 2023-11-14 [0-9:]+ ./usr/lib/python3/dist-packages/luxgate/_luxgate.cpython-[^\n]*.so\n"
    " ./usr/share/doc/python3-luxgate/copyright\n" " ./usr/share/doc/python3-luxgate/compiled-in/pybind11-dev\n"
    " ./usr/share/doc/python3-luxgate/README.md\n" " ./usr/share/doc/python3-luxgate/examples/check.py\n")
  expect_none_in("${output}" "/usr/bin" "/usr/include" "doc/luxgate/" "__pycache__" "\\.a\n")
  run(${PYTHON} --version)
  if(NOT output MATCHES "Python 3\\.([0-9]+)")
    message(FATAL_ERROR "${PYTHON} says: ${output}")
  endif()
  set(least 3.${CMAKE_MATCH_1})
  math(EXPR next "${CMAKE_MATCH_1} + 1")
  run(dpkg-deb --field ${module})
  expect_in("${output}" "Section: python\n" "Depends: [^\n]*python3 .>= ${least}~.," "Depends: [^\n]*python3 .<< 3.${next}.,"
    "Depends: [^\n]*python3-numpy," "Depends: [^\n]*libembree[34]-")
  expect_none_in("${output}" "Depends: [^\n]*(luxgate|-dev|chromium)")
  run(dpkg-deb --extract ${module} ${WORK}/module)
  file(READ ${WORK}/module/usr/share/doc/python3-luxgate/README.md page)
  expect_in("${page}" "\\(examples/check.py\\)")
  expect_none_in("${page}" "\\(\\.\\./")
  run(env -i PYTHONPATH=${WORK}/module/usr/lib/python3/dist-packages ${PYTHON} -B
    ${WORK}/module/usr/share/doc/python3-luxgate/examples/check.py ${SOURCE}/examples/04-office/project.xml)
  expect_in("${output}" "project.xml: pass\n" "least [0-9.]+ lx at")
endif()

# The archive, unpacked elsewhere and run from a third folder with an empty environment.
run(${CMAKE_COMMAND} -DBUILD=${BUILD} -DOUT=${WORK}/out -P ${SOURCE}/report/packages/make_archive.cmake)
file(GLOB archive ${WORK}/out/luxgate-*.tar.gz)
if(output MATCHES "No archive: it is made on Debian 12")
  message("${output}")
  file(REMOVE_RECURSE ${WORK})
  return()
endif()
set(place "${WORK}/another place")
file(MAKE_DIRECTORY ${place} ${WORK}/here)
run(tar --extract --gzip --file ${archive} --directory ${place} --strip-components 1)
foreach(file share/luxgate/rules/en12464-1-2021.xml share/luxgate/luxgate-project-1.xsd share/luxgate/examples/04-office/project.xml
    share/doc/luxgate/LICENSE share/doc/luxgate/ARCHIVE.md share/doc/luxgate/libraries.csv share/doc/luxgate/licences/libgit2-1.5)
  if(NOT EXISTS ${place}/${file})
    message(SEND_ERROR "${file} is not in the archive")
  endif()
endforeach()
set(luxgate env -i ${place}/bin/luxgate)
function(expect_exit expected)
  execute_process(COMMAND ${luxgate} ${ARGN} WORKING_DIRECTORY ${WORK}/here RESULT_VARIABLE code OUTPUT_VARIABLE text ERROR_VARIABLE text)
  if(NOT code EQUAL expected)
    message(FATAL_ERROR "luxgate ${ARGN}: exit code ${code}, expected ${expected}\n${text}")
  endif()
endfunction()
expect_exit(0 --version)
expect_exit(0 init room)
expect_exit(0 check room/project.xml)
file(READ ${WORK}/here/room/project.xml text)
string(REPLACE "at-least=\"500\"" "at-least=\"50000\"" dark "${text}")
if(dark STREQUAL text)
  message(FATAL_ERROR "the first project asks for no 500 lx any more")
endif()
file(WRITE ${WORK}/here/room/dark.xml "${dark}")
expect_exit(1 check room/dark.xml)

# Its libraries are those beside it, and byte for byte the system's.
execute_process(COMMAND env -i LD_TRACE_LOADED_OBJECTS=1 ${place}/bin/luxgate OUTPUT_VARIABLE loaded COMMAND_ERROR_IS_FATAL ANY)
string(REPLACE "\n" ";" loaded "${loaded}")
foreach(line IN LISTS loaded)
  if(NOT line MATCHES "=> (.*) \\(")
    continue()
  endif()
  set(library "${CMAKE_MATCH_1}")  # the next comparison takes it away
  if(NOT library MATCHES "^${place}/" AND
      NOT library MATCHES "/(libc|libm|libdl|librt|libresolv|libpthread|libstdc\\+\\+|libgcc_s)\\.so")
    message(SEND_ERROR "from elsewhere: ${line}")
  endif()
endforeach()
file(GLOB libraries ${place}/lib/*)
foreach(library IN LISTS libraries)
  cmake_path(GET library FILENAME name)
  find_file(original_${name} ${name} PATHS /lib/x86_64-linux-gnu /usr/lib/x86_64-linux-gnu NO_DEFAULT_PATH REQUIRED)
  execute_process(COMMAND ${CMAKE_COMMAND} -E compare_files ${library} ${original_${name}} COMMAND_ERROR_IS_FATAL ANY)
endforeach()

# Packages take some hundred MB here.
file(REMOVE_RECURSE ${WORK})
