#include "report/result_file/read_json.h"

#include "calc/base/encoding.h"
#include "calc/base/file_kind.h"
#include "calc/base/text.h"
#include "calc/base/utf8.h"
#include "report/document/luminaire_labels.h"
#include "report/result_file/contradiction.h"
#include "report/result_file/describe.h"
#include "report/result_file/json_cursor.h"
#include "report/result_file/message_json.h"
#include "report/result_file/result_fields.h"
#include "report/result_file/written_check.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace report {
namespace {

template <class T>
void read(const JsonCursor& at, T& value, const About& about);

// The text at this place, one of the choices if there are any.
std::string read_text(const JsonCursor& at, const About& about,
                      const std::vector<std::string_view>& choices) {
  std::string text = at.text();
  if (choices.empty() || std::find(choices.begin(), choices.end(), text) != choices.end())
    return text;
  if (*about.unknown != '\0') at.refuse(about.unknown);
  at.refuse(fmt::format("one of '{}' is needed", fmt::join(choices, "', '")));
}

// One object of the file, key by key. Throws BadJson.
class Reader : public Visitor {
 public:
  explicit Reader(const JsonCursor& at) : at_(at) {}

  void refuse_if(bool is_bad, const char* key, const char* words) {
    if (is_bad) at_[key].refuse(words);
  }

  void constant(const char* key, const char* value) {
    if (at_[key].text() != value) at_[key].refuse(fmt::format("'{}' is needed", value));
  }
  void constant(const char* key, int value) { at_[key].whole(value, value); }

  template <class T>
  void field(const char* key, T&& value, const About& about = {}) {
    const std::optional<JsonCursor> found = find(key, about);
    if (!found) return;
    using Value = std::remove_cvref_t<T>;
    if constexpr (kIsMessage<Value>) {
      value = read_message(*found, at_.find(message_key(key)));
      return;
    } else if constexpr (kIsMessageList<Value>) {
      value = read_messages(*found, at_.find(message_key(key)));
      return;
    } else if (!about.null_if.value_or(false)) {
      return read(*found, value, about);
    }
    if (!found->is_null()) found->refuse("null is needed, because nothing is judged");
  }
  template <class Fields>
  void object(const char* key, const Fields& fields, const About& about = {}) {
    if (const std::optional<JsonCursor> found = find(key, about)) {
      Reader reader(*found);
      fields(reader);
    }
  }
  template <class Item, class Cells>
  void rows(const char* key, std::vector<Item>& items, const Cells& cells) {
    for (const JsonCursor& at : at_[key].items()) {
      Row row{at};
      cells(row, items.emplace_back());
    }
  }

 private:
  struct Row {
    template <class... Cell>
    void operator()(Cell&&... cell) {
      const std::vector<JsonCursor> cells = at.items(sizeof...(cell));
      std::size_t next = 0;
      (read(cells[next++], cell, {}), ...);
    }
    void refuse_if(bool is_bad, const char* words) const {
      if (is_bad) at.refuse(words);
    }

    const JsonCursor& at;
  };

  std::optional<JsonCursor> find(const char* key, const About& about) const {
    return about.presence.may_lack ? at_.find(key) : at_[key];
  }

