# Benchmarks print ratios; they are never timed tests. ctest only sees that they run.
add_executable(bench_check bench/bench_check.cpp)
target_link_libraries(bench_check PRIVATE calc_radiosity rules TBB::tbb)
add_test(NAME bench_check_runs COMMAND bench_check ${CMAKE_SOURCE_DIR}/examples/03-cornell-box/project.xml 0.2)

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
  bench/photometry.cpp
  bench/project_file.cpp
  bench/ratios.cpp
  bench/ray_limit.cpp
  bench/room_model.cpp
  bench/scaling.cpp
  bench/scenes.cpp
  bench/smoke.cpp
  bench/stiff.cpp
  bench/table.cpp
  bench/truth.cpp
  bench/verdicts.cpp)
target_link_libraries(bench_core PRIVATE calc_radiosity rules TBB::tbb)
add_test(NAME bench_core_runs COMMAND bench_core smoke)

# Ratios for a look at every change: against the ray tracer alone, instant radiosity and path tracing.
add_custom_target(bench_ratios
  COMMAND bench_core ratios office corridor --min-paths 256 --max-paths 1024 --reference-paths 16384
  USES_TERMINAL)
