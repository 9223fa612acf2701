#pragma once
// A place in a JSON text, for readers that must say where something is wrong.

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace report {

// what(): "/projects/0/path: a text is needed".
class BadJson : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Does not own the JSON. All members throw BadJson.
class JsonCursor {
 public:
  explicit JsonCursor(const nlohmann::json& json, std::string path = "")
      : json_(&json), path_(std::move(path)) {}

  [[noreturn]] void refuse(const std::string& what) const;

  JsonCursor operator[](std::string_view key) const;  // must be there
  std::optional<JsonCursor> find(std::string_view key) const;
  bool is_null() const;

  std::string text() const;
  bool flag() const;
  // Finite, or NaN for null: "what is not a finite number is null".
  double number() const;
  double finite() const;
  // Whole, low <= value <= high.
  std::int64_t whole(std::int64_t low, std::int64_t high) const;
  std::uint64_t count() const;
  std::vector<JsonCursor> items() const;
  std::vector<JsonCursor> items(std::size_t count) const;  // exactly so many

  // The value among `values` whose name is this text.
  template <class Values, class NameOf>
  auto one_of(const Values& values, const NameOf& name_of) const {
    const std::string found = text();
    std::string names;
    for (const auto& value : values) {
      if (found == name_of(value)) return value;
      names += (names.empty() ? "'" : ", '") + std::string(name_of(value)) + "'";
    }
    refuse("one of " + names + " is needed");
  }

  // Calls convert on each item.
  template <class Convert>
  auto list_of(const Convert& convert) const {
    std::vector<decltype(convert(*this))> list;
    for (const JsonCursor& item : items()) list.push_back(convert(item));
    return list;
  }

 private:
  const nlohmann::json* json_;
  std::string path_;  // JSON pointer [RFC 6901]
};

}  // namespace report
