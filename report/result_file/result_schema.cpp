#include "report/result_file/result_schema.h"

#include "report/result_file/describe.h"
#include "report/result_file/message_json.h"
#include "report/result_file/result_fields.h"
#include "report/text/json_layout.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <type_traits>
#include <utility>

namespace report {
namespace {

using Json = nlohmann::ordered_json;

// `definitions`: of the whole schema; parts that have a name go there.
template <class T>
Json schema_of(const About& about, Json& definitions);

Json reference(const std::string& name) { return {{"$ref", "#/definitions/" + name}}; }

Json list_of(Json items) { return {{"type", "array"}, {"items", std::move(items)}}; }

Json numbers(std::size_t count, const Json& type = "number") {
  return {{"type", "array"}, {"items", {{"type", type}}}, {"minItems", count}, {"maxItems", count}};
}

const Json& number_or_null() {
  static const Json type = {"number", "null"};
  return type;
}

// One object of the file, key by key. Conditions of the file are none of the schema: it goes
// through everything.
class SchemaMaker : public Visitor {
 public:
  explicit SchemaMaker(Json& definitions) : definitions_(definitions) {}

  // What was described, with the words of its place if it has none of its own.
  Json result(const std::string& words) {
    Json json = {{"type", "object"}};
    if (!words.empty() || !words_.empty()) json["description"] = words_.empty() ? words : words_;
    json["properties"] = std::move(properties_);
    if (!required_.empty()) json["required"] = std::move(required_);
    json.update(conditions_);
    if (name_.empty()) return json;
    definitions_[name_] = std::move(json);
    return reference(name_);
  }

  void is(const char* name, const char* words = "") {
    name_ = name;
    words_ = words;
  }

  template <class T>
  void constant(const char* key, const T& value) {
    add(key, {{"const", value}}, {});
  }
  template <class T>
  void field(const char* key, const T& /*value*/, const About& about = {}) {
    Json json = schema_of<T>(about, definitions_);
    if (about.null_if && json.value("type", Json()) != number_or_null())
      json = {{"oneOf", {std::move(json), {{"type", "null"}}}}};
    add(key, std::move(json), about);
    if constexpr (kIsMessage<T> || kIsMessageList<T>) {
      definitions_["message_part"] = message_part_schema();
      Json parts = list_of(reference("message_part"));
      if constexpr (kIsMessageList<T>) parts = list_of(std::move(parts));
      add(message_key(key).c_str(), std::move(parts), {.presence = kSinceLater});
    }
  }
  template <class Make, class Choices = std::vector<int>>
  void written(const char* key, const Make& /*make*/, const About& about = {},
               const Choices& choices = {}) {
    using T = std::remove_cvref_t<std::invoke_result_t<Make>>;
    if constexpr (std::is_same_v<Choices, std::vector<int>>) {
      add(key, schema_of<T>(about, definitions_), about);
    } else {
      add(key, {{"enum", choices}}, about);
    }
  }
  template <class Fields>
  void object(const char* key, const Fields& fields, const About& about = {}) {
    SchemaMaker maker(definitions_);
    fields(maker);
    add(key, maker.result(about.words), about);
  }
  template <class Fields>
  void if_true(const char* key, bool /*flag*/, const Fields& fields) {
    const Json required = required_of(fields);
    conditions_["if"] = {{"properties", {{key, {{"const", true}}}}}};
    conditions_["then"] = {{"required", required}};
  }
  template <class First, class Second>
  void either(bool /*is_first*/, const First& first, const Second& second) {
    const Json of_first = required_of(first), of_second = required_of(second);
    conditions_["anyOf"] = {{{"required", of_first}}, {{"required", of_second}}};
  }
  template <class Items, class Cells>
  void rows(const char* key, const Items& /*items*/, const Cells& cells) {
    typename Items::value_type item{};
    Row row;
    cells(row, item);
    const bool are_numbers = std::all_of(row.cells.begin(), row.cells.end(), [](const Json& cell) {
      return cell.at("type") == number_or_null();
    });
    const std::size_t count = row.cells.size();
    Json json = numbers(count, number_or_null());
    if (!are_numbers) {
      json = {{"type", "array"}, {"items", row.cells}, {"minItems", count}, {"maxItems", count}};
    }
    add(key, list_of(std::move(json)), {});
  }

