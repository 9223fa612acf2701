luxgate_test(scene_tests
  SOURCES
    unit/calc/scene/mesh_check_test.cpp
    unit/calc/scene/mesh_file_test.cpp
    unit/calc/scene/mesh_gltf_test.cpp
    unit/calc/scene/mesh_obj_test.cpp
    unit/calc/scene/mesh_ply_test.cpp
    unit/calc/scene/mesh_stl_test.cpp
    unit/calc/scene/polygon_cut_test.cpp
    unit/calc/scene/polygon_test.cpp
    unit/calc/scene/prepared_scene_test.cpp
    unit/calc/scene/sensor_grid_test.cpp
    unit/calc/scene/solids_test.cpp
    unit/calc/file_hash_test.cpp
    unit/calc/scene/energy_xml_test.cpp
    unit/calc/scene/frame_test.cpp
    unit/calc/scene/gbxml_space_test.cpp
    unit/calc/scene/gbxml_test.cpp
    unit/calc/scene/luminaire_list_csv_test.cpp
    unit/calc/scene/luminaires_xml_test.cpp
    unit/calc/scene/objects_xml_test.cpp
    unit/calc/scene/planes_xml_test.cpp
    unit/calc/scene/opening_fit_test.cpp
    unit/calc/scene/point_list_csv_test.cpp
    unit/calc/scene/project_files_test.cpp
    unit/calc/scene/project_photometry_test.cpp
    unit/calc/scene/project_schema_test.cpp
    unit/calc/scene/project_xml_file_messages_test.cpp
    unit/calc/scene/project_xml_library_messages_test.cpp
    unit/calc/scene/project_xml_object_messages_test.cpp
    unit/calc/scene/project_xml_plane_messages_test.cpp
    unit/calc/scene/project_xml_test.cpp
    unit/calc/scene/spaces_xml_test.cpp
    unit/calc/scene/workplace_xml_test.cpp
    unit/calc/scene/zone_shapes_test.cpp
    unit/calc/utf8_test.cpp
    unit/calc/xml_document_test.cpp
  LIBRARIES calc_model)

# The published schema against examples and corpus, by an independent validator.
find_program(LUXGATE_XMLLINT xmllint)
if(LUXGATE_XMLLINT)
  add_test(NAME project_schema
    COMMAND ${CMAKE_COMMAND} -D XMLLINT=${LUXGATE_XMLLINT}
            -D SCHEMA=${CMAKE_SOURCE_DIR}/calc/scene/luxgate-project-1.xsd
            -D CORPUS=${CMAKE_CURRENT_SOURCE_DIR}/schema/corpus
            -D VALID=${CMAKE_SOURCE_DIR}/examples/*/project.xml
            -P ${CMAKE_CURRENT_SOURCE_DIR}/schema/check_schema.cmake)
  add_test(NAME rule_pack_schema
    COMMAND ${CMAKE_COMMAND} -D XMLLINT=${LUXGATE_XMLLINT}
            -D SCHEMA=${CMAKE_SOURCE_DIR}/rules/luxgate-rules-1.xsd
            -D CORPUS=${CMAKE_CURRENT_SOURCE_DIR}/schema/rule_packs
            -D VALID=${CMAKE_SOURCE_DIR}/rules/packs/*.xml
            -P ${CMAKE_CURRENT_SOURCE_DIR}/schema/check_schema.cmake)
else()
  add_test(NAME project_schema COMMAND ${CMAKE_COMMAND} -E echo "skipped: xmllint is not installed")
  set_tests_properties(project_schema PROPERTIES SKIP_REGULAR_EXPRESSION "skipped:")
endif()
