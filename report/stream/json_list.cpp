#include "report/stream/json_list.h"

#include "report/text/json_layout.h"

#include <nlohmann/json.hpp>

#include <string>

namespace report {

void JsonList::add(const nlohmann::ordered_json& item) {
  items_.write((items_.is_empty() ? "" : ",\n") + std::string(depth_ + 1, ' '));
  items_.write(json_layout_within(item, depth_ + 1));
}

void JsonList::copy_to(Sink& sink, const JsonList* more) const {
  const char* start = "[\n";
  for (const JsonList* list : {this, more}) {
    if (list == nullptr || list->items_.is_empty()) continue;
    sink.write(start);
    list->items_.copy_to(sink);
    start = ",\n";
  }
  const bool is_empty = items_.is_empty() && (more == nullptr || more->items_.is_empty());
  sink.write(is_empty ? "[]" : "\n" + std::string(depth_, ' ') + "]");
}

}  // namespace report
