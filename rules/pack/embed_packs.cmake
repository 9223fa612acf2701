# Writes a C++ source with the bytes of the packs as literals:
#   luxgate_embed_packs(<output.cpp> <pack>...)
# The source is written again when a file changes, since each is a dependency of the configure step.
function(luxgate_embed_packs output)
  set(texts "")
  foreach(file IN LISTS ARGN)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
    file(READ ${file} bytes)
    string(APPEND texts "    R\"luxgate(${bytes})luxgate\",\n")
  endforeach()
  file(CONFIGURE OUTPUT ${output} @ONLY CONTENT
"// Written by rules/pack/embed_packs.cmake.
#include \"rules/pack/builtin_packs.h\"

// All compilers that build luxgate take longer literals than the least that the language demands.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored \"-Woverlength-strings\"

namespace rules {

std::vector<std::string_view> builtin_pack_texts() {
  return {
@texts@  };
}

}  // namespace rules

#pragma GCC diagnostic pop
")
endfunction()
