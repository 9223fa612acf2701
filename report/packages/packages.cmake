# What is given to people: the Debian packages luxgate (the program), luxgate-dev (to embed it) and, where the module is
# built, python3-luxgate by CPack, and the program of the archive that runs from any folder. README.md beside this file
# says why it is so.
set(LUXGATE_PACKAGE_CONTACT "luxgate maintainers <luxgate@maintainers.invalid>" CACHE STRING
  "Who answers for packages: NAME <ADDRESS>")
set(LUXGATE_HOMEPAGE "" CACHE STRING "Address of the project in packages, or nothing")

# The program of the archive: it looks for its libraries beside itself. DT_RPATH and not DT_RUNPATH, because this one
# holds for libraries of libraries, too, so that these stay Debian's to the byte. Its file is not called luxgate before it
# is in the archive: 'ninja luxgate' would be this one and not the program.
add_executable(luxgate_portable ${PROJECT_SOURCE_DIR}/report/cli/main.cpp)
target_link_libraries(luxgate_portable PRIVATE luxgate_cli)
target_link_options(luxgate_portable PRIVATE LINKER:--disable-new-dtags)
set_target_properties(luxgate_portable PROPERTIES
  RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/portable/bin
  BUILD_WITH_INSTALL_RPATH ON INSTALL_RPATH "$ORIGIN/../lib")

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME luxgate)
set(CPACK_PACKAGE_VENDOR luxgate)
set(CPACK_PACKAGE_CONTACT ${LUXGATE_PACKAGE_CONTACT})
set(CPACK_PACKAGE_HOMEPAGE_URL ${LUXGATE_HOMEPAGE})
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_CURRENT_LIST_DIR}/finish_debian.cmake)
set(CPACK_LUXGATE_SOURCE ${PROJECT_SOURCE_DIR})  # for that script

set(CPACK_COMPONENTS_ALL program development)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
# A release of Debian or Ubuntu has packages of its own: the libraries that they name differ. An upgrade takes the next one's.
cmake_host_system_information(RESULT LUXGATE_SYSTEM QUERY DISTRIB_INFO)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1~${LUXGATE_SYSTEM_ID}${LUXGATE_SYSTEM_VERSION_ID})
set(CPACK_LUXGATE_CODENAME ${LUXGATE_SYSTEM_VERSION_CODENAME})
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
# As Debian has it: files may be read by all, nothing may be written by a group, whatever umask was in force.
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME luxgate)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
# Chromium prints PDFs, OpenGL draws pictures of rooms, CBC is the solver of `advise`; checks need none of them, and the
# first two are larger than all the rest.
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS "chromium, coinor-libcbc3.1 | coinor-libcbc3, libegl1, libopengl0, libgl1-mesa-dri")
# CPack puts the summary of the project before a description of its own, unless that is CMake's default.
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_NAME} built using CMake")
set(CPACK_COMPONENT_PROGRAM_DESCRIPTION
"checker of lighting designs against standards
Reads rooms, furniture, luminaires with their photometry and calculation
planes, calculates illuminance with confidence intervals, judges each
requirement and ends with an exit code for scripts and CI jobs. Verdicts are
pass, fail, undecided and not judged; reports are text, HTML, PDF, CSV, JSON,
JUnit and SARIF. Rule packs with numbers of standards are in the program.")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME luxgate-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SHLIBDEPS OFF)
# What luxgateConfig.cmake looks for, what the headers include and what the static libraries are linked with.
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
  libembree-dev libepoxy-dev libfmt-dev libglm-dev libopenexr-dev libpng-dev libpugixml-dev libsleef-dev
  libssl-dev libtbb-dev libtinygltf-dev libtinyobjloader-dev libzip-dev nlohmann-json3-dev zlib1g-dev)
list(JOIN CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS ", " CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SUGGESTS luxgate)
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION
"checker of lighting designs against standards, as a library
Headers, static libraries and the CMake package luxgate (luxgate::check),
with which a C++ program of its own reads, calculates and judges projects
without a command line.")

if(TARGET luxgate_python)
  list(APPEND CPACK_COMPONENTS_ALL python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-luxgate)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
  # As dh_python3 has it: the module is compiled for one version of Python, whose name is in its file's name.
  string(REGEX MATCH "[0-9]+$" next ${LUXGATE_MODULE_PYTHON_VERSION})
  math(EXPR next "${next} + 1")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
    "python3 (>= ${LUXGATE_MODULE_PYTHON_VERSION}~), python3 (<< 3.${next}), python3-numpy")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS luxgate)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA
    ${CMAKE_CURRENT_LIST_DIR}/python/postinst ${CMAKE_CURRENT_LIST_DIR}/python/prerm)
  set(CPACK_COMPONENT_PYTHON_DESCRIPTION
"checker of lighting designs against standards, as a Python module
Checks projects from scripts: the same calculation, verdicts and bits as the
program luxgate has, with numpy arrays of the points of calculation planes.
The program is not needed.")
endif()
include(CPack)
