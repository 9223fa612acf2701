# What people are given: report/packages.
set(module_python "")
if(TARGET luxgate_python)
  set(module_python ${LUXGATE_MODULE_PYTHON})
endif()
add_test(NAME packages.files_and_archive COMMAND ${CMAKE_COMMAND}
  -DBUILD=${PROJECT_BINARY_DIR} -DSOURCE=${PROJECT_SOURCE_DIR} -DSANITIZE=${LUXGATE_SANITIZE} -DPYTHON=${module_python}
  -DWORK=${CMAKE_CURRENT_BINARY_DIR}/packages -P ${CMAKE_CURRENT_SOURCE_DIR}/tools/run_packages.cmake)
set_tests_properties(packages.files_and_archive PROPERTIES SKIP_REGULAR_EXPRESSION "skipped:" TIMEOUT 600)

# With packages that somebody built, and a mirror of Debian: minutes.
add_test(NAME packages.in_a_clean_root COMMAND bash -c
  "[[ -n \${LUXGATE_PACKAGES:-} ]] && exec \"$1\" \"$LUXGATE_PACKAGES\" \"$2\" || echo skipped: LUXGATE_PACKAGES names no folder of packages"
  packages ${CMAKE_CURRENT_SOURCE_DIR}/tools/packages_in_a_clean_root.sh ${CMAKE_CURRENT_BINARY_DIR}/clean_root)
set_tests_properties(packages.in_a_clean_root PROPERTIES SKIP_REGULAR_EXPRESSION "skipped:" TIMEOUT 1800)
