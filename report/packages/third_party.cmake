# libraries.csv: which packages of Debian are in what we give away, with the licence under which they are there.
# Included by scripts of this folder.

# luxgate_packages_of(PLACE VARIABLE): names of all packages with this place (headers, python, archive, system).
function(luxgate_packages_of place variable)
  file(STRINGS ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/libraries.csv lines)
  set(names "")
  foreach(line IN LISTS lines)
    if(line MATCHES "^([^,]+),${place},")
      list(APPEND names ${CMAKE_MATCH_1})
    endif()
  endforeach()
  set(${variable} ${names} PARENT_SCOPE)
endfunction()

# luxgate_copy_notices(FOLDER PACKAGE...): FOLDER/PACKAGE is the copyright file that Debian installs with the package.
function(luxgate_copy_notices folder)
  foreach(package IN LISTS ARGN)
    set(notice /usr/share/doc/${package}/copyright)
    if(NOT EXISTS ${notice})
      message(FATAL_ERROR "${notice} is missing: the licence of ${package} must go along")
    endif()
    file(REAL_PATH ${notice} notice)  # packages of one source may share one file by a link
    file(MAKE_DIRECTORY ${folder})
    configure_file(${notice} ${folder}/${package} COPYONLY)
  endforeach()
endfunction()

# luxgate_set_modes_and_dates(FOLDER): folders and programs 0755, other files 0644, all of SOURCE_DATE_EPOCH where it is set.
function(luxgate_set_modes_and_dates folder)
  execute_process(COMMAND chmod -R u=rwX,go=rX ${folder} COMMAND_ERROR_IS_FATAL ANY)
  if(DEFINED ENV{SOURCE_DATE_EPOCH})
    execute_process(COMMAND find ${folder} -exec touch --no-dereference --date @$ENV{SOURCE_DATE_EPOCH} {} +
      COMMAND_ERROR_IS_FATAL ANY)
  endif()
endfunction()
