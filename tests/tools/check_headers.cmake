# Every header compiles alone: one source per header that includes nothing else. A header that leans on what
# others include breaks the build of this target. Included by tests/cli_tests.cmake.
file(GLOB_RECURSE luxgate_headers RELATIVE ${CMAKE_SOURCE_DIR} CONFIGURE_DEPENDS
  ${CMAKE_SOURCE_DIR}/calc/*.h ${CMAKE_SOURCE_DIR}/rules/*.h
  ${CMAKE_SOURCE_DIR}/report/*.h ${CMAKE_SOURCE_DIR}/gpu/*.h)

set(header_sources "")
foreach(header IN LISTS luxgate_headers)
  string(MAKE_C_IDENTIFIER ${header} stem)
  set(source ${CMAKE_CURRENT_BINARY_DIR}/headers_alone/${stem}.cpp)
  file(CONFIGURE OUTPUT ${source} CONTENT "#include \"${header}\"\n")
  list(APPEND header_sources ${source})
endforeach()

add_library(headers_compile_alone OBJECT ${header_sources})
target_link_libraries(headers_compile_alone PRIVATE luxgate_cli)
target_compile_options(headers_compile_alone PRIVATE -O0)
