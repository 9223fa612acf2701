#include "report/text/json_layout.h"

#include "calc/base/utf8.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>

namespace report {
namespace {

using Json = nlohmann::ordered_json;

// On one line: scalars, empty things, arrays of scalars and small objects of scalars (an estimate).
bool is_flat(const Json& json) {
  constexpr std::size_t kMostKeys = 3;
  if (!json.is_structured() || json.empty()) return true;
  if (json.is_object() && json.size() > kMostKeys) return false;
  return std::none_of(json.begin(), json.end(),
                      [](const Json& part) { return part.is_structured() || part.is_binary(); });
}

// What terminals and CI runners would obey, as escapes of the same text: "##vso[" is
// "##vso\u005b".
std::string escaped(std::string_view text) {
  std::string safe;
  while (!text.empty()) {
    const calc::Utf8Character point = calc::first_character(text);
    const bool is_order = point.code == '[' && calc::ends_with_command(safe);
    const std::size_t length = std::max<std::size_t>(1, point.length);
    if (calc::is_control(point.code) || is_order) {
      safe += fmt::format("\\u{:04x}", static_cast<std::uint32_t>(point.code));
    } else {
      safe += text.substr(0, length);
    }
    text.remove_prefix(length);
  }
  return safe;
}

std::string scalar(const Json& json) {
  std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  if (!json.is_string()) return text;
  const bool is_plain = text.find('[') == std::string::npos &&
                        std::all_of(text.begin(), text.end(), [](char c) { return c >= ' '; });
  return is_plain ? text : escaped(text);
}

// Collects a layout; gaps are binary values, which JSON has not.
struct Pieces {
  std::vector<std::string> before;  // each ends at a gap
  std::string text;                 // since the last one
};

void lay_out(const Json& json, std::size_t depth, Pieces& pieces) {
  if (json.is_binary()) {
    pieces.before.push_back(std::move(pieces.text));
    pieces.text.clear();
    return;
  }
  std::string& text = pieces.text;
  if (!json.is_structured() || json.empty()) {
    text += scalar(json);
    return;
  }
  const bool flat = is_flat(json);
  const std::string line_end = flat ? "" : "\n";
  const std::string indent = flat ? "" : std::string(depth + 1, ' ');
  const char* separator = "";
  text += json.is_object() ? "{" : "[";
  text += line_end;
  for (const auto& item : json.items()) {
    text += separator + indent;
    if (json.is_object()) text += scalar(Json(item.key())) + ": ";
    lay_out(item.value(), depth + 1, pieces);
    separator = flat ? ", " : ",\n";
  }
  if (!flat) text += "\n" + std::string(depth, ' ');
  text += json.is_object() ? "}" : "]";
}

}  // namespace

std::string json_layout(const Json& json) { return json_layout_within(json, 0) + "\n"; }

std::string json_layout_within(const Json& json, std::size_t depth) {
  Pieces pieces;
  lay_out(json, depth, pieces);
  return std::move(pieces.text);
}

Json json_gap() { return Json::binary({}); }

std::vector<std::string> json_layout_around_gaps(const Json& json, std::size_t depth) {
  Pieces pieces;
  lay_out(json, depth, pieces);
  pieces.before.push_back(std::move(pieces.text));
  return std::move(pieces.before);
}

}  // namespace report
