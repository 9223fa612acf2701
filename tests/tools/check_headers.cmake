# Every header compiles alone. A source that includes its own header first proves it for that header, so only the
# others get a source of their own that includes nothing else. A header that leans on what others include breaks
# the build. Included by tests/cli_tests.cmake.
file(GLOB_RECURSE luxgate_headers RELATIVE ${CMAKE_SOURCE_DIR} CONFIGURE_DEPENDS
  ${CMAKE_SOURCE_DIR}/calc/*.h ${CMAKE_SOURCE_DIR}/rules/*.h
  ${CMAKE_SOURCE_DIR}/report/*.h ${CMAKE_SOURCE_DIR}/gpu/*.h)

# Sets `result` to TRUE if the source of the same name is compiled with this header as its first include.
function(is_first_in_its_source header result)
  string(REGEX REPLACE "\\.h$" ".cpp" source ${CMAKE_SOURCE_DIR}/${header})
  set(${result} FALSE PARENT_SCOPE)
  if(EXISTS ${source})
    file(STRINGS ${source} first_include REGEX "^ *#" LIMIT_COUNT 1)
    if(first_include STREQUAL "#include \"${header}\"")
      set(${result} TRUE PARENT_SCOPE)
    endif()
  endif()
endfunction()

set(header_sources "")
foreach(header IN LISTS luxgate_headers)
  is_first_in_its_source(${header} is_proven)
  if(NOT is_proven)
    string(MAKE_C_IDENTIFIER ${header} stem)
    set(source ${CMAKE_CURRENT_BINARY_DIR}/headers_alone/${stem}.cpp)
    file(CONFIGURE OUTPUT ${source} CONTENT "#include \"${header}\"\n")
    list(APPEND header_sources ${source})
  endif()
endforeach()

add_library(headers_compile_alone OBJECT ${header_sources})
target_link_libraries(headers_compile_alone PRIVATE luxgate_cli)
target_compile_options(headers_compile_alone PRIVATE -O0)
