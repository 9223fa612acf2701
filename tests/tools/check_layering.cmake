# Allowed directions between folders, read from the #include lines.
#   cmake -DROOT=<source folder> -P check_layering.cmake
# A folder may include itself and those before it in the list: so there is no circle. Besides, a verdict traces no ray
# (rules and documents know calc/rays and what stands on it not at all), proofs know no rays, and gpu no rules.
cmake_minimum_required(VERSION 3.25)

set(folders
  calc/base calc/store calc/rays calc/photometry calc/photometry/read calc/photometry/write calc/scene calc/glare calc/road calc/proofs calc/meshes
  calc/project/reading calc/project/objects calc/project/warnings calc/project/spaces calc/project
  calc/radiosity/terms calc/radiosity/sampling calc/radiosity/direct calc/radiosity/paths calc/radiosity/gather calc/radiosity/looks calc/radiosity
  calc/forecast
  rules/catalogue rules/pack rules/applicability rules/zones rules/measure rules/verdict rules/binding
  gpu
  report/document report/text report/stream report/revision report/policy report/build report/images report/html report/result_file report/formats report/check
  report/git report/advice
  report/shell/process report/shell/command report/shell/output report/shell/options report/shell
  report/tools/pictures report/tools/plan report/tools/check report/tools/compare report/tools/config report/tools/converge
  report/tools/devices report/tools/geometry report/tools/help report/tools/import report/tools/export report/tools/init report/tools/photometry
  report/tools/policy report/tools/report report/tools/rules report/tools/selftest report/tools/store report/tools/submit report/tools/sweep report/tools/advise report/tools/schema report/tools/validate
  report/tools/vpl report/tools/watch report/cli report/python)

set(needs_rays "^(calc/(rays|radiosity|forecast)|gpu|report/(check|advice|shell|tools/[a-z]+|cli|python))$")

# header pattern | the only files (pattern) that may include it
set(owned_libraries
  "embree[34]/|calc/rays/triangle_tree\\.cpp"
  "hwy/|calc/rays/[a-z_]+\\.cpp"
  "sleef|calc/base/elementary\\.cpp"
  "epoxy/egl|gpu/device/egl_context"
  "epoxy/|gpu/"
  "CLI/|report/shell/command/command_line\\.cpp"
  "git2|report/git/"
  "pybind11/|report/python/module\\.cpp"
  "httplib|report/tools/watch/report_server\\.cpp"
  "coin/|report/advice/coin_library"
  "tiny_obj_loader|calc/meshes/mesh_obj"
  "tiny_gltf|calc/meshes/mesh_gltf"
  "zlib\\.h|report/formats/xlsx_container\\.cpp"
  "png\\.h|report/"
  "OpenEXR/|report/")

# Rooms of a folder whose files include each other both ways are one floor.
macro(floor_of folder)
  string(REGEX REPLACE "^(gpu|report/html)/.*" "\\1" ${folder} ${${folder}})
endmacro()
# The folder that a room is part of.
function(house_of folder result)
  string(REGEX REPLACE "^(calc/project|calc/radiosity|report/shell)/.*" "\\1" house ${folder})
  set(${result} ${house} PARENT_SCOPE)
endfunction()

function(check_file root file)
  file(RELATIVE_PATH name ${root} ${file})
  get_filename_component(folder ${name} DIRECTORY)
  floor_of(folder)
  list(FIND folders "${folder}" floor)
  if(floor LESS 0)
    message(SEND_ERROR "${name}: '${folder}' is not in the list of folders of check_layering.cmake")
  endif()

  house_of(${folder} house)
  file(STRINGS ${file} includes REGEX "^#include \"")
  foreach(line IN LISTS includes)
    if(NOT line MATCHES "^#include \"((calc|rules|report|gpu)/.*)\"")
      message(SEND_ERROR "${name}: ${line}\n  includes of our own files start at the root: calc/, rules/, ...")
      continue()
    endif()
    get_filename_component(target ${CMAKE_MATCH_1} DIRECTORY)
    floor_of(target)
    list(FIND folders "${target}" target_floor)
    if(target_floor LESS 0 OR target_floor GREATER floor)
      message(SEND_ERROR "${name}: ${folder} must not include ${target}")
    endif()
    house_of(${target} target)
    if(target MATCHES "^calc/(rays|radiosity|forecast)$" AND NOT house MATCHES "${needs_rays}")
      message(SEND_ERROR "${name}: must not include ${target}: a verdict traces no ray")
    endif()
    if(target STREQUAL "calc/proofs" AND house MATCHES "^(rules|report/(document|text|stream|revision|build|images|html|result_file|formats))")
      message(SEND_ERROR "${name}: must not include ${target}: a verdict traces no ray")
    endif()
    if(house STREQUAL "gpu" AND NOT target MATCHES "^(calc/|gpu)")
      message(SEND_ERROR "${name}: gpu must not include ${target}")
    endif()
    if(target STREQUAL "gpu" AND NOT house MATCHES "^(gpu|report/(check|shell|tools/[a-z]+|cli|python))$")
      message(SEND_ERROR "${name}: must not include gpu")
    endif()
  endforeach()

  file(STRINGS ${file} library_includes REGEX "^#include <")
  foreach(line IN LISTS library_includes)
    foreach(entry IN LISTS owned_libraries)
      string(REPLACE "|" ";" entry ${entry})
      list(GET entry 0 header)
      list(GET entry 1 owner)
      if(line MATCHES "<${header}" AND NOT name MATCHES "^${owner}")
        message(SEND_ERROR "${name}: ${line} belongs to ${owner} only")
      endif()
    endforeach()
  endforeach()
endfunction()

set(count 0)
foreach(module calc rules gpu report)
  file(GLOB_RECURSE files ${ROOT}/${module}/*.h ${ROOT}/${module}/*.cpp)
  foreach(file IN LISTS files)
    check_file(${ROOT} ${file})
    math(EXPR count "${count} + 1")
  endforeach()
endforeach()
if(count LESS 20)
  message(SEND_ERROR "only ${count} files found below '${ROOT}'")
endif()
message(STATUS "${count} files checked")