 private:
  struct Row {
    template <class... Cell>
    void operator()(const Cell&... /*cell*/) {
      (cells.push_back(type_of<Cell>()), ...);
    }
    void refuse_if(bool /*is_bad*/, const char* /*words*/) {}

    Json cells = Json::array();

   private:
    template <class Cell>
    static Json type_of() {
      if constexpr (std::is_convertible_v<Cell, std::string>) return {{"type", "string"}};
      return {{"type", number_or_null()}};
    }
  };

  void add(const char* key, Json json, const About& about) {
    if (*about.words != '\0' && !json.contains("description")) json["description"] = about.words;
    properties_[key] = std::move(json);
    if (!about.presence.may_lack) required_.push_back(key);
  }

  // Keys that must be there where `fields` are.
  template <class Fields>
  Json required_of(const Fields& fields) {
    Json before = std::exchange(required_, Json::array());
    fields();
    return std::exchange(required_, std::move(before));
  }

  Json& definitions_;
  std::string name_, words_;
  Json properties_ = Json::object(), required_ = Json::array(), conditions_ = Json::object();
};

Json vector_schema(Json& definitions) {
  definitions["vector"] = numbers(3);
  return reference("vector");
}

Json polygon_schema(Json& definitions) {
  definitions["polygon"] = list_of(numbers(2));
  return reference("polygon");
}

template <class T>
Json number_schema(const About& about) {
  constexpr bool is_whole = std::is_integral_v<T>;
  const auto number = [](double end) {
    return end == std::trunc(end) ? Json(static_cast<std::int64_t>(end)) : Json(end);
  };
  Json json = {{"type", is_whole ? "integer" : "number"}};
  if (is_whole || about.least) json["minimum"] = number(about.least.value_or(0.0));
  if (about.most) json["maximum"] = number(*about.most);
  if (about.above) json["exclusiveMinimum"] = number(*about.above);
  if (about.below) json["exclusiveMaximum"] = number(*about.below);
  return json;
}

template <class T>
Json schema_of(const About& about, Json& definitions) {
  if constexpr (kIsOrNull<T> || std::is_same_v<T, std::optional<double>>) {
    return {{"type", number_or_null()}};
  } else if constexpr (kIsOptional<T>) {
    return schema_of<typename T::value_type>(about, definitions);
  } else if constexpr (std::is_same_v<T, glm::dvec3>) {
    return vector_schema(definitions);
  } else if constexpr (std::is_same_v<T, glm::dvec2>) {
    return numbers(2);
  } else if constexpr (std::is_same_v<T, Line>) {
    return numbers(4);
  } else if constexpr (std::is_same_v<T, std::vector<glm::dvec2>>) {
    return polygon_schema(definitions);
  } else if constexpr (kIsList<T>) {
    return list_of(schema_of<typename T::value_type>({}, definitions));
  } else if constexpr (Named<T>) {
    return {{"enum", choices_of<T>(about)}};
  } else if constexpr (kIsMessage<T>) {
    return {{"type", "string"}};
  } else if constexpr (std::is_convertible_v<T, std::string_view>) {
    return about.choices.empty() ? Json{{"type", "string"}} : Json{{"enum", about.choices}};
  } else if constexpr (std::is_same_v<T, bool>) {
    return about.is_mark ? Json{{"const", true}} : Json{{"type", "boolean"}};
  } else if constexpr (std::is_arithmetic_v<T>) {
    return number_schema<T>(about);
  } else {
    T part{};
    SchemaMaker maker(definitions);
    describe(maker, part);
    return maker.result(about.words);
  }
}

}  // namespace

std::string result_schema() {
  Json json = {{"$schema", "http://json-schema.org/draft-07/schema#"}, {"title", "luxgate result"}};
  Json definitions = Json::object();
  json.update(schema_of<Document>({}, definitions));
  json["definitions"] = std::move(definitions);
  return json_layout(json);
}

}  // namespace report
