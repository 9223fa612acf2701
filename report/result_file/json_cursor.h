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

// A place in a JSON text, which must outlive it. All members throw BadJson.
class JsonCursor {
 public:
  explicit JsonCursor(const nlohmann::json& json, std::string path = "")
      : json_(&json), path_(std::move(path)) {}

  [[noreturn]] void refuse(const std::string& what) const;

  JsonCursor operator[](std::string_view key) const;  // must be there
  std::optional<JsonCursor> find(std::string_view key) const;
  bool is_null() const;
  const nlohmann::json& raw() const { return *json_; }

  std::string text() const;
  bool flag() const;
  double finite() const;
  // Returns a whole number, low <= value <= high.
  std::int64_t whole(std::int64_t low, std::int64_t high) const;
  std::uint64_t count(std::uint64_t least = 0) const;  // whole
  std::vector<JsonCursor> items() const;
  std::vector<JsonCursor> items(std::size_t count) const;  // exactly so many

 private:
  const nlohmann::json* json_;
  std::string path_;  // JSON pointer [RFC 6901]
};

}  // namespace report
