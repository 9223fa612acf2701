# What git keeps at the top of the tree: the folders and files that are meant to be there, and no core dump or report.
#   cmake -DROOT=<source folder> -P check_top_level.cmake
cmake_minimum_required(VERSION 3.25)

set(allowed .ci .github .clang-format .clang-tidy .gitignore .pre-commit-hooks.yaml CHANGELOG.md CMakeLists.txt CMakePresets.json LICENSE README.md
  calc examples gpu report rules tests)
execute_process(COMMAND git -C ${ROOT} ls-files RESULT_VARIABLE failure OUTPUT_VARIABLE files ERROR_QUIET)
if(failure)
  message("skipped: '${ROOT}' is no git repository")  # an unpacked archive
  return()
endif()
string(REGEX REPLACE "(/[^\n]*)?\n" ";" names "${files}")
list(REMOVE_DUPLICATES names)
list(REMOVE_ITEM names ${allowed} "")
if(names)
  message(SEND_ERROR "git keeps at the top of the tree: ${names}")
endif()
