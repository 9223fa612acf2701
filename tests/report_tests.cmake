luxgate_test(report_tests
  SOURCES
    unit/report/build/build_evidence_test.cpp
    unit/report/text/base64_test.cpp
    unit/report/build/build_plan_marks_test.cpp
    unit/report/build/build_road_test.cpp
    unit/report/formats/luminaires_csv_test.cpp
    unit/report/formats/ci_formats_test.cpp
    unit/report/formats/console_test.cpp
    unit/report/formats/terminal_rooms_test.cpp
    unit/report/formats/csv_test.cpp
    unit/report/formats/dxf_test.cpp
    unit/report/document/document_test.cpp
    unit/report/document/luminaire_labels_test.cpp
    unit/report/document/luminaire_schedule_test.cpp
    unit/report/document/road_facts_test.cpp
    unit/report/document/looked_at_wall_test.cpp
    unit/report/document/room_areas_test.cpp
    unit/report/document/room_summary_test.cpp
    unit/report/document/row_uses_test.cpp
    unit/report/document/storeys_test.cpp
    unit/report/images/exr_test.cpp
    unit/report/formats/german_report_test.cpp
    unit/report/html/drawings/heatmap_svg_test.cpp
    unit/report/images/canvas_test.cpp
    unit/report/images/heatmap_test.cpp
    unit/report/images/stroke_font_test.cpp
    unit/report/images/tone_map_test.cpp
    unit/report/html/drawings/html_difference_test.cpp
    unit/report/html/room/html_levels_test.cpp
    unit/report/html/chapters/data_sheets_test.cpp
    unit/report/html/chapters/html_chapters_test.cpp
    unit/report/html/chapters/html_roads_test.cpp
    unit/report/html/chapters/html_storeys_test.cpp
    unit/report/html/page/html_footnotes_test.cpp
    unit/report/html/drawings/html_layout_test.cpp
    unit/report/html/drawings/html_plan_test.cpp
    unit/report/html/room/html_room_data_test.cpp
    unit/report/html/client/client_page_test.cpp
    unit/report/html/client/client_positions_test.cpp
    unit/report/html/page/html_test.cpp
    unit/report/html/drawings/isolux_test.cpp
    unit/report/html/drawings/label_places_test.cpp
    unit/report/result_file/json_test.cpp
    unit/report/text/folded_warnings_test.cpp
    unit/report/text/ifc_guid_test.cpp
    unit/report/text/number_format_test.cpp
    unit/report/text/pass_factor_test.cpp
    unit/report/html/page/print_pages_test.cpp
    unit/report/text/plain_text_test.cpp
    unit/report/text/notices_test.cpp
    unit/report/text/one_source_note_test.cpp
    unit/report/text/plane_names_test.cpp
    unit/report/text/sentences_test.cpp
    unit/report/html/drawings/plan_layout_test.cpp
    unit/report/html/drawings/shared_scale_test.cpp
    unit/report/images/png_test.cpp
    unit/report/images/polar_diagram_test.cpp
    unit/report/result_file/read_json_test.cpp
    unit/report/result_file/message_json_test.cpp
    unit/report/result_file/redact_test.cpp
    unit/report/result_file/result_schema_test.cpp
    unit/report/revision/revise_test.cpp
    unit/report/stream/format_writer_test.cpp
    unit/report/stream/json_list_test.cpp
    unit/report/stream/spill_test.cpp
    unit/report/stream/text_list_test.cpp
    unit/report/text/shell_words_test.cpp
    unit/report/text/svg_test.cpp
    unit/report/text/texts_test.cpp
    unit/report/formats/pdf_test.cpp
    unit/report/formats/standard_words_test.cpp
    unit/report/formats/warnings_test.cpp
    unit/report/formats/write_test.cpp
    unit/report/formats/kept_rows_test.cpp
    unit/report/formats/xlsx_test.cpp
  LIBRARIES report pugixml::pugixml PNG::PNG OpenEXR::OpenEXR nlohmann_json::nlohmann_json)
target_compile_definitions(report_tests PRIVATE LUXGATE_FORMAT_SAMPLES="${CMAKE_CURRENT_SOURCE_DIR}/unit/report/formats"
  LUXGATE_RESULT_SCHEMA="${PROJECT_SOURCE_DIR}/report/result_file/result.schema.json")

