# The store of looks: its files, its keys, and that it changes no byte of a result.
luxgate_test(store_tests
  SOURCES
    differential/store_test.cpp
    unit/calc/radiosity/looks/look_key_test.cpp
    unit/calc/radiosity/looks/stored_look_test.cpp
    unit/calc/store/entry_folder_test.cpp
    unit/calc/store/memory_store_test.cpp
    unit/report/tools/store/store_test.cpp
  LIBRARIES luxgate_cli)

add_test(NAME cli.store COMMAND bash ${CMAKE_CURRENT_SOURCE_DIR}/tools/run_store.sh $<TARGET_FILE:luxgate>
  ${PROJECT_SOURCE_DIR}/examples/04-office ${CMAKE_CURRENT_BINARY_DIR}/store 10)
