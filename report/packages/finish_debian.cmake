# Run by CPack on the folders of which it makes Debian packages: what Debian's policy wants beside the installed files.
include(${CMAKE_CURRENT_LIST_DIR}/third_party.cmake)

string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)  # of SOURCE_DATE_EPOCH where it is set

foreach(component IN LISTS CPACK_COMPONENTS_ALL)
  string(TOUPPER ${component} upper)
  set(package ${CPACK_DEBIAN_${upper}_PACKAGE_NAME})
  set(root ${CPACK_TEMPORARY_DIRECTORY}/${component}/usr)
  if(NOT IS_DIRECTORY ${root})
    message(FATAL_ERROR "${root}: nothing was installed for ${package}")
  endif()
  set(documents ${root}/share/doc/${package})
  file(REMOVE ${documents}/LICENSE)  # `copyright` names the text that every Debian system has
  configure_file(${CMAKE_CURRENT_LIST_DIR}/copyright ${documents}/copyright COPYONLY)
  configure_file(${CPACK_LUXGATE_SOURCE}/CHANGELOG.md ${documents}/changelog COPYONLY)
  file(WRITE ${documents}/changelog.Debian
"${CPACK_PACKAGE_NAME} (${CPACK_PACKAGE_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE}) ${CPACK_LUXGATE_CODENAME}; urgency=medium

  * Built from its own source tree. What is new in luxgate: changelog.gz.

 -- ${CPACK_PACKAGE_CONTACT}  ${date}
")
  luxgate_packages_of(headers headers)
  if(component STREQUAL "python")
    luxgate_packages_of(python own_headers)
    list(APPEND headers ${own_headers})
    # Its page, with the script it names beside it.
    file(READ ${root}/share/doc/luxgate/python/README.md page)
    string(REPLACE "(../../examples/python/" "(examples/" page "${page}")
    file(WRITE ${documents}/README.md "${page}")
    file(REMOVE_RECURSE ${root}/share/doc/luxgate)
    configure_file(${CPACK_LUXGATE_SOURCE}/examples/python/check.py ${documents}/examples/check.py COPYONLY)
  endif()
  luxgate_copy_notices(${documents}/compiled-in ${headers})
  configure_file(${CMAKE_CURRENT_LIST_DIR}/${package}.lintian-overrides ${root}/share/lintian/overrides/${package} COPYONLY)

  # What neither a program nor a linker needs, and what differs from build to build of the same sources.
  file(GLOB_RECURSE libraries ${root}/*.a)
  foreach(library IN LISTS libraries)
    execute_process(COMMAND strip --strip-debug --enable-deterministic-archives --remove-section=.comment ${library}
      COMMAND_ERROR_IS_FATAL ANY)
  endforeach()
  file(GLOB_RECURSE programs ${root}/bin/* ${root}/lib/python3/*.so)
  foreach(program IN LISTS programs)
    execute_process(COMMAND strip --remove-section=.comment --remove-section=.note ${program} COMMAND_ERROR_IS_FATAL ANY)
  endforeach()

  # gzip without name and date: the same text gives the same bytes.
  file(GLOB_RECURSE pages ${root}/share/man/*)
  list(FILTER pages EXCLUDE REGEX "\\.gz$")
  execute_process(COMMAND gzip -9nf ${documents}/changelog ${documents}/changelog.Debian ${pages}
    COMMAND_ERROR_IS_FATAL ANY)

  # Folders of which no file is installed.
  execute_process(COMMAND find ${root} -depth -type d -empty -delete COMMAND_ERROR_IS_FATAL ANY)
  luxgate_set_modes_and_dates(${CPACK_TEMPORARY_DIRECTORY}/${component})
endforeach()
