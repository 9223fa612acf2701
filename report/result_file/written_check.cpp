#include "report/result_file/written_check.h"

#include "report/result_file/json_writer.h"
#include "report/result_file/message_json.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <type_traits>
#include <vector>

namespace report {
namespace {

// Earlier versions wrote fewer keys.
void compare(const JsonCursor& at, const nlohmann::json& follows) {
  if (!follows.is_object()) {
    if (at.raw() == follows) return;
    at.refuse(fmt::format("the file says {}, but its other values give {}", at.raw().dump(),
                          follows.dump()));
  }
  for (const auto& item : follows.items()) {
    if (const std::optional<JsonCursor> part = at.find(item.key())) compare(*part, item.value());
  }
}

// One object of the file, key by key.
class WrittenCheck : public Visitor {
 public:
  explicit WrittenCheck(const JsonCursor& at) : at_(at) {}

  template <class T>
  void constant(const char* /*key*/, const T& /*value*/) {}
  template <class T>
  void field(const char* key, const T& value, const About& about = {}) {
    if (!about.presence.is_there || about.null_if.value_or(false)) return;
    if (const std::optional<JsonCursor> found = at_.find(key)) walk(*found, value);
  }
  template <class Make, class Choices = int>
  void written(const char* key, const Make& make, const About& about = {},
               const Choices& /*choices*/ = {}) {
    if (about.holds == Holds::prose) return;
    const std::optional<JsonCursor> found = at_.find(key);
    if (found) compare(*found, nlohmann::json::parse(json_of(make()).dump()));
  }
  template <class Fields>
  void object(const char* key, const Fields& fields, const About& about = {}) {
    if (!about.presence.is_there) return;
    if (const std::optional<JsonCursor> found = at_.find(key)) {
      WrittenCheck inner(*found);
      fields(inner);
    }
  }
  template <class Items, class Cells>
  void rows(const char* /*key*/, const Items& /*items*/, const Cells& /*cells*/) {}

 private:
  template <class T>
  static constexpr bool kIsPart =
      std::is_class_v<T> && !kIsOptional<T> && !kIsOrNull<T> && !Vector<T> &&
      !std::is_same_v<T, Line> && !kIsMessage<T> && !std::is_convertible_v<T, std::string_view>;

  template <class T>
  static void walk(const JsonCursor& at, const T& value) {
    if constexpr (kIsList<T>) {
      if constexpr (kIsPart<typename T::value_type>) {
        const std::vector<JsonCursor> items = at.items(value.size());
        for (std::size_t i = 0; i < items.size(); ++i) walk(items[i], value[i]);
      }
    } else if constexpr (kIsPart<T>) {
      WrittenCheck inner(at);
      describe(inner, value);
    }
  }

  const JsonCursor& at_;
};

}  // namespace

void check_written(const JsonCursor& at, const Document& document) {
  WrittenCheck check(at);
  describe(check, document);
}

}  // namespace report
