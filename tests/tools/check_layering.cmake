# Allowed directions between folders, read from the #include lines.
#   cmake -DROOT=<source folder> -P check_layering.cmake
# calc -> calc, rules -> calc, gpu -> calc, report -> rules and calc, report/cli -> everything. Inside calc the
# model (scene, photometry, top level) must not know rays, proofs, radiosity or forecast;
# rays know triangles only, proofs neither rays nor the solver, the solver not the forecast. Single libraries belong to single files.
cmake_minimum_required(VERSION 3.25)

set(allowed_calc calc)
set(allowed_rules rules calc)
set(allowed_gpu gpu calc)
set(allowed_report report rules calc)
set(allowed_cli report rules calc gpu)

# header pattern | the only files (pattern) that may include it
set(owned_libraries
  "embree3/|calc/rays/triangle_tree\\.cpp"
  "hwy/|calc/rays/[a-z_]+\\.cpp"
  "sleef|calc/base/elementary\\.cpp"
  "epoxy/egl|gpu/egl_context"
  "epoxy/|gpu/"
  "CLI/|report/cli/(rules_)?options\\.cpp"
  "tiny_obj_loader|calc/scene/mesh_obj"
  "tiny_gltf|calc/scene/mesh_gltf"
  "png\\.h|report/"
  "OpenEXR/|report/")

function(check_file root file)
  file(RELATIVE_PATH name ${root} ${file})
  string(REGEX MATCH "^[a-z]+" module ${name})
  set(layer ${module})
  if(name MATCHES "^report/cli/")
    set(layer cli)
  endif()

  file(STRINGS ${file} includes REGEX "^#include \"")
  foreach(line IN LISTS includes)
    if(NOT line MATCHES "^#include \"(calc|rules|report|gpu)/(.*)\"")
      message(SEND_ERROR "${name}: ${line}\n  includes of our own files start at the root: calc/, rules/, ...")
      continue()
    endif()
    set(target ${CMAKE_MATCH_1})
    set(rest ${CMAKE_MATCH_2})
    if(NOT target IN_LIST allowed_${layer})
      message(SEND_ERROR "${name}: ${layer} must not include ${target}/${rest}")
    endif()
    if(layer STREQUAL "report" AND target STREQUAL "report" AND rest MATCHES "^cli/")
      message(SEND_ERROR "${name}: report must not include report/cli")
    endif()
    if(name MATCHES "^calc/rays/" AND rest MATCHES "/" AND NOT rest MATCHES "^rays/")
      message(SEND_ERROR "${name}: rays know triangles only, not calc/${rest}")
    endif()
    if(target STREQUAL "calc" AND rest MATCHES "^(rays|proofs|radiosity|forecast)/")
      if(layer MATCHES "^(rules|report)$" OR
         (layer STREQUAL "calc" AND NOT name MATCHES "^calc/(rays|proofs|radiosity|forecast)/"))
        message(SEND_ERROR "${name}: must not include calc/radiosity: a verdict traces no ray")
      endif()
      if(name MATCHES "^calc/proofs/" AND NOT rest MATCHES "^proofs/")
        message(SEND_ERROR "${name}: a proof must not include calc/${rest}")
      endif()
      if(rest MATCHES "^forecast/" AND name MATCHES "^calc/" AND NOT name MATCHES "^calc/forecast/")
        message(SEND_ERROR "${name}: nothing in calc stands on the forecast")
      endif()
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
