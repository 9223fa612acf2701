# OpenGL, on Mesa's software renderer where there is no other; label gpu.
luxgate_test(gpu_tests
  SOURCES
    differential/gpu_gatherer_test.cpp
    unit/gpu/bvh_test.cpp
    unit/gpu/egl_context_test.cpp
  LIBRARIES gpu calc_radiosity TBB::tbb)

# Differences and speed of both backends, project by project.
add_executable(bench_gpu bench/bench_gpu.cpp)
target_link_libraries(bench_gpu PRIVATE gpu calc_radiosity)
