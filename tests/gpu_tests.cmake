# OpenGL, on Mesa's software renderer where there is no other; label gpu.
luxgate_test(gpu_tests
  SOURCES
    differential/gpu_direct_test.cpp
    differential/gpu_draws_test.cpp
    differential/gpu_gatherer_test.cpp
    differential/gpu_hits_test.cpp
    differential/gpu_near_test.cpp
    differential/gpu_paths_test.cpp
    differential/gpu_stages_test.cpp
    differential/gpu_weights_test.cpp
    unit/gpu/scene/bvh_test.cpp
    unit/gpu/device/calibration_test.cpp
    unit/gpu/device/device_test.cpp
    unit/gpu/device/dispatch_pacer_test.cpp
    unit/gpu/device/driver_messages_test.cpp
    unit/gpu/device/egl_context_test.cpp
    unit/gpu/gather/exact_arithmetic_test.cpp
    unit/gpu/opengl/gl_buffer_test.cpp
    unit/gpu/opengl/borrowed_bytes_test.cpp
    unit/gpu/device/missing_device_test.cpp
    unit/gpu/rays/path_rounds_test.cpp
    unit/gpu/opengl/program_cache_test.cpp
    unit/gpu/scene/traversal_test.cpp
  LIBRARIES gpu calc_radiosity TBB::tbb ${LUXGATE_EPOXY_LIBRARY})
target_include_directories(gpu_tests SYSTEM PRIVATE ${LUXGATE_EPOXY_INCLUDE_DIR})

# Some of the tests again, with a look for memory that nobody gave back. Mesa 22.3 itself leaks none,
# so there is nothing to suppress. Skipped where the system does not let a process look at itself. Left
# out with glibc 2.39 (Ubuntu 24.04), which looks up the thread-local data of LeakSanitizer by calling
# LeakSanitizer's free(), which looks up its thread-local data, for ever.
execute_process(COMMAND getconf GNU_LIBC_VERSION OUTPUT_VARIABLE libc_version OUTPUT_STRIP_TRAILING_WHITESPACE)
if(NOT LUXGATE_SANITIZE AND NOT libc_version STREQUAL "glibc 2.39")
  add_executable(gpu_leaks $<TARGET_OBJECTS:gpu_tests>)
  target_link_libraries(gpu_leaks PRIVATE gpu calc_radiosity TBB::tbb ${LUXGATE_EPOXY_LIBRARY}
    GTest::gtest_main GTest::gmock)
  target_link_options(gpu_leaks PRIVATE -fsanitize=leak)
  add_test(NAME gpu_leaks COMMAND gpu_leaks
    --gtest_filter=GlDraws.Fail*:GlDraws.TakeNoE*:GlDraws.DoNotDepend*Cut*:GlDraws.DoNotTake*:GlDraws.End*:GlSolve.*Rooms:GlGatherer.Tells*:GlGatherer.Fails*:GlProgram*)
  set_tests_properties(gpu_leaks PROPERTIES LABELS gpu
    SKIP_REGULAR_EXPRESSION "LeakSanitizer has encountered a fatal error")
endif()

# Differences and speed of both backends, project by project.
add_executable(bench_gpu bench/bench_gpu.cpp)
target_link_libraries(bench_gpu PRIVATE gpu calc_radiosity)
add_executable(bench_gpu_stages bench/bench_gpu_stages.cpp bench/gl_clock.cpp)
target_include_directories(bench_gpu_stages SYSTEM PRIVATE ${LUXGATE_EPOXY_INCLUDE_DIR})
target_link_libraries(bench_gpu_stages PRIVATE
  gpu calc_radiosity TBB::tbb fmt::fmt ${LUXGATE_EPOXY_LIBRARY})
add_executable(bench_gpu_traversal bench/bench_gpu_traversal.cpp)
target_include_directories(bench_gpu_traversal SYSTEM PRIVATE ${LUXGATE_EPOXY_INCLUDE_DIR})
target_link_libraries(bench_gpu_traversal PRIVATE bench_scenes gpu calc_radiosity fmt::fmt ${LUXGATE_EPOXY_LIBRARY})
add_test(NAME bench_gpu_traversal_runs COMMAND bench_gpu_traversal 512 1 office)
set_tests_properties(bench_gpu_traversal_runs PROPERTIES LABELS gpu SKIP_REGULAR_EXPRESSION "no OpenGL:")

# What only a machine with a GPU can tell, in one call; ctest sees that it runs.
add_executable(gpu_figures bench/gpu_figures.cpp)
target_link_libraries(gpu_figures PRIVATE bench_scenes luxgate_cli)
add_test(NAME gpu_figures_runs COMMAND gpu_figures --quick --messages)
set_tests_properties(gpu_figures_runs PROPERTIES LABELS gpu SKIP_REGULAR_EXPRESSION "no OpenGL:")

add_test(NAME cli.gpu_backend COMMAND ${CMAKE_COMMAND}
  -DLUXGATE=$<TARGET_FILE:luxgate> -DCOMPARE_CSV=$<TARGET_FILE:compare_csv>
  -DEXAMPLES=${PROJECT_SOURCE_DIR}/examples -DWORK=${CMAKE_CURRENT_BINARY_DIR}/gpu_backend
  -P ${CMAKE_CURRENT_SOURCE_DIR}/tools/run_gpu_backend.cmake)
set_tests_properties(cli.gpu_backend PROPERTIES LABELS gpu SKIP_REGULAR_EXPRESSION "skipped:")

# Counts for gpu_model.py, which says what devices should take and why.
add_executable(gpu_model_counts bench/gpu_model_counts.cpp)
target_link_libraries(gpu_model_counts PRIVATE bench_scenes gpu calc_radiosity rules)
