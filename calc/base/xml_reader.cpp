#include "calc/base/xml_reader.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/base/text.h"
#include "calc/base/text_lengths.h"
#include "calc/base/utf8.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace calc {
namespace {

bool contains(const Names& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::string allowed_list(const Names& names) {
  return names.empty() ? std::string("none") : join_choices(names);
}

std::string count_of_numbers(std::size_t count) {
  return count == 1 ? std::string("1 number") : fmt::format("{} numbers", count);
}

std::string shown(std::string_view word) { return shorten_utf8(word, 30); }

}  // namespace

bool is_id_character(char c) {
  return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_' ||
         c == '.' || c == ':' || c == '-';
}

bool is_id(std::string_view text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), is_id_character);
}

ElementReader::ElementReader(const XmlElement& element, Diagnostics& diagnostics)
    : element_(element), diagnostics_(diagnostics), errors_before_(diagnostics.error_count()) {}

const SourceLocation& ElementReader::where(std::string_view name) const {
  const XmlAttribute* attribute = element_.find(name);
  return attribute != nullptr ? attribute->where : element_.where;
}

void ElementReader::allow(const ElementRow& row) {
  allow_attributes(row);
  allow_children(row);
}

void ElementReader::allow_attributes(const ElementRow& row, const Names& besides) {
  Names names = attribute_names(row);
  names.insert(names.end(), besides.begin(), besides.end());
  for (const XmlAttribute& attribute : element_.attributes) {
    if (contains(names, attribute.name)) continue;
    report(DiagnosticId::unknown_attribute, attribute.where, attribute.name, element_.name,
           allowed_list(names), suggestion(attribute.name, names));
  }
}

void ElementReader::allow_children(const ElementRow& row) {
  const Names names = child_names(row);
  for (const XmlElement& child : element_.children) {
    if (contains(names, child.name)) continue;
    report(DiagnosticId::unknown_element, child.where, child.name, element_.name,
           allowed_list(names), suggestion(child.name, names));
  }
}

bool ElementReader::exclude(std::string_view one, std::string_view other) {
  if (!has(one) || !has(other)) return true;
  report(DiagnosticId::exclusive_attributes, where(other), element_.name, one, other);
  return false;
}

bool ElementReader::require_together(std::string_view one, std::string_view other) {
  if (has(one) == has(other)) return true;
  if (!has(one)) std::swap(one, other);
  report(DiagnosticId::missing_partner, where(one), element_.name, one, other);
  return false;
}

const XmlAttribute* ElementReader::require(std::string_view name) {
  const XmlAttribute* attribute = element_.find(name);
  if (attribute == nullptr) {
    report(DiagnosticId::missing_attribute, element_.where, element_.name, name);
  } else if (trim(attribute->value).empty()) {
    report(DiagnosticId::empty_attribute, attribute->where, name, element_.name);
    return nullptr;
  }
  return attribute;
}

std::optional<double> ElementReader::parse(const XmlAttribute& attribute, std::string_view word,
                                           const NumberRange& range) {
  const std::optional<double> value = parse_number(word);
  if (!value) {
    const bool has_comma = word.find(',') != word.npos;
    report(DiagnosticId::not_a_number, attribute.where, attribute.name, element_.name, shown(word),
           range.words, has_comma ? " (decimals have a point, blanks separate numbers)" : "");
    return std::nullopt;
  }
  if (!range.contains(*value)) {
    report(DiagnosticId::number_out_of_range, attribute.where, attribute.name, element_.name,
           shown(word), range.words);
    return std::nullopt;
  }
  return value;
}

std::optional<int> ElementReader::parse(const XmlAttribute& attribute, std::string_view word,
                                        int low) {
  const std::string words = fmt::format("a whole number from {}", low);
  const std::optional<int> value = parse_integer(word);
  if (!value) {
    report(DiagnosticId::not_an_integer, attribute.where, attribute.name, element_.name,
           shown(word), words);
    return std::nullopt;
  }
  if (*value < low) {
    report(DiagnosticId::number_out_of_range, attribute.where, attribute.name, element_.name,
           shown(word), words);
    return std::nullopt;
  }
  return value;
}

namespace {

bool is_short_enough(ElementReader& reader, const XmlAttribute& attribute, std::size_t most) {
  if (attribute.value.size() <= most) return true;
  reader.report(DiagnosticId::number_out_of_range, attribute.where, attribute.name,
                reader.element().name, fmt::format("a text of {} bytes", attribute.value.size()),
                fmt::format("at most {} bytes", most));
  return false;
}

}  // namespace

std::string ElementReader::id(std::string_view name) {
  const XmlAttribute* attribute = require(name);
  if (attribute == nullptr || !is_short_enough(*this, *attribute, kLongestId)) return {};
  if (is_id(attribute->value)) return attribute->value;
  report(DiagnosticId::not_an_id, attribute->where, name, element_.name, shown(attribute->value));
  return {};
}

