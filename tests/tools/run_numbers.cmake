# One project under every instruction set that the processor has, of luxgate, Embree and the C library: result.json
# and points.csv must be the same bytes, and the points those that are kept.
#   cmake -DLUXGATE=<binary> -DPROJECT=<project.xml> -DNAME=<name in the kept file> -DKEPT=<tests/numbers/kept.txt>
#         -DWORK=<scratch> [-DQEMU=<qemu-x86_64>] -P run_numbers.cmake
# With -DWRITE=ON the kept line is replaced: for a change that raises kNumbersVersion.
cmake_minimum_required(VERSION 3.25)

get_filename_component(folder ${PROJECT} DIRECTORY)
get_filename_component(file ${PROJECT} NAME)
set(arguments)  # as run_example.cmake
if(EXISTS ${folder}/arguments)
  file(STRINGS ${folder}/arguments arguments)
endif()

include(${CMAKE_CURRENT_LIST_DIR}/processors.cmake)

function(calculate where)
  file(REMOVE_RECURSE ${WORK}/${where})
  execute_process(
    COMMAND ${CMAKE_COMMAND} -E env ${ARGN} check ${file} ${arguments} --quiet --pictures off --output ${WORK}/${where}
    WORKING_DIRECTORY ${folder} RESULT_VARIABLE code OUTPUT_VARIABLE out ERROR_VARIABLE err)
  if(code STREQUAL 2 AND NOT EXISTS ${WORK}/${where}/result.json OR NOT code MATCHES "^[0-3]$")
    message(FATAL_ERROR "${where}: exit code ${code}\n${out}${err}")
  endif()
  foreach(kind result.json points.csv)
    file(SHA256 ${WORK}/${where}/${kind} hash)
    set(${kind} ${hash} PARENT_SCOPE)
  endforeach()
endfunction()

find_instruction_sets()
string(JSON numbers_version GET "${version}" numbers_version)

calculate(as-it-is --unset=LUXGATE_ISA --unset=GLIBC_TUNABLES ${LUXGATE})
set(json ${result.json})
set(points ${points.csv})
set(seen "")
string(JSON chosen GET "${version}" instruction_set)
foreach(isa IN LISTS instruction_sets)
  if(isa STREQUAL chosen)
    continue()  # that was it
  endif()
  calculate(${isa} ${as_${isa}} ${LUXGATE})
  list(APPEND seen ${isa})
  if(NOT result.json STREQUAL json OR NOT points.csv STREQUAL points)
    message(SEND_ERROR "${NAME}: other bytes under ${isa}; see ${WORK}")
  endif()
endforeach()
# Other processors, as far as an emulator is one: without SSSE3, without SSE4, without AVX, with all that AVX2 brings.
if(QEMU)
  foreach(processor Opteron_G1 core2duo Nehalem Haswell)
    calculate(${processor} ${QEMU} -cpu ${processor} ${LUXGATE})
    list(APPEND seen ${processor})
    if(NOT result.json STREQUAL json OR NOT points.csv STREQUAL points)
      message(SEND_ERROR "${NAME}: other bytes on ${processor}; see ${WORK}")
    endif()
  endforeach()
endif()
message(STATUS "${NAME}: ${points} under ${seen}")

file(STRINGS ${KEPT} lines)
list(FILTER lines EXCLUDE REGEX "^#")
list(GET lines 0 kept_version)
if(WRITE)
  list(REMOVE_AT lines 0)
  list(FILTER lines EXCLUDE REGEX "^${NAME} ")
  list(APPEND lines "${NAME} ${points}")
  list(SORT lines)
  file(STRINGS ${KEPT} comments REGEX "^#")
  list(JOIN comments "\n" comments)
  list(JOIN lines "\n" lines)
  file(WRITE ${KEPT} "${comments}\nnumbers version ${numbers_version}\n${lines}\n")
  return()
endif()
if(NOT kept_version STREQUAL "numbers version ${numbers_version}")
  message(FATAL_ERROR "the program says numbers version ${numbers_version}, ${KEPT} '${kept_version}'")
endif()
if(NOT "${NAME} ${points}" IN_LIST lines)
  message(FATAL_ERROR "${NAME}: points.csv has the hash ${points}, another than in ${KEPT}. If the numbers were meant "
    "to move: raise kNumbersVersion (once for each release), say 'changes numbers' in CHANGELOG.md, and write the file "
    "anew: tests/numbers/README.md.")
endif()
