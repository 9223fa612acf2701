luxgate_test(planner_tests
  SOURCES
    unit/calc/planner/beam_test.cpp
    unit/calc/planner/convex_space_test.cpp
    unit/calc/planner/cost_model_test.cpp
    unit/calc/planner/predicates_test.cpp
    unit/calc/planner/scene_plan_test.cpp
  LIBRARIES calc_radiosity)
