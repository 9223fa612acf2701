#include "report/result_file/json_cursor.h"

#include "report/text/plain_text.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <limits>

namespace report {
namespace {

std::string pointer_token(std::string_view key) {
  std::string token = "/";
  for (const char c : key) token += c == '~' ? "~0" : c == '/' ? "~1" : std::string(1, c);
  return token;
}

}  // namespace

void JsonCursor::refuse(const std::string& what) const {
  throw BadJson(printable(path_.empty() ? what : path_ + ": " + what));
}

JsonCursor JsonCursor::operator[](std::string_view key) const {
  const std::optional<JsonCursor> found = find(key);
  if (!found) refuse(fmt::format("the key '{}' is missing", key));
  return *found;
}

std::optional<JsonCursor> JsonCursor::find(std::string_view key) const {
  if (!json_->is_object()) refuse("an object is needed");
  const auto found = json_->find(key);
  if (found == json_->end()) return std::nullopt;
  return JsonCursor(*found, path_ + pointer_token(key));
}

bool JsonCursor::is_null() const { return json_->is_null(); }

std::string JsonCursor::text() const {
  if (!json_->is_string()) refuse("a text is needed");
  return json_->get<std::string>();
}

bool JsonCursor::flag() const {
  if (!json_->is_boolean()) refuse("true or false is needed");
  return json_->get<bool>();
}

double JsonCursor::finite() const {
  if (!json_->is_number()) refuse("a number is needed");
  const double value = json_->get<double>();
  if (!std::isfinite(value)) refuse("the number is too large");
  return value;
}

std::int64_t JsonCursor::whole(std::int64_t low, std::int64_t high) const {
  const bool is_whole = json_->is_number_integer();
  // Unsigned numbers beyond the signed range are too large for every caller.
  const bool is_huge = json_->is_number_unsigned() &&
                       json_->get<std::uint64_t>() >
                           static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max());
  const std::int64_t value = is_whole && !is_huge ? json_->get<std::int64_t>() : 0;
  if (!is_whole || is_huge || value < low || value > high) {
    refuse(fmt::format("a whole number from {} to {} is needed", low, high));
  }
  return value;
}

std::uint64_t JsonCursor::count(std::uint64_t least) const {
  if (!json_->is_number_unsigned() || json_->get<std::uint64_t>() < least) {
    refuse(fmt::format("a whole number of at least {} is needed", least));
  }
  return json_->get<std::uint64_t>();
}

std::vector<JsonCursor> JsonCursor::items() const {
  if (!json_->is_array()) refuse("an array is needed");
  std::vector<JsonCursor> list;
  list.reserve(json_->size());
  for (std::size_t i = 0; i < json_->size(); ++i) {
    list.emplace_back((*json_)[i], fmt::format("{}/{}", path_, i));
  }
  return list;
}

std::vector<JsonCursor> JsonCursor::items(std::size_t count) const {
  std::vector<JsonCursor> list = items();
  if (list.size() != count) refuse(fmt::format("an array of {} is needed", count));
  return list;
}

}  // namespace report
