luxgate_test(proofs_tests
  SOURCES
    differential/plan_and_solve_test.cpp
    unit/calc/proofs/beam_test.cpp
    unit/calc/proofs/convex_space_test.cpp
    unit/calc/forecast/cost_model_test.cpp
    unit/calc/forecast/device_cost_test.cpp
    unit/calc/forecast/drawing_cost_test.cpp
    unit/calc/forecast/memory_need_test.cpp
    unit/calc/proofs/predicates_test.cpp
    unit/calc/forecast/scene_plan_test.cpp
  LIBRARIES calc_radiosity)
