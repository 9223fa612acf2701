luxgate_test(radiosity_tests
  SOURCES
    analytic/box_radiosity_test.cpp
    analytic/closed_room_flux_test.cpp
    analytic/extreme_geometry_test.cpp
    analytic/extreme_light_test.cpp
    analytic/integrating_sphere_test.cpp
    analytic/inverse_square_cosine_test.cpp
    analytic/lambert_area_source_test.cpp
    differential/gatherer_test.cpp
    differential/same_bits_test.cpp
    statistical/coverage_test.cpp
    unit/calc/radiosity/emission_test.cpp
    unit/calc/radiosity/low_discrepancy_test.cpp
    unit/calc/radiosity/near_field_test.cpp
    unit/calc/radiosity/rays_test.cpp
    unit/calc/radiosity/settings_test.cpp
  LIBRARIES calc_radiosity)
