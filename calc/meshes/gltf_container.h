#pragma once
// What is checked of a glTF file before the library sees it: the frame of a GLB, that the JSON is
// well-formed and not too deep, and what the file asks for.

#include "calc/base/diagnostics.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace calc {

// True for the magic of GLB, and for text that begins as JSON does.
bool is_gltf(std::string_view bytes);

struct GltfContainer {
  bool is_binary = false;  // GLB
  std::size_t buffers = 0;
  std::vector<std::string> buffer_uri;  // of those that have one; data: URIs are shortened
  std::vector<std::string> extensions_used, extensions_required;
};

// Empty if and only if an error was reported.
std::optional<GltfContainer> open_gltf(std::string_view bytes, const std::string& name,
                                       Diagnostics& diagnostics);

// Those that may change geometry and are not read, as a list for a message; "" = none.
std::string unknown_gltf_extensions(const std::vector<std::string>& extensions);

// "a%20b" -> "a b". plus_is_blank: as in forms on the web.
std::string percent_decoded(std::string_view uri, bool plus_is_blank);

}  // namespace calc