luxgate_test(luminaire_shares_tests SOURCES unit/report/build/build_luminaire_shares_test.cpp LIBRARIES report)

# JUnit XML has no official schema: ours holds the elements that CI systems are documented to read.
find_program(LUXGATE_XMLLINT xmllint)
if(LUXGATE_XMLLINT)
  add_test(NAME junit_schema COMMAND ${LUXGATE_XMLLINT} --noout --schema ${CMAKE_CURRENT_SOURCE_DIR}/schema/junit.xsd
    ${CMAKE_CURRENT_SOURCE_DIR}/unit/report/formats/expected.junit.xml)
else()
  add_test(NAME junit_schema COMMAND ${CMAKE_COMMAND} -E echo "skipped: xmllint is not installed")
  set_tests_properties(junit_schema PROPERTIES SKIP_REGULAR_EXPRESSION "skipped:")
endif()

# What results say of themselves, checked by somebody else's validator.
if(EXISTS /usr/lib/python3/dist-packages/jsonschema)
  add_test(NAME result_schema COMMAND ${CMAKE_COMMAND} -DLUXGATE=$<TARGET_FILE:luxgate>
    -DEXAMPLES=${PROJECT_SOURCE_DIR}/examples -DWORK=${CMAKE_CURRENT_BINARY_DIR}/result_schema
    -P ${CMAKE_CURRENT_SOURCE_DIR}/tools/run_result_schema.cmake)
  add_test(NAME sweep_schema COMMAND ${CMAKE_COMMAND} -DLUXGATE=$<TARGET_FILE:luxgate>
    -DEXAMPLES=${PROJECT_SOURCE_DIR}/examples -DWORK=${CMAKE_CURRENT_BINARY_DIR}/sweep_schema
    -P ${CMAKE_CURRENT_SOURCE_DIR}/tools/run_sweep_schema.cmake)
else()
  add_test(NAME result_schema COMMAND ${CMAKE_COMMAND} -E echo "skipped: python3-jsonschema is not installed")
  add_test(NAME sweep_schema COMMAND ${CMAKE_COMMAND} -E echo "skipped: python3-jsonschema is not installed")
  set_tests_properties(result_schema sweep_schema PROPERTIES SKIP_REGULAR_EXPRESSION "skipped:")
endif()

# Formats of CI systems against schemas that this tree does not have.
if(EXISTS /usr/lib/python3/dist-packages/jsonschema)
  add_test(NAME ci_schemas COMMAND ${CMAKE_COMMAND} -DLUXGATE=$<TARGET_FILE:luxgate>
    -DEXAMPLES=${PROJECT_SOURCE_DIR}/examples -DSAMPLES=${CMAKE_CURRENT_SOURCE_DIR}/unit/report/formats
    -DWORK=${CMAKE_CURRENT_BINARY_DIR}/ci_schemas -P ${CMAKE_CURRENT_SOURCE_DIR}/tools/run_ci_schemas.cmake)
else()
  add_test(NAME ci_schemas COMMAND ${CMAKE_COMMAND} -E echo "skipped: python3-jsonschema is not installed")
endif()
set_tests_properties(ci_schemas PROPERTIES SKIP_REGULAR_EXPRESSION "skipped:" TIMEOUT 300)

# Reports in a real browser: layout, contrast, heads and landmarks, sorting, printing, hostile names.
add_executable(make_reports tools/make_reports.cpp)
target_link_libraries(make_reports PRIVATE report fmt::fmt)
target_include_directories(make_reports PRIVATE ${PROJECT_SOURCE_DIR})
find_program(LUXGATE_BROWSER NAMES chromium chromium-browser google-chrome)
if(LUXGATE_BROWSER)
  add_test(NAME report_browser COMMAND ${CMAKE_COMMAND} -DBROWSER=${LUXGATE_BROWSER} -DMAKE=$<TARGET_FILE:make_reports>
    -DPROBE=${CMAKE_CURRENT_SOURCE_DIR}/tools/browser_probe.js -DWORK=${CMAKE_CURRENT_BINARY_DIR}/report_browser
    -P ${CMAKE_CURRENT_SOURCE_DIR}/tools/run_browser.cmake)
  set_tests_properties(report_browser PROPERTIES TIMEOUT 300)
  add_test(NAME report_axe COMMAND ${CMAKE_COMMAND} -DBROWSER=${LUXGATE_BROWSER} -DLUXGATE=$<TARGET_FILE:luxgate>
    -DMAKE=$<TARGET_FILE:make_reports> -DEXAMPLES=${PROJECT_SOURCE_DIR}/examples
    -DWORK=${CMAKE_CURRENT_BINARY_DIR}/report_axe -P ${CMAKE_CURRENT_SOURCE_DIR}/tools/run_axe.cmake)
  set_tests_properties(report_axe PROPERTIES TIMEOUT 600 SKIP_REGULAR_EXPRESSION "skipped:")
