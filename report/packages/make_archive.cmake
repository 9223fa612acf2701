# Makes OUT/luxgate-VERSION-linux-PROCESSOR.tar.gz from a build: the program with the libraries that a bare Debian 12
# lacks, and what is installed with it. It runs from any folder. Made on Debian 12 alone: what runs there runs on all newer
# ones, and libraries.csv names its libraries.
#   cmake -DBUILD=<build folder> -DOUT=<folder> -P make_archive.cmake
# Ends with an error where a library is needed that libraries.csv does not name, or names as not to be given away.
cmake_minimum_required(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/third_party.cmake)

cmake_host_system_information(RESULT system QUERY DISTRIB_INFO)
if(NOT "${system_ID} ${system_VERSION_ID}" STREQUAL "debian 12")
  message("No archive: it is made on Debian 12, this is ${system_PRETTY_NAME}")
  return()
endif()
load_cache(${BUILD} READ_WITH_PREFIX cache_ CMAKE_PROJECT_VERSION CMAKE_STRIP)
cmake_host_system_information(RESULT processor QUERY OS_PLATFORM)
set(name luxgate-${cache_CMAKE_PROJECT_VERSION}-linux-${processor})
set(stage ${BUILD}/portable/${name})
set(program ${BUILD}/portable/bin/luxgate_portable)

file(REMOVE_RECURSE ${stage})
execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --component program --prefix ${stage}
  OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
file(COPY_FILE ${program} ${stage}/bin/luxgate)
execute_process(COMMAND ${cache_CMAKE_STRIP} ${stage}/bin/luxgate COMMAND_ERROR_IS_FATAL ANY)

# Sets package_of_FILE, the package that a file came with, for all files: dpkg takes as long for one as for a hundred. It
# knows a file by one of its two names where /lib is a link to /usr/lib.
function(find_packages_of)
  set(paths "")
  foreach(file IN LISTS ARGN)
    file(REAL_PATH ${file} real)
    string(REGEX REPLACE "^/usr/" "/" other ${real})
    list(APPEND paths ${real} ${other})
  endforeach()
  list(REMOVE_DUPLICATES paths)
  execute_process(COMMAND dpkg-query --search ${paths} OUTPUT_VARIABLE answer ERROR_QUIET)  # lines "PACKAGE:amd64: PATH"
  set(answer "\n${answer}")
  foreach(file IN LISTS ARGN)
    file(REAL_PATH ${file} real)
    string(REGEX REPLACE "^/usr/" "/" other ${real})
    set(found -1)
    foreach(path ${real} ${other})
      if(found LESS 0)
        string(FIND "${answer}" ": ${path}\n" found)
      endif()
    endforeach()
    if(found LESS 0)
      message(FATAL_ERROR "${file}: no Debian package has it, so its licence is not known")
    endif()
    string(SUBSTRING "${answer}" 0 ${found} before)
    string(REGEX REPLACE "^.*\n([^:,]+).*$" "\\1" package "${before}")
    set(package_of_${file} ${package} PARENT_SCOPE)
  endforeach()
endfunction()

luxgate_packages_of(headers headers)
luxgate_packages_of(archive allowed)
luxgate_packages_of(system system)
file(GET_RUNTIME_DEPENDENCIES EXECUTABLES ${program} RESOLVED_DEPENDENCIES_VAR libraries
  UNRESOLVED_DEPENDENCIES_VAR missing)
if(missing)
  message(FATAL_ERROR "Libraries that the program needs and this machine lacks: ${missing}")
endif()
list(SORT libraries)
set(packages "")
set(table "file,package,version,source,source_version\n")
find_packages_of(${libraries})
foreach(library IN LISTS libraries)
  set(package ${package_of_${library}})
  if(package IN_LIST system)
    continue()
  endif()
  if(NOT package IN_LIST allowed)
    message(FATAL_ERROR "${library} of ${package} is needed: look at its licence, and add the package to "
      "${CMAKE_CURRENT_LIST_DIR}/libraries.csv if it may be given away in the archive")
  endif()
  file(REAL_PATH ${library} real)
  cmake_path(GET library FILENAME file)
  configure_file(${real} ${stage}/lib/${file} COPYONLY)
  execute_process(COMMAND dpkg-query -W -f "\${Package},\${Version},\${source:Package},\${source:Version}" ${package}
    OUTPUT_VARIABLE row COMMAND_ERROR_IS_FATAL ANY)
  string(APPEND table "${file},${row}\n")
  list(APPEND packages ${package})
endforeach()
list(REMOVE_DUPLICATES packages)
set(documents ${stage}/share/doc/luxgate)
file(WRITE ${documents}/libraries.csv ${table})
configure_file(${CMAKE_CURRENT_LIST_DIR}/ARCHIVE.md ${documents}/ARCHIVE.md COPYONLY)
luxgate_copy_notices(${documents}/licences ${headers} ${packages})

luxgate_set_modes_and_dates(${stage})
file(MAKE_DIRECTORY ${OUT})
# Name, order, owner and date of all files are given: the same files give the same bytes.
execute_process(
  COMMAND tar --create --sort=name --owner=0 --group=0 --numeric-owner --format=gnu --directory ${BUILD}/portable ${name}
  COMMAND gzip -n OUTPUT_FILE ${OUT}/${name}.tar.gz COMMAND_ERROR_IS_FATAL ANY)
file(REMOVE_RECURSE ${stage})
message("${OUT}/${name}.tar.gz")
