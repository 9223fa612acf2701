#include "report/result_file/json.h"

#include "report/result_file/describe.h"
#include "report/result_file/result_fields.h"
#include "report/text/json_layout.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

namespace report {
namespace {

using Json = nlohmann::ordered_json;

template <class T>
Json json_of(const T& value);

// One object of the file, key by key.
class Writer : public Visitor {
 public:
  explicit Writer(Json& json) : json_(json) {}

  template <class T>
  void constant(const char* key, const T& value) {
    json_[key] = value;
  }
  template <class T>
  void field(const char* key, const T& value, const About& about = {}) {
    if (!about.presence.is_there) return;
    json_[key] = about.null_if.value_or(false) ? Json() : json_of(value);
  }
  template <class Make, class Choices = int>
  void written(const char* key, const Make& make, const About& /*about*/ = {},
               const Choices& /*choices*/ = {}) {
    json_[key] = json_of(make());
  }
  template <class Fields>
  void object(const char* key, const Fields& fields, const About& about = {}) {
    if (!about.presence.is_there) return;
    Json json = Json::object();
    Writer writer(json);
    fields(writer);
    json_[key] = std::move(json);
  }
  template <class Items, class Cells>
  void rows(const char* key, const Items& items, const Cells& cells) {
    Json rows = Json::array();
    for (const auto& item : items) {
      Row row;
      cells(row, item);
      rows.push_back(std::move(row.json));
    }
    json_[key] = std::move(rows);
  }

 private:
  struct Row {
    template <class... Cell>
    void operator()(const Cell&... cell) {
      json = Json::array({json_of(cell)...});
    }
    void refuse_if(bool /*is_bad*/, const char* /*words*/) {}

    Json json;
  };

  Json& json_;
};

template <class T>
Json json_of(const T& value) {
  if constexpr (kIsOrNull<T>) {
    return value.value == value.none ? Json() : Json(value.value);
  } else if constexpr (kIsOptional<T>) {
    return value ? json_of(*value) : Json();
  } else if constexpr (std::is_same_v<T, glm::dvec3>) {
    return Json::array({value.x, value.y, value.z});
  } else if constexpr (std::is_same_v<T, glm::dvec2>) {
    return Json::array({value.x, value.y});
  } else if constexpr (std::is_same_v<T, Line>) {
    return Json::array({value[0].x, value[0].y, value[1].x, value[1].y});
  } else if constexpr (kIsList<T>) {
    Json array = Json::array();
    for (const auto& item : value) array.push_back(json_of(item));
    return array;
  } else if constexpr (Named<T>) {
    return Json(calc::name_of(value));
  } else if constexpr (std::is_class_v<T> && !std::is_convertible_v<T, std::string_view>) {
    Json json = Json::object();
    Writer writer(json);
    describe(writer, value);
    return json;
  } else {
    return Json(value);
  }
}

}  // namespace

std::string render_json(const Document& document) { return json_layout(json_of(document)); }

}  // namespace report
