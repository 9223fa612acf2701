#include "report/text/json_layout.h"

#include <algorithm>
#include <cstddef>
#include <nlohmann/json.hpp>

namespace report {
namespace {

using Json = nlohmann::ordered_json;

// On one line: scalars, empty things, arrays of scalars and small objects of scalars (an estimate).
bool is_flat(const Json& json) {
  constexpr std::size_t kMostKeys = 3;
  if (!json.is_structured() || json.empty()) return true;
  if (json.is_object() && json.size() > kMostKeys) return false;
  return std::none_of(json.begin(), json.end(),
                      [](const Json& part) { return part.is_structured(); });
}

std::string scalar(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

void lay_out(const Json& json, std::size_t depth, std::string& text) {
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
    lay_out(item.value(), depth + 1, text);
    separator = flat ? ", " : ",\n";
  }
  if (!flat) text += "\n" + std::string(depth, ' ');
  text += json.is_object() ? "}" : "]";
}

}  // namespace

std::string json_layout(const nlohmann::ordered_json& json) {
  std::string text;
  lay_out(json, 0, text);
  return text + "\n";
}

}  // namespace report