else()
  add_test(NAME report_browser COMMAND ${CMAKE_COMMAND} -E echo "skipped: chromium is not installed")
  set_tests_properties(report_browser PROPERTIES SKIP_REGULAR_EXPRESSION "skipped:")
endif()

add_test(NAME html_split COMMAND ${CMAKE_COMMAND} -DLUXGATE=$<TARGET_FILE:luxgate>
  -DPROJECT=${PROJECT_SOURCE_DIR}/examples/04-office/project.xml -DWORK=${CMAKE_CURRENT_BINARY_DIR}/html_split
  -P ${CMAKE_CURRENT_SOURCE_DIR}/tools/run_html_split.cmake)

add_test(NAME cli.redacted_reports COMMAND ${CMAKE_COMMAND} -DLUXGATE=$<TARGET_FILE:luxgate>
  -DEXAMPLE=${PROJECT_SOURCE_DIR}/examples/05-failing-corridor -DWORK=${CMAKE_CURRENT_BINARY_DIR}/redacted
  -P ${CMAKE_CURRENT_SOURCE_DIR}/tools/run_redacted.cmake)

# English that is left in reports of other languages, pages that are wider than their windows, and whether advice holds.
find_package(Python3 COMPONENTS Interpreter)
if(Python3_Interpreter_FOUND)
  set(translated_examples)
  foreach(example 04-office 05-failing-corridor 06-on-the-edge 09-office-by-row)
    list(APPEND translated_examples ${PROJECT_SOURCE_DIR}/examples/${example}/project.xml)
  endforeach()
  add_test(NAME english_left COMMAND ${Python3_EXECUTABLE} ${CMAKE_CURRENT_SOURCE_DIR}/tools/english_left.py
    $<TARGET_FILE:luxgate> ${CMAKE_CURRENT_BINARY_DIR}/english_left ${translated_examples})
  set_tests_properties(english_left PROPERTIES TIMEOUT 300)
  add_test(NAME cli.advise COMMAND ${Python3_EXECUTABLE} ${CMAKE_CURRENT_SOURCE_DIR}/tools/advise.py
    $<TARGET_FILE:luxgate> ${PROJECT_SOURCE_DIR}/examples ${CMAKE_CURRENT_BINARY_DIR}/advise)
  set_tests_properties(cli.advise PROPERTIES TIMEOUT 300)
  add_test(NAME cli.check_advice COMMAND ${Python3_EXECUTABLE} ${CMAKE_CURRENT_SOURCE_DIR}/tools/check_advice.py
    $<TARGET_FILE:luxgate> ${PROJECT_SOURCE_DIR}/examples ${CMAKE_CURRENT_BINARY_DIR}/check_advice)
  set_tests_properties(cli.check_advice PROPERTIES TIMEOUT 300)
  add_test(NAME cli.advise_places COMMAND ${Python3_EXECUTABLE} ${CMAKE_CURRENT_SOURCE_DIR}/tools/advise_places.py
    $<TARGET_FILE:luxgate> ${PROJECT_SOURCE_DIR}/examples ${CMAKE_CURRENT_BINARY_DIR}/advise_places)
  set_tests_properties(cli.advise_places PROPERTIES TIMEOUT 300)
  if(LUXGATE_BROWSER)
    add_test(NAME page_widths COMMAND ${Python3_EXECUTABLE} ${CMAKE_CURRENT_SOURCE_DIR}/tools/page_widths.py
      $<TARGET_FILE:luxgate> ${LUXGATE_BROWSER} ${PROJECT_SOURCE_DIR}/examples ${CMAKE_CURRENT_BINARY_DIR}/page_widths)
    set_tests_properties(page_widths PROPERTIES TIMEOUT 600)
  endif()
endif()
