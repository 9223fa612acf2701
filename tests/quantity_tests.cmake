# Quantities that the calculation and the rules make together.
luxgate_test(quantity_tests
  SOURCES
    analytic/glare_test.cpp
    analytic/modelling_test.cpp
    statistical/quantity_coverage_test.cpp
    statistical/stop_rule_test.cpp
  LIBRARIES calc_radiosity rules)
