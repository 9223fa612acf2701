luxgate_test(scene_tests
  SOURCES
    unit/calc/meshes/mesh_check_test.cpp
    unit/calc/meshes/mesh_file_test.cpp
    unit/calc/meshes/mesh_gltf_test.cpp
    unit/calc/meshes/mesh_obj_test.cpp
    unit/calc/meshes/mesh_ply_test.cpp
    unit/calc/meshes/mesh_shells_test.cpp
    unit/calc/meshes/mesh_stl_test.cpp
    unit/calc/glare/field_glare_test.cpp
    unit/calc/glare/luminaires_seen_test.cpp
    unit/calc/glare/room_ugr_test.cpp
    unit/calc/glare/ugr_table_test.cpp
    unit/calc/road/r_table_test.cpp
    unit/calc/road/road_light_test.cpp
    unit/calc/scene/grid_aliasing_test.cpp
    unit/calc/scene/polygon_cut_test.cpp
    unit/calc/scene/polygon_mend_test.cpp
    unit/calc/scene/polygon_test.cpp
    unit/calc/scene/prepared_scene_test.cpp
    unit/calc/scene/route_grid_test.cpp
    unit/calc/scene/route_shape_test.cpp
    unit/calc/scene/sensor_grid_test.cpp
    unit/calc/scene/solids_test.cpp
    unit/calc/scene/surface_contact_test.cpp
    unit/calc/base/csv_test.cpp
    unit/calc/base/encoding_test.cpp
    unit/calc/base/file_kind_test.cpp
    unit/calc/base/element_table_test.cpp
    unit/calc/base/file_hash_test.cpp
    unit/calc/base/names_test.cpp
    unit/calc/base/file_reader_test.cpp
    unit/calc/base/real_path_test.cpp
    unit/calc/base/text_test.cpp
    unit/calc/project/about_xml_test.cpp
    unit/calc/project/objects/maintenance_plan_xml_test.cpp
    unit/calc/project/spaces/building_xml_test.cpp
    unit/calc/project/spaces/energy_xml_test.cpp
    unit/calc/project/reading/logo_test.cpp
    unit/calc/project/objects/frame_test.cpp
    unit/calc/project/spaces/gbxml_space_test.cpp
    unit/calc/project/spaces/mesh_room_test.cpp
    unit/calc/meshes/gbxml_test.cpp
    unit/calc/project/reading/luminaire_list_csv_test.cpp
    unit/calc/project/objects/luminaires_xml_test.cpp
    unit/calc/project/objects/objects_xml_test.cpp
    unit/calc/project/spaces/planes_xml_test.cpp
    unit/calc/scene/box_shelf_test.cpp
    unit/calc/scene/housing_mesh_test.cpp
    unit/calc/scene/housing_several_test.cpp
    unit/calc/scene/housing_test.cpp
    unit/calc/scene/joined_openings_test.cpp
    unit/calc/scene/opening_fit_test.cpp
    unit/calc/scene/plane_place_test.cpp
    unit/calc/project/reading/point_list_csv_test.cpp
    unit/calc/project/reading/project_files_test.cpp
    unit/calc/project/objects/project_photometry_test.cpp
    unit/calc/project/warnings/coincident_surfaces_test.cpp
    unit/calc/project/warnings/open_shells_test.cpp
    unit/calc/project/warnings/project_warnings_test.cpp
    unit/calc/project/project_xml_file_messages_test.cpp
    unit/calc/project/project_xml_library_messages_test.cpp
    unit/calc/project/project_xml_object_messages_test.cpp
    unit/calc/project/project_xml_plane_messages_test.cpp
    unit/calc/project/project_xml_test.cpp
    unit/calc/project/spaces/road_xml_test.cpp
    unit/calc/project/spaces/route_xml_test.cpp
    unit/calc/project/spaces/spaces_xml_test.cpp
    unit/calc/project/spaces/workplace_xml_test.cpp
    unit/calc/scene/zone_shapes_test.cpp
    unit/calc/base/diagnostics_test.cpp
    unit/calc/base/utf8_test.cpp
    unit/calc/base/xml_document_test.cpp
  LIBRARIES calc_model)

# The published schema against examples and corpus, by an independent validator.
find_program(LUXGATE_XMLLINT xmllint)
if(LUXGATE_XMLLINT)
  add_test(NAME project_schema
    COMMAND ${CMAKE_COMMAND} -D XMLLINT=${LUXGATE_XMLLINT}
            -D SCHEMA=${CMAKE_SOURCE_DIR}/calc/project/luxgate-project-1.xsd
            -D CORPUS=${CMAKE_CURRENT_SOURCE_DIR}/schema/corpus
            -D VALID=${CMAKE_SOURCE_DIR}/examples/*/project.xml
            -P ${CMAKE_CURRENT_SOURCE_DIR}/schema/check_schema.cmake)
  add_test(NAME rule_pack_schema
    COMMAND ${CMAKE_COMMAND} -D XMLLINT=${LUXGATE_XMLLINT}
            -D SCHEMA=${CMAKE_SOURCE_DIR}/rules/pack/luxgate-rules-1.xsd
            -D CORPUS=${CMAKE_CURRENT_SOURCE_DIR}/schema/rule_packs
            -D VALID=${CMAKE_SOURCE_DIR}/rules/packs/*.xml
            -P ${CMAKE_CURRENT_SOURCE_DIR}/schema/check_schema.cmake)
else()
  add_test(NAME project_schema COMMAND ${CMAKE_COMMAND} -E echo "skipped: xmllint is not installed")
  set_tests_properties(project_schema PROPERTIES SKIP_REGULAR_EXPRESSION "skipped:")
endif()
