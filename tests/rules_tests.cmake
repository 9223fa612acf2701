luxgate_test(rules_tests
  SOURCES
    statistical/metric_coverage_test.cpp
    statistical/stop_rule_test.cpp
    unit/calc/statistics_test.cpp
    unit/rules/bind_test.cpp
    unit/rules/candidates_test.cpp
    unit/rules/combine_test.cpp
    unit/rules/compare_test.cpp
    unit/rules/evaluate_test.cpp
    unit/rules/expression_test.cpp
    unit/rules/import_rows_test.cpp
    unit/rules/judge_test.cpp
    unit/rules/mask_test.cpp
    unit/rules/metrics_test.cpp
    unit/rules/replicate_sample_test.cpp
    unit/rules/requirement_test.cpp
    unit/rules/rule_corpus_test.cpp
    unit/rules/rule_pack_test.cpp
    unit/rules/stop_rule_test.cpp
    unit/rules/worked_example_test.cpp
  LIBRARIES rules)
target_compile_definitions(rules_tests PRIVATE
  LUXGATE_WORKED_EXAMPLE="${CMAKE_CURRENT_SOURCE_DIR}/worked_example/demo.xml"
  LUXGATE_RULE_PACK_FILES="${CMAKE_CURRENT_SOURCE_DIR}/schema/rule_packs"
  LUXGATE_RULES_CORPUS="${CMAKE_CURRENT_SOURCE_DIR}/rules_corpus")
