# Light vertices in files, path tracing from the points, and `luxgate converge`.
luxgate_test(converge_tests
  SOURCES
    unit/calc/radiosity/paths/path_tracing_test.cpp
    unit/calc/radiosity/looks/vertex_cache_test.cpp
    unit/report/tools/converge/converge_options_test.cpp
    unit/report/tools/converge/converge_reference_test.cpp
    unit/report/tools/converge/converge_formats_test.cpp
    unit/report/tools/converge/converge_statistics_test.cpp
  LIBRARIES luxgate_cli pugixml::pugixml nlohmann_json::nlohmann_json)

add_test(NAME cli.light_vertices_are_used_again COMMAND ${CMAKE_COMMAND}
  -DLUXGATE=$<TARGET_FILE:luxgate> -DEXAMPLE=${PROJECT_SOURCE_DIR}/examples/03-cornell-box
  -DWORK=${CMAKE_CURRENT_BINARY_DIR}/vpl -P ${CMAKE_CURRENT_SOURCE_DIR}/tools/run_vpl.cmake)
add_test(NAME cli.converge_measures COMMAND ${CMAKE_COMMAND}
  -DLUXGATE=$<TARGET_FILE:luxgate>
  -DPROJECT=${PROJECT_SOURCE_DIR}/examples/02-direct-and-indirect/project.xml
  -DWORK=${CMAKE_CURRENT_BINARY_DIR}/converge
  -P ${CMAKE_CURRENT_SOURCE_DIR}/tools/run_converge.cmake)
