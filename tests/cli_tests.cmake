# The program from outside: examples, golden cases, independence of threads and neighbours; and the tree's own rules.
luxgate_test(cli_tests
  SOURCES
    unit/report/build/build_test.cpp
    unit/report/check/backend_test.cpp
    unit/report/check/run_test.cpp
    unit/report/check/drawing_device_test.cpp
    unit/report/check/in_order_test.cpp
    unit/report/check/units_test.cpp
    unit/report/check/selection_test.cpp
    unit/report/check/package_changes_test.cpp
    unit/report/check/room_changes_test.cpp
    unit/report/check/scene_levels_test.cpp
    unit/report/check/set_values_test.cpp
    unit/report/shell/process/environment_test.cpp
    unit/report/shell/process/exit_code_test.cpp
    unit/report/shell/command/help_text_test.cpp
    unit/report/tools/advise/advice_json_test.cpp
    unit/report/advice/advised_levels_test.cpp
    unit/report/advice/level_solver_test.cpp
    unit/report/tools/geometry/geometry_test.cpp
    unit/report/tools/geometry/rimless_test.cpp
    unit/report/tools/import/dxf_design_test.cpp
    unit/report/tools/import/dxf_drawing_test.cpp
    unit/report/tools/import/dxf_pairs_test.cpp
    unit/report/tools/import/ifc_design_test.cpp
    unit/report/tools/import/ifc_import_test.cpp
    unit/report/tools/import/ifc_shape_test.cpp
    unit/report/tools/import/ifc_units_test.cpp
    unit/report/tools/import/import_kind_test.cpp
    unit/report/tools/import/import_map_test.cpp
    unit/report/tools/import/project_merge_test.cpp
    unit/report/tools/import/project_text_test.cpp
    unit/report/tools/import/step_text_test.cpp
    unit/report/tools/init/init_test.cpp
    unit/report/tools/submit/job_script_test.cpp
    unit/report/result_file/contradiction_test.cpp
    unit/report/shell/command/command_line_test.cpp
    unit/report/shell/output/outputs_test.cpp
    unit/report/shell/output/pdf_places_test.cpp
    unit/report/shell/options/project_folders_test.cpp
    unit/report/shell/options/project_options_test.cpp
    unit/report/shell/options/sandbox_test.cpp
    unit/report/shell/output/sheet_files_test.cpp
    unit/report/shell/output/warning_tally_test.cpp
    unit/report/tools/photometry/photometry_test.cpp
    unit/report/tools/rules/explain_test.cpp
    unit/report/tools/rules/find_rows_test.cpp
    unit/report/tools/sweep/sweep_test.cpp
  LIBRARIES luxgate_cli nlohmann_json::nlohmann_json)
target_compile_definitions(cli_tests PRIVATE LUXGATE_SWEEP_SCHEMA="${PROJECT_SOURCE_DIR}/report/tools/sweep/sweep.schema.json"
  LUXGATE_ADVICE_SCHEMA="${PROJECT_SOURCE_DIR}/report/tools/advise/advice.schema.json"
  LUXGATE_MANUAL="${PROJECT_SOURCE_DIR}/report/cli/manual/import.md")

add_executable(compare_csv tools/compare_csv.cpp)
target_link_libraries(compare_csv PRIVATE calc_model)