  const JsonCursor& at_;
};

// "a number from 0 to 1 is needed"; a field may have any of the four bounds.
std::string needed_words(const About& about) {
  std::string words = "a number";
  const auto add = [&](const char* word, const std::optional<double>& bound) {
    if (bound)
      words += fmt::format("{} {} {:g}", words == "a number" || *word == 't' ? "" : " and", word,
                           *bound);
  };
  add("from", about.least);
  add("to", about.most);
  add("above", about.above);
  add("below", about.below);
  return words + " is needed";
}

double number_within(const JsonCursor& at, const About& about) {
  const double value = at.finite();
  const bool is_within =
      value >= about.least.value_or(value) && value <= about.most.value_or(value);
  const bool is_between =
      (!about.above || value > *about.above) && (!about.below || value < *about.below);
  if (!is_within || !is_between) at.refuse(needed_words(about));
  return value;
}

void read_line(const JsonCursor& at, Line& line) {
  const std::vector<JsonCursor> ends = at.items(4);
  line = {glm::dvec2(ends[0].finite(), ends[1].finite()),
          glm::dvec2(ends[2].finite(), ends[3].finite())};
}

template <class T>
void read(const JsonCursor& at, T& value, const About& about) {
  if constexpr (kIsOrNull<T>) {
    value.value = at.is_null() ? value.none : at.finite();
  } else if constexpr (kIsOptional<T>) {
    // A key that may be missing is missing, not null.
    value.reset();
    if (about.presence.may_lack || !at.is_null()) read(at, value.emplace(), about);
  } else if constexpr (Vector<T>) {
    const std::vector<JsonCursor> items = at.items(T::length());
    for (glm::length_t i = 0; i < T::length(); ++i)
      value[i] = items[static_cast<std::size_t>(i)].finite();
  } else if constexpr (std::is_same_v<T, Line>) {
    read_line(at, value);
  } else if constexpr (kIsList<T>) {
    value.clear();
    for (const JsonCursor& item : at.items()) read(item, value.emplace_back(), about);
  } else if constexpr (Named<T>) {
    value = *calc::find_value<T>(read_text(at, about, choices_of<T>(about)));
  } else if constexpr (std::is_same_v<T, std::string>) {
    value = read_text(at, about, about.choices);
  } else if constexpr (std::is_same_v<T, bool>) {
    value = at.flag();
  } else if constexpr (std::is_same_v<T, double>) {
    value = number_within(at, about);
  } else if constexpr (std::is_same_v<T, int>) {
    const auto least = static_cast<std::int64_t>(about.least.value_or(0.0));
    value = static_cast<int>(at.whole(least, std::numeric_limits<int>::max()));
  } else if constexpr (std::is_unsigned_v<T>) {
    value = at.count(static_cast<std::uint64_t>(about.least.value_or(0.0)));
  } else {
    Reader reader(at);
    describe(reader, value);
    if constexpr (std::is_same_v<T, calc::Estimate>) value = settled(value);
  }
}

// What follows from the values that a file has.
void complete(const SpacePart& space, PlanePart& plane) {
  plane.space_id = space.id;
  for (rules::Finding& finding : plane.findings) {
    finding.requirement.plane_id = plane.id;
    finding.requirement.derived = plane.derived;
    // Of results of earlier versions it is 0 where there is none.
    const bool has_none =
        finding.requirement.limit == 0.0 || finding.verdict == rules::Verdict::fail;
    if (finding.margin == 0.0 && has_none) finding.margin = no_estimate().value;
  }
  if (!plane.is_computed) return;
  calc::SensorGrid& grid = plane.grid;
  grid.kernel = plane.kernel;
  grid.derived = plane.derived;
  for (const PointRow& point : plane.points) {
    grid.position_m.push_back(point.position_m);
    grid.normal.push_back(point.normal);
    grid.column.push_back(point.column);
    grid.row.push_back(point.row);
  }
  if (calc::is_plain_number(plane.derived)) {
    plane.average = plane.uniformity_min_avg = plane.uniformity_min_max = no_estimate();
  }
  settle_estimates(plane);
}

// Of a key that stands twice the last one would count, whatever people read before it.
class KeysOnce {
 public:
  bool operator()(int /*depth*/, nlohmann::json::parse_event_t event, nlohmann::json& parsed) {
    using Event = nlohmann::json::parse_event_t;
    if (event == Event::object_start) open_.emplace_back();
    if (event == Event::object_end) open_.pop_back();
    if (event != Event::key) return true;
    std::vector<std::string>& keys = open_.back();
    std::string key = parsed.get<std::string>();
    if (std::find(keys.begin(), keys.end(), key) != keys.end()) {
      throw BadJson(fmt::format("the key '{}' is given twice in one object", calc::printable(key)));
    }
    keys.push_back(std::move(key));
    return true;
  }

 private:
  std::vector<std::vector<std::string>> open_;
};

}  // namespace

std::optional<Document> read_json(std::string_view bytes, std::string& problem,
                                  std::string_view name) {
  constexpr std::size_t kHeadBytes = 200;
  const bool is_json = calc::trim(calc::start_of_text(bytes, kHeadBytes)).starts_with('{');
  problem = calc::other_kind_problem(bytes, name, calc::FileUse::result, is_json);
  if (!problem.empty()) return std::nullopt;
  try {
    // Shells that write UTF-16 where a program's output goes into a file are not rare.
    const calc::DecodedText text = calc::decoded_text(std::string(bytes));
    if (!text.problem.empty()) {
      problem = text.problem;
      return std::nullopt;
    }
    const nlohmann::json json = nlohmann::json::parse(text.utf8, KeysOnce());
    Document document;
    read(JsonCursor(json), document, {});
    for (ProjectPart& project : document.projects) {
      for (SpacePart& space : project.spaces) {
        for (PlanePart& plane : space.planes) complete(space, plane);
      }
      label_luminaires(project);
    }
    refuse_contradictions(document);
    check_written(JsonCursor(json), document);
    return document;
  } catch (const BadJson& bad) {
    problem = bad.what();
  } catch (const nlohmann::json::parse_error& error) {
    problem = error.byte > bytes.size()
                  ? "it ends too early; it is an incomplete JSON file"
                  : fmt::format("it is not JSON; the first error is at byte {}", error.byte);
  } catch (const nlohmann::json::exception& error) {
    problem = std::string("it is not JSON: ") + error.what();
  }
  return std::nullopt;
}

}  // namespace report
