# Several requirements as one: aggregates and classes of rule packs, judged and reported.
luxgate_test(aggregate_tests
  SOURCES
    unit/report/formats/aggregates_test.cpp
    unit/report/result_file/corpus_results_test.cpp
    unit/rules/verdict/aggregate_corpus_test.cpp
    unit/rules/verdict/judge_aggregates_test.cpp
  LIBRARIES report nlohmann_json::nlohmann_json pugixml::pugixml)
target_compile_definitions(aggregate_tests PRIVATE
  LUXGATE_RULES_CORPUS="${CMAKE_CURRENT_SOURCE_DIR}/rules_corpus")
