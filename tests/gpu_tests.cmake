# OpenGL, on Mesa's software renderer where there is no other; label gpu.
luxgate_test(gpu_tests
  SOURCES
    differential/gpu_draws_test.cpp
    differential/gpu_gatherer_test.cpp
    unit/gpu/bvh_test.cpp
    unit/gpu/device_test.cpp
    unit/gpu/egl_context_test.cpp
    unit/gpu/exact_arithmetic_test.cpp
    unit/gpu/program_cache_test.cpp
  LIBRARIES gpu calc_radiosity TBB::tbb ${LUXGATE_EPOXY_LIBRARY})
target_include_directories(gpu_tests SYSTEM PRIVATE ${LUXGATE_EPOXY_INCLUDE_DIR})

# Differences and speed of both backends, project by project.
add_executable(bench_gpu bench/bench_gpu.cpp)
target_link_libraries(bench_gpu PRIVATE gpu calc_radiosity)

add_test(NAME cli.gpu_backend COMMAND ${CMAKE_COMMAND}
  -DLUXGATE=$<TARGET_FILE:luxgate> -DCOMPARE_CSV=$<TARGET_FILE:compare_csv>
  -DEXAMPLES=${PROJECT_SOURCE_DIR}/examples -DWORK=${CMAKE_CURRENT_BINARY_DIR}/gpu_backend
  -P ${CMAKE_CURRENT_SOURCE_DIR}/tools/run_gpu_backend.cmake)
set_tests_properties(cli.gpu_backend PROPERTIES LABELS gpu SKIP_REGULAR_EXPRESSION "skipped:")
