luxgate_test(photometry_tests
  SOURCES
    unit/calc/photometry/eulumdat_test.cpp
    unit/calc/photometry/full_circle_test.cpp
    unit/calc/photometry/ies_lm63_test.cpp
    unit/calc/photometry/ies_opening_test.cpp
    unit/calc/photometry/ies_tilt_test.cpp
    unit/calc/photometry/ies_types_ab_test.cpp
    unit/calc/photometry/line_cursor_test.cpp
    unit/calc/photometry/number_stream_test.cpp
    unit/calc/photometry/photometry_file_test.cpp
    unit/calc/photometry/real_files_test.cpp
    unit/calc/photometry/sine_segment_test.cpp
    unit/calc/photometry/text_encoding_test.cpp
    unit/calc/photometry/web_sampling_test.cpp
    unit/calc/photometry/web_test.cpp
  LIBRARIES calc_model)
