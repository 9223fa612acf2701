#include "calc/meshes/gltf_container.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/base/text.h"
#include "calc/base/utf8.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <utility>

namespace calc {
namespace {

constexpr std::string_view kMagic = "glTF";
constexpr std::size_t kHeaderBytes = 12, kChunkHeaderBytes = 8;
constexpr std::uint32_t kJsonChunk = 0x4E4F534A;
constexpr int kDepthLimit = 64;  // the library reads extras recursively
static_assert(std::endian::native == std::endian::little, "numbers are copied as they are");

std::uint32_t number_at(std::string_view bytes, std::size_t at) {
  std::uint32_t number = 0;
  std::memcpy(&number, bytes.data() + at, sizeof number);
  return number;
}

// Looks through the whole JSON text once, without keeping it.
class Survey {
 public:
  explicit Survey(GltfContainer& container) : container_(container) {}

  const std::string& problem() const { return problem_; }

  // The interface that nlohmann's parser calls; false stops it.
  bool null() { return true; }
  bool boolean(bool) { return true; }
  bool number_integer(std::int64_t number) { return take(static_cast<double>(number)); }
  bool number_unsigned(std::uint64_t) { return true; }
  bool number_float(double number, const std::string&) { return take(number); }
  bool binary(std::vector<std::uint8_t>&) { return true; }
  bool string(std::string& text) {
    constexpr std::size_t kShown = 200;
    if (depth_ == 2 && root_key_ == "extensionsUsed") container_.extensions_used.push_back(text);
    if (depth_ == 2 && root_key_ == "extensionsRequired") {
      container_.extensions_required.push_back(text);
    }
    if (depth_ == 3 && root_key_ == "buffers" && key_ == "uri") {
      container_.buffer_uri.push_back(text.starts_with("data:") ? text.substr(0, kShown) : text);
    }
    return true;
  }
  bool start_object(std::size_t) {
    if (depth_ == 2 && root_key_ == "buffers") ++container_.buffers;
    return enter();
  }
  bool start_array(std::size_t) { return enter(); }
  bool key(std::string& text) {
    (depth_ == 1 ? root_key_ : key_) = text;
    return true;
  }
  bool end_object() { return leave(); }
  bool end_array() { return leave(); }
  bool parse_error(std::size_t position, const std::string& token,
                   const nlohmann::json::exception&) {
    problem_ =
        fmt::format("not well-formed JSON at byte {}, near '{}'", position,
                    shorten_utf8(token.substr(token.size() > 30 ? token.size() - 30 : 0), 30));
    return false;
  }

 private:
  // A number below 0 or with a fraction. Where bytes lie and how many there are is no such number,
  // and the library would silently take 0 instead.
  bool take(double number) {
    static constexpr std::array<std::string_view, 4> kWhole{"byteOffset", "byteLength",
                                                            "byteStride", "count"};
    const bool is_of_bytes =
        root_key_ == "buffers" || root_key_ == "bufferViews" || root_key_ == "accessors";
    if (depth_ != 3 || !is_of_bytes) return true;
    if (std::find(kWhole.begin(), kWhole.end(), key_) == kWhole.end()) return true;
    problem_ = fmt::format("'{}' in '{}' is {}; whole numbers from 0 are allowed", key_, root_key_,
                           number);
    return false;
  }
  bool enter() {
    if (++depth_ <= kDepthLimit) return true;
    problem_ = fmt::format("its JSON is nested more than {} deep", kDepthLimit);
    return false;
  }
  bool leave() {
    --depth_;
    return true;
  }

  GltfContainer& container_;
  int depth_ = 0;
  std::string root_key_, key_, problem_;
};

// The JSON text of a GLB; "" and a problem if the frame is broken.
std::string_view glb_json(std::string_view bytes, GltfContainer& container, std::string& problem) {
  container.is_binary = true;
  if (bytes.size() < kHeaderBytes + kChunkHeaderBytes) {
    problem = "it ends within its header";
  } else if (const std::uint32_t version = number_at(bytes, 4); version != 2) {
    problem = fmt::format("its version is {}; only version 2 is read", version);
  } else if (const std::uint32_t length = number_at(bytes, 8); length != bytes.size()) {
    problem = fmt::format("its header states {} bytes, the file has {}", length, bytes.size());
  }
  if (!problem.empty()) return {};
  std::string_view json;
  std::size_t chunk = 0;
  for (std::size_t at = kHeaderBytes; at < bytes.size(); ++chunk) {
    const std::size_t left = bytes.size() - at;
    if (left < kChunkHeaderBytes || number_at(bytes, at) > left - kChunkHeaderBytes) {
      problem = fmt::format("chunk {} does not fit into the file", chunk);
      return {};
    }
    const std::size_t length = number_at(bytes, at);
    if (chunk == 0 && number_at(bytes, at + 4) != kJsonChunk) {
      problem = "its first chunk is not JSON";
    }
    if (chunk == 0) json = bytes.substr(at + kChunkHeaderBytes, length);
    at += kChunkHeaderBytes + length;
  }
  return json;
}

// They change looks or lights, but no triangle. Quantised coordinates are read.
bool leaves_triangles(std::string_view extension) {
  static constexpr std::array<std::string_view, 8> kHarmless{
      "KHR_materials_", "KHR_texture_", "EXT_texture_", "MSFT_texture_",
      "KHR_lights_",    "EXT_lights_",  "KHR_xmp",      "KHR_mesh_quantization"};
  return std::any_of(kHarmless.begin(), kHarmless.end(),
                     [&](std::string_view start) { return extension.starts_with(start); });
}

}  // namespace

bool is_gltf(std::string_view bytes) {
  if (bytes.starts_with(kMagic)) return true;
  return trim(without_byte_order_mark(bytes).substr(0, 200)).starts_with('{');
}

std::optional<GltfContainer> open_gltf(std::string_view bytes, const std::string& name,
                                       Diagnostics& diagnostics) {
  GltfContainer container;
  std::string problem;
  std::string_view json = bytes;
  if (bytes.starts_with(kMagic)) json = glb_json(bytes, container, problem);
  if (problem.empty()) {
    Survey survey(container);
    if (!nlohmann::json::sax_parse(json.begin(), json.end(), &survey)) problem = survey.problem();
  }
  if (problem.empty()) return container;
  diagnostics.report(DiagnosticId::mesh_broken, SourceLocation{name, 0, 0}, "glTF", problem);
  return std::nullopt;
}

std::string unknown_gltf_extensions(const std::vector<std::string>& extensions) {
  std::string list;
  for (const std::string& extension : extensions) {
    if (leaves_triangles(extension)) continue;
    list += (list.empty() ? "" : ", ") + shorten_utf8(extension, 60);
  }
  return list;
}

std::string percent_decoded(std::string_view uri, bool plus_is_blank) {
  const auto digit = [](char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    return c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
  };
  std::string text;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    const bool is_code =
        uri[i] == '%' && i + 2 < uri.size() && digit(uri[i + 1]) >= 0 && digit(uri[i + 2]) >= 0;
    if (is_code) {
      text += static_cast<char>(digit(uri[i + 1]) * 16 + digit(uri[i + 2]));
      i += 2;
    } else {
      text += plus_is_blank && uri[i] == '+' ? ' ' : uri[i];
    }
  }
  return text;
}

}  // namespace calc
