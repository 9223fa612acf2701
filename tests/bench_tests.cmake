# Benchmarks print ratios; they are never timed tests. ctest only sees that they run.
add_executable(bench_check bench/bench_check.cpp)
target_link_libraries(bench_check PRIVATE calc_radiosity rules TBB::tbb)
add_test(NAME bench_check_runs COMMAND bench_check ${CMAKE_SOURCE_DIR}/examples/03-cornell-box/project.xml 0.2)
