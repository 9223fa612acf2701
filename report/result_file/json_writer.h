#pragma once
// Values of a document as JSON, by their description in result_fields.h.

#include "report/result_file/describe.h"
#include "report/result_file/message_json.h"
#include "report/result_file/result_fields.h"

#include <nlohmann/json.hpp>

#include <string_view>
#include <type_traits>
#include <utility>

namespace report {

// Keys in the order of their description.
using OrderedJson = nlohmann::ordered_json;

template <class T>
OrderedJson json_of(const T& value);

// Writes an object of the file, key by key.
class Writer : public Visitor {
 public:
  explicit Writer(OrderedJson& json) : json_(json) {}

  template <class T>
  void constant(const char* key, const T& value) {
    json_[key] = value;
  }
  template <class T>
  void field(const char* key, const T& value, const About& about = {}) {
    if (!about.presence.is_there) return;
    json_[key] = about.null_if.value_or(false) ? OrderedJson() : json_of(value);
    if constexpr (kIsMessage<T> || kIsMessageList<T>) {
      if (has_parts(value)) json_[message_key(key)] = message_json(value);
    }
  }
  template <class Make, class Choices = int>
  void written(const char* key, const Make& make, const About& about = {},
               const Choices& /*choices*/ = {}) {
    if (!about.presence.is_there) return;
    json_[key] = json_of(make());
  }
  template <class Fields>
  void object(const char* key, const Fields& fields, const About& about = {}) {
    if (!about.presence.is_there) return;
    OrderedJson json = OrderedJson::object();
    Writer writer(json);
    fields(writer);
    json_[key] = std::move(json);
  }
  template <class Items, class Cells>
  void rows(const char* key, const Items& items, const Cells& cells) {
    OrderedJson rows = OrderedJson::array();
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
      json = OrderedJson::array({json_of(cell)...});
    }
    void refuse_if(bool /*is_bad*/, const char* /*words*/) {}

    OrderedJson json;
  };

  OrderedJson& json_;
};

template <class T>
OrderedJson json_of(const T& value) {
  if constexpr (kIsOrNull<T>) {
    return value.value == value.none ? OrderedJson() : OrderedJson(value.value);
  } else if constexpr (kIsOptional<T>) {
    return value ? json_of(*value) : OrderedJson();
  } else if constexpr (std::is_same_v<T, glm::dvec3>) {
    return OrderedJson::array({value.x, value.y, value.z});
  } else if constexpr (std::is_same_v<T, glm::dvec2>) {
    return OrderedJson::array({value.x, value.y});
  } else if constexpr (std::is_same_v<T, Line>) {
    return OrderedJson::array({value[0].x, value[0].y, value[1].x, value[1].y});
  } else if constexpr (kIsList<T>) {
    OrderedJson array = OrderedJson::array();
    for (const auto& item : value) array.push_back(json_of(item));
    return array;
  } else if constexpr (Named<T>) {
    return OrderedJson(calc::name_of(value));
  } else if constexpr (kIsMessage<T>) {
    return OrderedJson(value.english());
  } else if constexpr (std::is_class_v<T> && !std::is_convertible_v<T, std::string_view>) {
    OrderedJson json = OrderedJson::object();
    Writer writer(json);
    describe(writer, value);
    return json;
  } else {
    return OrderedJson(value);
  }
}

}  // namespace report