# Every folder in golden/ is a case. A new one is found at the next configure.
file(GLOB golden_cases CONFIGURE_DEPENDS LIST_DIRECTORIES true ${CMAKE_CURRENT_SOURCE_DIR}/golden/*)
foreach(case IN LISTS golden_cases)
  if(IS_DIRECTORY ${case})
    get_filename_component(name ${case} NAME)
    add_test(NAME golden.${name} COMMAND ${CMAKE_COMMAND}
      -DLUXGATE=$<TARGET_FILE:luxgate> -DCOMPARE_CSV=$<TARGET_FILE:compare_csv>
      -DCASE=${case} -DWORK=${CMAKE_CURRENT_BINARY_DIR}/golden
      -P ${CMAKE_CURRENT_SOURCE_DIR}/tools/run_golden.cmake)
  endif()
endforeach()

# examples/run builds the target 'luxgate' and runs this file: another program may not take the name.
if(CMAKE_GENERATOR STREQUAL "Ninja")
  add_test(NAME cli.the_target_is_the_program
    COMMAND ${CMAKE_MAKE_PROGRAM} -C ${PROJECT_BINARY_DIR} -t query luxgate)
  set_tests_properties(cli.the_target_is_the_program PROPERTIES PASS_REGULAR_EXPRESSION "[ \n]report/cli/luxgate\n")
endif()

add_test(NAME cli.results_are_read COMMAND ${CMAKE_COMMAND} -DLUXGATE=$<TARGET_FILE:luxgate>
  -DGOLDEN=${CMAKE_CURRENT_SOURCE_DIR}/golden -DWORK=${CMAKE_CURRENT_BINARY_DIR}/results_are_read
  -P ${CMAKE_CURRENT_SOURCE_DIR}/tools/run_results_are_read.cmake)

# Every numbered folder in examples/ is a test of its exit code; one without expected_exit fails.
file(GLOB examples CONFIGURE_DEPENDS LIST_DIRECTORIES true ${PROJECT_SOURCE_DIR}/examples/[0-9]*)
foreach(example IN LISTS examples)
  get_filename_component(name ${example} NAME)
  add_test(NAME example.${name} COMMAND ${CMAKE_COMMAND}
    -DLUXGATE=$<TARGET_FILE:luxgate> -DEXAMPLE=${example}
    -DWORK=${CMAKE_CURRENT_BINARY_DIR}/examples/${name}
    -P ${CMAKE_CURRENT_SOURCE_DIR}/tools/run_example.cmake)
endforeach()

add_test(NAME cli.same_bytes_for_any_jobs COMMAND ${CMAKE_COMMAND}
  -DLUXGATE=$<TARGET_FILE:luxgate> -DPROJECT=${PROJECT_SOURCE_DIR}/examples/04-office/project.xml
  -DWORK=${CMAKE_CURRENT_BINARY_DIR}/same_bytes
  -P ${CMAKE_CURRENT_SOURCE_DIR}/tools/run_same_bytes.cmake)

add_test(NAME cli.planes_do_not_touch_each_other COMMAND ${CMAKE_COMMAND}
  -DLUXGATE=$<TARGET_FILE:luxgate> -DFOLDER=${CMAKE_CURRENT_SOURCE_DIR}/plane_independence
  -P ${CMAKE_CURRENT_SOURCE_DIR}/tools/run_plane_independence.cmake)

add_test(NAME cli.init_project_passes COMMAND ${CMAKE_COMMAND}
  -DLUXGATE=$<TARGET_FILE:luxgate> -DWORK=${CMAKE_CURRENT_BINARY_DIR}/init
  -P ${CMAKE_CURRENT_SOURCE_DIR}/tools/run_init.cmake)

add_test(NAME cli.own_table_is_judged COMMAND ${CMAKE_COMMAND}
  -DLUXGATE=$<TARGET_FILE:luxgate> -DFOLDER=${CMAKE_CURRENT_SOURCE_DIR}/own_table
  -DWORK=${CMAKE_CURRENT_BINARY_DIR}/own_table
  -P ${CMAKE_CURRENT_SOURCE_DIR}/tools/run_own_table.cmake)

add_test(NAME cli.goals_stop_where_they_say COMMAND ${CMAKE_COMMAND}
  -DLUXGATE=$<TARGET_FILE:luxgate>
  -DPROJECT=${PROJECT_SOURCE_DIR}/examples/05-failing-corridor/project.xml
  -P ${CMAKE_CURRENT_SOURCE_DIR}/tools/run_goals.cmake)

add_test(NAME cli.interrupt_leaves_nothing COMMAND bash
  ${CMAKE_CURRENT_SOURCE_DIR}/tools/run_interrupt.sh $<TARGET_FILE:luxgate>
  ${PROJECT_SOURCE_DIR}/examples/04-office/project.xml ${CMAKE_CURRENT_BINARY_DIR}/interrupt)

# Revisions from outside: results of before, git revisions, and the jobs that examples/ci has for GitHub and GitLab.
luxgate_test(git_tests
  SOURCES
    unit/report/git/git_tree_reader_test.cpp
    unit/report/git/lfs_pointer_test.cpp
    unit/report/git/moved_files_test.cpp
  LIBRARIES luxgate_cli)
find_program(LUXGATE_PYTHON python3)
foreach(script completions tutorial selection config datasheets streams revision_gate revision_attacks revision_against ci_jobs watch streamed_reports batch_shards batch_engines sweep policy_attacks attacks budgets kills sandbox pdf dxf import_dxf levels xlsx readme_pictures one_source)
  if(LUXGATE_PYTHON)
    add_test(NAME cli.${script} COMMAND ${LUXGATE_PYTHON} -B ${CMAKE_CURRENT_SOURCE_DIR}/tools/${script}.py
      $<TARGET_FILE:luxgate> ${CMAKE_CURRENT_BINARY_DIR}/${script} ${PROJECT_SOURCE_DIR}/examples)
  else()
    add_test(NAME cli.${script} COMMAND ${CMAKE_COMMAND} -E echo "skipped: python3 is not installed")
  endif()
  set_tests_properties(cli.${script} PROPERTIES SKIP_REGULAR_EXPRESSION "skipped:" TIMEOUT 300)
endforeach()

# Runs the commands of the manual's pages and checks their links and the length of their sentences.
if(LUXGATE_PYTHON)
  add_test(NAME cli.manual COMMAND ${LUXGATE_PYTHON} -B ${CMAKE_CURRENT_SOURCE_DIR}/tools/tutorial.py
    $<TARGET_FILE:luxgate> ${CMAKE_CURRENT_BINARY_DIR}/manual ${PROJECT_SOURCE_DIR}/examples ${PROJECT_SOURCE_DIR}/report/cli/manual)
else()
  add_test(NAME cli.manual COMMAND ${CMAKE_COMMAND} -E echo "skipped: python3 is not installed")
endif()
set_tests_properties(cli.manual PROPERTIES SKIP_REGULAR_EXPRESSION "skipped:" TIMEOUT 300)

# Of results that other tests have left, too, if they ran.
if(LUXGATE_PYTHON)
  add_test(NAME cli.luminaire_totals COMMAND ${LUXGATE_PYTHON} -B ${CMAKE_CURRENT_SOURCE_DIR}/tools/luminaire_totals.py
    $<TARGET_FILE:luxgate> ${CMAKE_CURRENT_BINARY_DIR}/luminaire_totals ${PROJECT_SOURCE_DIR}/examples
    ${CMAKE_CURRENT_BINARY_DIR}/examples ${CMAKE_CURRENT_BINARY_DIR}/results_are_read)
  set(made_before cli.results_are_read)
  foreach(example IN LISTS examples)
    get_filename_component(name ${example} NAME)
    list(APPEND made_before example.${name})
  endforeach()
  set_tests_properties(cli.luminaire_totals PROPERTIES DEPENDS "${made_before}" TIMEOUT 120)
endif()

# The same, read by openpyxl, too.
if(LUXGATE_PYTHON AND EXISTS /usr/lib/python3/dist-packages/openpyxl)
  add_test(NAME cli.xlsx_openpyxl COMMAND /usr/bin/python3 -B ${CMAKE_CURRENT_SOURCE_DIR}/tools/xlsx.py
    $<TARGET_FILE:luxgate> ${CMAKE_CURRENT_BINARY_DIR}/xlsx_openpyxl ${PROJECT_SOURCE_DIR}/examples openpyxl)
else()
  add_test(NAME cli.xlsx_openpyxl COMMAND ${CMAKE_COMMAND} -E echo "skipped: python3-openpyxl is not installed")
endif()
set_tests_properties(cli.xlsx_openpyxl PROPERTIES SKIP_REGULAR_EXPRESSION "skipped:" TIMEOUT 300)

# Chromium lays out pages with other bytes now and then where the machine is busy; that is its own test to come.
set_tests_properties(cli.pdf PROPERTIES RUN_SERIAL ON)

# Small projects whose verdicts were worked out by hand.
if(LUXGATE_PYTHON)
  add_test(NAME cli.known_verdicts COMMAND ${LUXGATE_PYTHON} -B ${CMAKE_CURRENT_SOURCE_DIR}/known_verdicts/run.py
    $<TARGET_FILE:luxgate>)
else()
  add_test(NAME cli.known_verdicts COMMAND ${CMAKE_COMMAND} -E echo "skipped: python3 is not installed")
endif()
set_tests_properties(cli.known_verdicts PROPERTIES SKIP_REGULAR_EXPRESSION "skipped:" TIMEOUT 300)

add_test(NAME tree.top_level COMMAND ${CMAKE_COMMAND} -DROOT=${PROJECT_SOURCE_DIR}
  -P ${CMAKE_CURRENT_SOURCE_DIR}/tools/check_top_level.cmake)
set_tests_properties(tree.top_level PROPERTIES SKIP_REGULAR_EXPRESSION "skipped: ")
# The Python module, where it is built, with the Python that it is built for.
if(TARGET luxgate_python)
  add_test(NAME cli.python_module COMMAND ${CMAKE_COMMAND} -E env PYTHONPATH=${PROJECT_BINARY_DIR}/report/python
    ${LUXGATE_MODULE_PYTHON} -B ${CMAKE_CURRENT_SOURCE_DIR}/tools/python_module.py $<TARGET_FILE:luxgate>
    ${CMAKE_CURRENT_BINARY_DIR}/python_module ${PROJECT_SOURCE_DIR}/examples)
else()
  add_test(NAME cli.python_module COMMAND ${CMAKE_COMMAND} -E echo
    "skipped: the Python module is not built: it needs python3-dev, pybind11-dev and python3-numpy, and no sanitizer")
endif()
set_tests_properties(cli.python_module PROPERTIES SKIP_REGULAR_EXPRESSION "skipped:" TIMEOUT 300)

add_test(NAME tree.layering COMMAND ${CMAKE_COMMAND} -DROOT=${PROJECT_SOURCE_DIR}
  -P ${CMAKE_CURRENT_SOURCE_DIR}/tools/check_layering.cmake)
add_test(NAME tree.layering_test_works COMMAND ${CMAKE_COMMAND}
  -DSCRIPT=${CMAKE_CURRENT_SOURCE_DIR}/tools/check_layering.cmake
  -DWORK=${CMAKE_CURRENT_BINARY_DIR}/layering
  -P ${CMAKE_CURRENT_SOURCE_DIR}/tools/check_layering_fails.cmake)
include(tools/check_headers.cmake)
add_executable(check_includes tools/check_includes.cpp)
target_link_libraries(check_includes PRIVATE fmt::fmt)
add_test(NAME tree.includes COMMAND check_includes ${PROJECT_SOURCE_DIR} ${LUXGATE_PRECOMPILED})
add_test(NAME tree.includes_test_works COMMAND ${CMAKE_COMMAND} -DCHECK=$<TARGET_FILE:check_includes>
  -DWORK=${CMAKE_CURRENT_BINARY_DIR}/includes -P ${CMAKE_CURRENT_SOURCE_DIR}/tools/check_includes_fails.cmake)

# A program of its own, compiled against what `cmake --install` puts into an empty folder.
add_test(NAME install.embedding COMMAND ${CMAKE_COMMAND}
  -DBUILD=${PROJECT_BINARY_DIR} -DSOURCE=${PROJECT_SOURCE_DIR} -DGENERATOR=${CMAKE_GENERATOR}
  -DCXX_FLAGS=${CMAKE_CXX_FLAGS} -DSANITIZE=${LUXGATE_SANITIZE} -DCOMPILER=${CMAKE_CXX_COMPILER}
  -DWORK=${CMAKE_CURRENT_BINARY_DIR}/embedding -P ${CMAKE_CURRENT_SOURCE_DIR}/tools/run_embedding.cmake)
