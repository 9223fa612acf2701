# Results to the bit: on every instruction set, and against those that are kept. See numbers/README.md.
find_program(LUXGATE_QEMU_USER qemu-x86_64)

set(numbers_folder ${CMAKE_CURRENT_SOURCE_DIR}/numbers)
file(GLOB numbers_projects CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/examples/[0-9]*/*.xml ${numbers_folder}/*/project.xml)
list(FILTER numbers_projects EXCLUDE REGEX "/\\.[^/]*$")  # what 'luxgate import' keeps beside a project
# What it calculates is what 11, 13, 15 and 16 do, and it takes half a minute.
list(FILTER numbers_projects EXCLUDE REGEX "/19-school-tender/")
foreach(case far-away-in-millimetres quantities-of-planes ratings-and-power)
  list(APPEND numbers_projects ${CMAKE_CURRENT_SOURCE_DIR}/golden/${case}/project.xml)
endforeach()
set(numbers_list "")
foreach(project IN LISTS numbers_projects)
  get_filename_component(folder ${project} DIRECTORY)
  get_filename_component(name ${folder} NAME)
  get_filename_component(file ${project} NAME_WE)
  if(NOT file STREQUAL "project")
    string(APPEND name "-${file}")
  endif()
  # One emulated run of each kind of project is enough: they are thirty times slower.
  set(qemu "")
  if(LUXGATE_QEMU_USER AND name MATCHES "^(01-one-luminaire|05-failing-corridor|stiff)$")
    set(qemu -DQEMU=${LUXGATE_QEMU_USER})
  endif()
  string(APPEND numbers_list "${name} ${project}\n")
  add_test(NAME numbers.${name} COMMAND ${CMAKE_COMMAND}
    -DLUXGATE=$<TARGET_FILE:luxgate> -DPROJECT=${project} -DNAME=${name} -DKEPT=${numbers_folder}/kept.txt
    -DWORK=${CMAKE_CURRENT_BINARY_DIR}/numbers/${name} ${qemu}
    -P ${CMAKE_CURRENT_SOURCE_DIR}/tools/run_numbers.cmake)
endforeach()
file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/numbers_projects.txt "${numbers_list}")

add_executable(libm_bits tools/libm_bits.cpp)
add_test(NAME numbers.selftest COMMAND ${CMAKE_COMMAND}
  -DLUXGATE=$<TARGET_FILE:luxgate> -DLIBM_BITS=$<TARGET_FILE:libm_bits> -P ${CMAKE_CURRENT_SOURCE_DIR}/tools/run_numbers_selftest.cmake)

add_test(NAME tree.elementary_functions COMMAND ${CMAKE_COMMAND} -DROOT=${PROJECT_SOURCE_DIR}
  -P ${CMAKE_CURRENT_SOURCE_DIR}/tools/check_elementary.cmake)
add_test(NAME tree.citations COMMAND ${CMAKE_COMMAND} -DROOT=${PROJECT_SOURCE_DIR}
  -P ${CMAKE_CURRENT_SOURCE_DIR}/tools/check_citations.cmake)
add_test(NAME tree.citations_test_works COMMAND ${CMAKE_COMMAND}
  -DSCRIPT=${CMAKE_CURRENT_SOURCE_DIR}/tools/check_citations.cmake
  -DWORK=${CMAKE_CURRENT_BINARY_DIR}/citations
  -P ${CMAKE_CURRENT_SOURCE_DIR}/tools/check_citations_fails.cmake)
