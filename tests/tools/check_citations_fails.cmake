# check_citations.cmake must refuse what leads nowhere, and nothing else: a small tree with one line of each kind.
#   cmake -DSCRIPT=<check_citations.cmake> -DWORK=<scratch> -P check_citations_fails.cmake
cmake_minimum_required(VERSION 3.25)

# file, what is written into it, and what was expected of the check
function(check file text expected)
  file(REMOVE_RECURSE ${WORK})
  foreach(i RANGE 1 30)  # the check wants to see a real tree
    file(WRITE ${WORK}/calc/file${i}.h "#pragma once\nvoid function${i}();\n")
  endforeach()
  file(WRITE ${WORK}/calc/CONVENTIONS.md "## Citation keys\n| key | source |\n|---|---|\n| Right95 | A |\n| RFC 1, RFC 2 | B |\n")
  file(WRITE ${WORK}/calc/radiosity/METHOD.md "# The method\n\n## 4. Four\n\n### 4.2 Two `file1.h`, `Class::function1()`\n")
  file(APPEND ${WORK}/${file} "${text}\n")
  execute_process(COMMAND ${CMAKE_COMMAND} -DROOT=${WORK} -P ${SCRIPT}
    RESULT_VARIABLE result OUTPUT_QUIET ERROR_QUIET)
  if(expected STREQUAL "refused" AND result EQUAL 0)
    message(SEND_ERROR "${file} may say: ${text}")
  elseif(expected STREQUAL "taken" AND NOT result EQUAL 0)
    message(SEND_ERROR "${file} may not say: ${text}")
  endif()
endfunction()

foreach(right IN ITEMS
    "// [Right95]" "// x [Right95, 3.2]\; y" "// [RFC 2: words]" "// [METHOD, 4.2]" "// [METHOD, 4\; Right95]" "int x = 0\;  // [Right95,\n// 5]"
    "// [point]: 1 = [Text]s" "// a[Wrong96]" "// \"[WRONG]\" lines" "const char* s = \"[Wrong96]\"\;" "const auto f = [Wrong96] {}\;"
    "// see calc/file1.h, file2.h" "#include \"calc/file99.h\"" "// [measured: 1]" "// 'lane' [method][point]")
  string(REPLACE "[Text]" "v[Text]" right "${right}")
  check(calc/a.cpp "${right}" taken)
endforeach()
foreach(wrong IN ITEMS
    "// [Wrong96]" "// [Right951]" "// [Right95\; Wrong96]" "// [Right95, Wrong96]" "// [RFC 3]" "// [Wrong\n// 1996]" "int x = 0\;  // of [Wrong96]"
    "// [METHOD, 5]" "// [METHOD, 4.3]" "// [METHOD]" "// [method 02, section 4]" "// see calc/file99.h" "// file99.cpp")
  check(calc/a.cpp "${wrong}" refused)
endforeach()
check(gpu/shaders/a.glsl "// [Wrong96]" refused)
check(rules/a.h "// [METHOD, 5]" refused)
check(report/a.cpp.in "// rules/a.h" refused)
check(calc/CONVENTIONS.md "`radiosity/solve.h`" refused)
check(calc/radiosity/METHOD.md "`file1.h`, `function99()`" refused)
check(calc/radiosity/METHOD.md "`rules/file1.h`" refused)
check(calc/radiosity/METHOD.md "[Wrong96]" refused)
