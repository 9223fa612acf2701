#pragma once
// The keys of a JSON file, each in one place: with its value for the file, and its words for the
// schema (draft 7). A schema is made of the keys of an empty value.

#include "calc/base/names.h"

#include <nlohmann/json.hpp>

#include <string>
#include <utility>
#include <vector>

namespace report {

using KeyedJson = nlohmann::ordered_json;

struct JsonKey {
  const char* name;
  KeyedJson value;
  KeyedJson schema;
  bool is_needed = true;   // in every file
  bool is_written = true;  // in this one
};
using JsonKeys = std::vector<JsonKey>;

inline KeyedJson object_of_keys(const JsonKeys& keys) {
  KeyedJson json = KeyedJson::object();
  for (const JsonKey& key : keys) {
    if (key.is_written) json[key.name] = key.value;
  }
  return json;
}

inline KeyedJson schema_of_keys(const JsonKeys& keys, const char* words = "") {
  KeyedJson json{{"type", "object"}};
  if (*words != '\0') json["description"] = words;
  KeyedJson properties = KeyedJson::object(), needed = KeyedJson::array();
  for (const JsonKey& key : keys) {
    properties[key.name] = key.schema;
    if (key.is_needed) needed.push_back(key.name);
  }
  json["properties"] = std::move(properties);
  json["required"] = std::move(needed);
  return json;
}

inline KeyedJson schema_of_file(const char* title, const JsonKeys& keys) {
  KeyedJson json{{"$schema", "http://json-schema.org/draft-07/schema#"}, {"title", title}};
  json.update(schema_of_keys(keys));
  return json;
}

inline KeyedJson described_key(KeyedJson schema, const char* words) {
  schema["description"] = words;
  return schema;
}

inline KeyedJson type_of(const char* name) { return {{"type", name}}; }
inline KeyedJson number_or_null_type() { return {{"type", {"number", "null"}}}; }
// Returns the type of a count or a sum.
inline KeyedJson at_least_type(const char* name, int least) {
  return {{"type", name}, {"minimum", least}};
}
inline KeyedJson list_of_keys(KeyedJson items) {
  return {{"type", "array"}, {"items", std::move(items)}};
}
template <class Enum>
KeyedJson one_of_names() {
  return {{"enum", calc::names_of<Enum>()}};
}

inline JsonKey object_key(const char* name, const JsonKeys& keys, const char* words = "") {
  return {name, object_of_keys(keys), schema_of_keys(keys, words)};
}

}  // namespace report
