# What OpenGL draws: shadow maps and pictures of rooms, on Mesa's software renderer where there is no other.
luxgate_test(picture_tests
  SOURCES
    differential/shadow_map_test.cpp
    unit/calc/radiosity/looks/cutaway_test.cpp
    unit/calc/radiosity/looks/surface_light_test.cpp
    unit/gpu/raster/picture_test.cpp
    unit/report/tools/pictures/room_pictures_test.cpp
    unit/report/images/room_picture_test.cpp
  LIBRARIES luxgate_cli gpu report calc_radiosity)

add_test(NAME cli.pictures COMMAND ${CMAKE_COMMAND}
  -DLUXGATE=$<TARGET_FILE:luxgate> -DEXAMPLES=${PROJECT_SOURCE_DIR}/examples
  -DWORK=${CMAKE_CURRENT_BINARY_DIR}/pictures
  -P ${CMAKE_CURRENT_SOURCE_DIR}/tools/run_pictures.cmake)
set_tests_properties(cli.pictures PROPERTIES LABELS gpu SKIP_REGULAR_EXPRESSION "skipped:")
