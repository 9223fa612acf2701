#include "report/result_file/read_json_parts.h"

#include <limits>

namespace report {

int read_whole(const JsonCursor& at, std::int64_t low) {
  return static_cast<int>(at.whole(low, std::numeric_limits<int>::max()));
}

std::size_t read_size(const JsonCursor& at) { return static_cast<std::size_t>(at.count()); }

std::optional<double> read_optional_number(const JsonCursor& at) {
  if (at.is_null()) return std::nullopt;
  return at.finite();
}

glm::dvec3 read_vec3(const JsonCursor& at) {
  const std::vector<JsonCursor> items = at.items(3);
  return {items[0].finite(), items[1].finite(), items[2].finite()};
}

glm::dvec2 read_vec2(const JsonCursor& at) {
  const std::vector<JsonCursor> items = at.items(2);
  return {items[0].finite(), items[1].finite()};
}

std::vector<glm::dvec2> read_polygon(const JsonCursor& at) { return at.list_of(read_vec2); }

calc::Estimate read_estimate(const JsonCursor& at) {
  return settled({at["value"].number(), at["low"].number(), at["high"].number()});
}

calc::SourceLocation read_location(const JsonCursor& at) {
  return {at["file"].text(), read_whole(at["line"]), read_whole(at["column"])};
}

}  // namespace report