std::vector<std::string> ElementReader::ids(std::string_view name, std::size_t most) {
  const XmlAttribute* attribute = require(name);
  // So many of the longest, with blanks between: what the schema takes is taken.
  const std::size_t longest = most * (kLongestId + 1);
  if (attribute == nullptr || !is_short_enough(*this, *attribute, longest)) return {};
  const std::vector<std::string_view> words = split_words(attribute->value);
  if (words.empty() || words.size() > most) {
    report(DiagnosticId::wrong_number_count, attribute->where, name, element_.name,
           fmt::format("1 to {} ids separated by blanks", most), words.size());
    return {};
  }
  for (const std::string_view word : words) {
    if (is_id(word) && word.size() <= kLongestId) continue;
    report(DiagnosticId::not_an_id, attribute->where, name, element_.name, shown(word));
    return {};
  }
  return {words.begin(), words.end()};
}

std::string ElementReader::text(std::string_view name) {
  const XmlAttribute* attribute = require(name);
  if (attribute == nullptr || !is_short_enough(*this, *attribute, kLongestText)) return {};
  return attribute->value;
}

std::string ElementReader::text_or(std::string_view name, std::string_view fallback) {
  const XmlAttribute* attribute = element_.find(name);
  if (attribute == nullptr || !is_short_enough(*this, *attribute, kLongestText)) {
    return std::string(fallback);
  }
  return attribute->value;
}

double ElementReader::number(std::string_view name, const NumberRange& range) {
  const XmlAttribute* attribute = require(name);
  if (attribute == nullptr) return 0.0;
  return parse(*attribute, trim(attribute->value), range).value_or(0.0);
}

double ElementReader::number_or(std::string_view name, const NumberRange& range, double fallback) {
  return has(name) ? number(name, range) : fallback;
}

std::optional<double> ElementReader::optional_number(std::string_view name,
                                                     const NumberRange& range) {
  if (!has(name)) return std::nullopt;
  return number(name, range);
}

int ElementReader::integer(std::string_view name, int low) {
  const XmlAttribute* attribute = require(name);
  if (attribute == nullptr) return low;
  return parse(*attribute, trim(attribute->value), low).value_or(low);
}

std::size_t ElementReader::choice(std::string_view name, const Names& choices) {
  const XmlAttribute* attribute = require(name);
  if (attribute == nullptr) return 0;
  const auto found = std::find(choices.begin(), choices.end(), attribute->value);
  if (found != choices.end()) return static_cast<std::size_t>(found - choices.begin());
  report(DiagnosticId::unknown_value, attribute->where, name, element_.name,
         shown(attribute->value), allowed_list(choices),
         attribute->value.size() > 1 ? suggestion(attribute->value, choices) : std::string());
  return 0;
}

std::size_t ElementReader::choice_or(std::string_view name, const Names& choices,
                                     std::size_t fallback) {
  return has(name) ? choice(name, choices) : fallback;
}

std::vector<double> ElementReader::numbers(std::string_view name, std::size_t count,
                                           std::string_view words, const NumberRange& range) {
  std::vector<double> values(count, 0.0);
  const XmlAttribute* attribute = require(name);
  if (attribute == nullptr) return values;
  const std::vector<std::string_view> parts = split_words(attribute->value);
  std::size_t good = 0;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const std::optional<double> value = parse(*attribute, parts[i], range);
    if (!value) return values;
    if (i < count) values[i] = *value;
    ++good;
  }
  if (good != count) {
    report(DiagnosticId::wrong_number_count, attribute->where, name, element_.name, words,
           count_of_numbers(good));
  }
  return values;
}

std::vector<int> ElementReader::integers(std::string_view name, std::size_t count,
                                         std::string_view words, int low) {
  std::vector<int> values(count, low);
  const XmlAttribute* attribute = require(name);
  if (attribute == nullptr) return values;
  const std::vector<std::string_view> parts = split_words(attribute->value);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const std::optional<int> value = parse(*attribute, parts[i], low);
    if (!value) return values;
    if (i < count) values[i] = *value;
  }
  if (parts.size() != count) {
    report(DiagnosticId::wrong_number_count, attribute->where, name, element_.name, words,
           count_of_numbers(parts.size()));
  }
  return values;
}

std::vector<double> ElementReader::number_groups(std::string_view name, std::size_t group,
                                                 std::size_t minimum, std::size_t maximum,
                                                 std::string_view words, const NumberRange& range) {
  const XmlAttribute* attribute = require(name);
  if (attribute == nullptr) return {};
  std::vector<double> values;
  for (const std::string_view part : split_words(attribute->value)) {
    const std::optional<double> value = parse(*attribute, part, range);
    if (!value) return {};
    values.push_back(*value);
  }
  const std::size_t count = values.size();
  if (count % group == 0 && count >= minimum * group && count <= maximum * group) return values;
  report(DiagnosticId::wrong_number_count, attribute->where, name, element_.name, words,
         count_of_numbers(count));
  return {};
}

}  // namespace calc
