# Benchmarks print ratios; they are never timed tests. ctest only sees that they run.
add_executable(bench_check bench/bench_check.cpp)
target_link_libraries(bench_check PRIVATE calc_radiosity rules TBB::tbb)
add_test(NAME bench_check_runs COMMAND bench_check ${CMAKE_SOURCE_DIR}/examples/03-cornell-box/project.xml 0.2)

# Rooms made in code, and tables: what the benchmarks share.
add_library(bench_scenes STATIC bench/photometry.cpp bench/room_model.cpp bench/scenes.cpp bench/table.cpp)
target_link_libraries(bench_scenes PUBLIC calc_radiosity fmt::fmt)

add_executable(bench_core
  bench/accuracy.cpp
  bench/bench_core.cpp
  bench/converge.cpp
  bench/coverage.cpp
  bench/files.cpp
  bench/measure.cpp
  bench/memory.cpp
  bench/near.cpp
  bench/openings.cpp
  bench/path_tracing.cpp
  bench/project_file.cpp
  bench/ratios.cpp
  bench/ray_limit.cpp
  bench/scaling.cpp
  bench/smoke.cpp
  bench/sparse.cpp
  bench/stiff.cpp
  bench/truth.cpp
  bench/verdicts.cpp)
luxgate_compile_together(bench_core)
target_link_libraries(bench_core PRIVATE bench_scenes calc_radiosity rules TBB::tbb)
add_test(NAME bench_core_runs COMMAND bench_core smoke)

# Ratios for a look at every change: against the ray tracer alone, instant radiosity and path tracing.
add_custom_target(bench_ratios
  COMMAND bench_core ratios office corridor --min-paths 256 --max-paths 1024 --reference-paths 16384
  COMMAND python3 ${CMAKE_CURRENT_SOURCE_DIR}/bench/report_cost.py $<TARGET_FILE:luxgate>
    ${CMAKE_SOURCE_DIR}/examples/05-failing-corridor/photometry/lambert_panel_600.ies
  USES_TERMINAL)
find_program(LUXGATE_PYTHON python3)
if(LUXGATE_PYTHON)
  # What is said of devices is what the model gives.
  add_test(NAME gpu_model_is_kept COMMAND ${LUXGATE_PYTHON} -B ${CMAKE_CURRENT_SOURCE_DIR}/bench/gpu_model.py --check)
  add_test(NAME bench_report_cost_runs COMMAND ${LUXGATE_PYTHON} ${CMAKE_CURRENT_SOURCE_DIR}/bench/report_cost.py
    $<TARGET_FILE:luxgate> ${CMAKE_SOURCE_DIR}/examples/05-failing-corridor/photometry/lambert_panel_600.ies 8)
  add_test(NAME bench_users_projects_run COMMAND ${LUXGATE_PYTHON}
    ${CMAKE_CURRENT_SOURCE_DIR}/bench/users_projects.py $<TARGET_FILE:luxgate> $<TARGET_FILE:luxgate> --quick)
  # A cluster that is made up: does the simulation keep what must hold, and see when it does not?
  add_test(NAME bench_simulate_cluster_is_right COMMAND ${LUXGATE_PYTHON} -B
    ${CMAKE_CURRENT_SOURCE_DIR}/bench/simulate_cluster.py --check ${CMAKE_CURRENT_SOURCE_DIR}/validation/scale.md)
  add_test(NAME validation.sparse_is_kept COMMAND ${LUXGATE_PYTHON} -B ${CMAKE_CURRENT_SOURCE_DIR}/tools/sparse_table.py
    $<TARGET_FILE:bench_core> ${CMAKE_CURRENT_SOURCE_DIR}/validation/sparse.md)
else()
  foreach(name bench_report_cost_runs bench_users_projects_run bench_simulate_cluster_is_right gpu_model_is_kept validation.sparse_is_kept)
    add_test(NAME ${name} COMMAND ${CMAKE_COMMAND} -E echo "skipped: python3 is not installed")
    set_tests_properties(${name} PROPERTIES SKIP_REGULAR_EXPRESSION "skipped:")
  endforeach()
endif()
