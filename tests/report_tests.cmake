luxgate_test(report_tests
  SOURCES
    unit/report/console_test.cpp
    unit/report/csv_test.cpp
    unit/report/document_test.cpp
    unit/report/exr_test.cpp
    unit/report/heatmap_test.cpp
    unit/report/html_test.cpp
    unit/report/json_test.cpp
    unit/report/number_format_test.cpp
    unit/report/plain_text_test.cpp
    unit/report/plan_layout_test.cpp
    unit/report/png_test.cpp
    unit/report/polar_diagram_test.cpp
    unit/report/write_test.cpp
  LIBRARIES report pugixml::pugixml PNG::PNG OpenEXR::OpenEXR nlohmann_json::nlohmann_json)
