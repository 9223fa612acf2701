#pragma once
// Checks a glTF file before the library sees it: the frame of a GLB, well-formed JSON of limited
// depth, and the files and extensions it requires.

#include "calc/base/diagnostics.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace calc {

// Returns true for the magic of GLB, and for text that begins as JSON does.
bool is_gltf(std::string_view bytes);

struct GltfContainer {
  bool is_binary = false;  // GLB
  std::size_t buffers = 0;
  std::vector<std::string> buffer_uri;  // of those that have one; data: URIs are shortened
  std::vector<std::string> extensions_used, extensions_required;
};

// Returns the container; empty if and only if an error was reported.
std::optional<GltfContainer> open_gltf(std::string_view bytes, const std::string& name,
                                       Diagnostics& diagnostics);

// Returns a list of unsupported ones that may change geometry, for a message; "" = none.
std::string unknown_gltf_extensions(const std::vector<std::string>& extensions);

// Returns "a b" for "a%20b". plus_is_blank: as in forms on the web.
std::string percent_decoded(std::string_view uri, bool plus_is_blank);

}  // namespace calc
