# Rays alone: the same answers under every instruction set, and against Embree's own.
luxgate_test(rays_tests
  SOURCES
    differential/embree_test.cpp
    unit/calc/base/elementary_test.cpp
    unit/calc/rays/sight_test.cpp
    unit/calc/rays/triangle_hit_test.cpp
    unit/calc/rays/triangle_tree_test.cpp
  LIBRARIES calc_radiosity embree)
target_compile_definitions(rays_tests PRIVATE LUXGATE_EMBREE=${embree_VERSION_MAJOR})

# The names are those of calc/rays/instruction_set.cpp.
foreach(set sse2 ssse3 sse4.2 avx avx2 avx512)
  add_test(NAME rays.${set} COMMAND rays_tests --gtest_filter=TriangleTree.*)
  set_tests_properties(rays.${set} PROPERTIES ENVIRONMENT LUXGATE_ISA=${set}
    SKIP_REGULAR_EXPRESSION "no instruction set '${set}'")
endforeach()
