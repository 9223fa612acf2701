luxgate_test(rules_tests
  SOURCES
    statistical/metric_coverage_test.cpp
    statistical/stop_rule_test.cpp
    unit/calc/statistics_test.cpp
    unit/rules/bind_test.cpp
    unit/rules/candidates_test.cpp
    unit/rules/combine_test.cpp
    unit/rules/compare_test.cpp
    unit/rules/judge_test.cpp
    unit/rules/metrics_test.cpp
    unit/rules/replicate_sample_test.cpp
    unit/rules/requirement_test.cpp
    unit/rules/rule_pack_test.cpp
    unit/rules/stop_rule_test.cpp
  LIBRARIES rules)
