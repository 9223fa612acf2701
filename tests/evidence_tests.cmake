# luxgate selftest, compare and export: each from outside, and what they are made of.
luxgate_test(evidence_tests
  SOURCES
    unit/report/tools/export/export_test.cpp
    unit/report/tools/export/gltf_test.cpp
    unit/report/tools/export/ifc_results_test.cpp
    mutation/mutations_test.cpp
    unit/report/tools/selftest/selftest_test.cpp
    unit/report/tools/compare/value_table_test.cpp
    unit/report/tools/compare/comparison_test.cpp
  LIBRARIES luxgate_cli nlohmann_json::nlohmann_json)

# One run: every case is right, and the report in validation/ is what the program writes.
add_executable(compare_report tools/compare_report.cpp)
target_link_libraries(compare_report PRIVATE calc_model)
add_test(NAME cli.selftest_is_right COMMAND ${CMAKE_COMMAND}
  -DLUXGATE=$<TARGET_FILE:luxgate> -DCOMPARE_REPORT=$<TARGET_FILE:compare_report>
  -DKEPT=${CMAKE_CURRENT_SOURCE_DIR}/validation/report.md
  -DWORK=${CMAKE_CURRENT_BINARY_DIR}/selftest
  -P ${CMAKE_CURRENT_SOURCE_DIR}/tools/run_selftest.cmake)
set_tests_properties(cli.selftest_is_right PROPERTIES TIMEOUT 900)

# The rest of validation/: tables that are not part of the tree, and curves.
add_executable(validation_report
  validation/open_cases.cpp
  validation/open_grid.cpp
  validation/open_places.cpp
  validation/open_report.cpp
  validation/open_scalars.cpp
  validation/open_scene.cpp
  validation/open_sphere.cpp
  validation/open_tables.cpp
  validation/sweep.cpp
  validation/sweep_render.cpp
  validation/validation_report.cpp)
luxgate_compile_together(validation_report)
set_source_files_properties(validation/open_cases.cpp PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)  # its tolerances are its own
target_link_libraries(validation_report PRIVATE luxgate_cli)
foreach(what open_cases sweeps)
  string(REPLACE "_" "-" kept ${what})
  string(REPLACE "_cases" "" part ${what})
  add_test(NAME validation.${what}_are_kept COMMAND ${CMAKE_COMMAND}
    -DVALIDATION_REPORT=$<TARGET_FILE:validation_report> -DCOMPARE_REPORT=$<TARGET_FILE:compare_report>
    -DWHAT=${part} -DKEPT=${CMAKE_CURRENT_SOURCE_DIR}/validation/${kept}.md
    -DWORK=${CMAKE_CURRENT_BINARY_DIR}/${what}
    -P ${CMAKE_CURRENT_SOURCE_DIR}/tools/run_validation_report.cmake)
  set_tests_properties(validation.${what}_are_kept PROPERTIES TIMEOUT 900 SKIP_REGULAR_EXPRESSION "skipped:")
endforeach()

add_test(NAME cli.compare_says_what_differs COMMAND ${CMAKE_COMMAND}
  -DLUXGATE=$<TARGET_FILE:luxgate> -DEXAMPLE=${PROJECT_SOURCE_DIR}/examples/03-cornell-box
  -DRATINGS=${CMAKE_CURRENT_SOURCE_DIR}/golden/ratings-and-power
  -DWORK=${CMAKE_CURRENT_BINARY_DIR}/compare -P ${CMAKE_CURRENT_SOURCE_DIR}/tools/run_compare.cmake)
