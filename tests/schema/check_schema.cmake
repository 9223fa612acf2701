# cmake -D SCHEMA=<xsd> -D CORPUS=<folder> -D VALID=<files, may have *> -D XMLLINT=... -P check_schema.cmake: these files are
# valid by the schema, and the corpus is what its file names say (the readers have the same test).
cmake_minimum_required(VERSION 3.25)

file(GLOB must_pass ${VALID} ${CORPUS}/valid-*.xml)
file(GLOB must_fail ${CORPUS}/invalid-*.xml)
list(LENGTH must_pass pass_count)
list(LENGTH must_fail fail_count)
if(pass_count LESS 5 OR fail_count LESS 15)
  message(FATAL_ERROR "corpus is missing: ${pass_count} valid and ${fail_count} invalid files")
endif()

foreach(file IN LISTS must_pass must_fail)
  execute_process(COMMAND ${XMLLINT} --noout --nonet --schema ${SCHEMA} ${file}
                  RESULT_VARIABLE result OUTPUT_VARIABLE text ERROR_VARIABLE text)
  if(file IN_LIST must_pass AND NOT result EQUAL 0)
    message(SEND_ERROR "${file} should be valid:\n${text}")
  elseif(file IN_LIST must_fail AND NOT (result EQUAL 1 OR result EQUAL 3))
    # 1: not well-formed, 3: not valid; anything else means that the schema itself or the call is broken
    message(SEND_ERROR "${file} should be invalid (xmllint gave ${result}):\n${text}")
  endif()
endforeach()
message(STATUS "${pass_count} valid and ${fail_count} invalid files")
