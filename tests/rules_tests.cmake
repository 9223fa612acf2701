luxgate_test(rules_tests
  SOURCES
    statistical/metric_coverage_test.cpp
    unit/calc/statistics_test.cpp
    unit/rules/accuracy_test.cpp
    unit/rules/bind_test.cpp
    unit/rules/combine_test.cpp
    unit/rules/compare_test.cpp
    unit/rules/judge_test.cpp
    unit/rules/metrics_test.cpp
    unit/rules/replicate_sample_test.cpp
    unit/rules/requirement_test.cpp
    unit/rules/rule_pack_test.cpp
  LIBRARIES rules)
