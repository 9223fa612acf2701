#include "calc/photometry/read/ies_header.h"

#include "calc/base/line_cursor.h"
#include "calc/base/text.h"
#include "calc/photometry/read/text_encoding.h"

#include <algorithm>
#include <array>

namespace calc {
namespace {

// Locale-free; without blanks when wanted, since tags with one after the colon are common.
std::string upper(std::string_view text, bool without_blanks) {
  std::string result;
  for (const char c : text) {
    if (without_blanks && (c == ' ' || c == '\t')) continue;
    result += c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  }
  return result;
}

struct Tag {
  std::string_view text;
  Lm63Version version;
};
constexpr std::array kTags{
    Tag{"IESNA:LM-63-1986", Lm63Version::v1986}, Tag{"IESNA86", Lm63Version::v1986},
    Tag{"IESNA:LM-63-1991", Lm63Version::v1991}, Tag{"IESNA91", Lm63Version::v1991},
    Tag{"IESNA:LM-63-1995", Lm63Version::v1995}, Tag{"IESNA95", Lm63Version::v1995},
    Tag{"IESNA:LM-63-2002", Lm63Version::v2002}, Tag{"IES:LM-63-2002", Lm63Version::v2002},
    Tag{"IES:LM-63-2019", Lm63Version::v2019},   Tag{"IESNA:LM-63-2019", Lm63Version::v2019},
};

void read_version(Lm63Header& header, std::string_view first_line) {
  const std::string tag = upper(first_line, true);
  header.tag = utf8_from_file_text(trim(first_line));
  for (const Tag& known : kTags) {
    if (!tag.starts_with(known.text)) continue;
    header.version = known.version;
    return;
  }
  // 1986 files have no tag, only free text; keywords in brackets came with the tags.
  const bool tagged = tag.starts_with("IESNA") || tag.starts_with("IES:") || tag.starts_with('[');
  header.version_known = !tagged;
  header.version = tagged ? Lm63Version::v2002 : Lm63Version::v1986;
  if (!tagged) header.tag = "LM-63-1986";
}

// The text after "TILT=" of a line "TILT=NONE", blanks and lower case allowed.
std::optional<std::string_view> tilt_of(std::string_view line) {
  const std::string_view text = trim(line);
  if (text.size() < 5 || upper(text.substr(0, 4), false) != "TILT") return std::nullopt;
  const std::string_view after = trim(text.substr(4));
  if (!after.starts_with('=')) return std::nullopt;
  return trim(after.substr(1));
}

void read_keyword(Lm63Header& header, std::string_view line) {
  const std::string_view text = trim(line);
  const std::size_t end = text.find(']');
  if (!text.starts_with('[') || end == std::string_view::npos) return;
  const std::string name = upper(trim(text.substr(1, end - 1)), false);
  const std::string value = utf8_from_file_text(trim(text.substr(end + 1)));
  if (name == "MORE" && !header.keywords.empty()) {
    header.keywords.back().second += " " + value;
  } else {
    header.keywords.emplace_back(name, value);
  }
}

}  // namespace

std::string Lm63Header::keyword(std::string_view name) const {
  const auto found = std::find_if(keywords.begin(), keywords.end(),
                                  [&](const auto& k) { return k.first == name; });
  return found == keywords.end() ? std::string() : found->second;
}

std::optional<Lm63Header> read_lm63_header(std::string_view text) {
  Lm63Header header;
  LineCursor lines(text);
  bool at_start = true;
  while (const std::optional<std::string_view> line = lines.next()) {
    if (const std::optional<std::string_view> tilt = tilt_of(*line)) {
      if (at_start) read_version(header, "");
      header.tilt = utf8_from_file_text(*tilt);
      header.tilt_line = lines.line();
      header.numbers = lines.rest();
      return header;
    }
    if (at_start && !trim(*line).empty()) {
      read_version(header, *line);
      at_start = false;
    }
    read_keyword(header, *line);
  }
  return std::nullopt;
}

std::vector<std::string_view> missing_keywords(const Lm63Header& header) {
  struct Required {
    std::string_view name;
    bool in_1991;  // else from 2002 on
  };
  static constexpr std::array kRequired{Required{"TEST", true}, Required{"TESTLAB", false},
                                        Required{"ISSUEDATE", false}, Required{"MANUFAC", true}};
  const bool since_2002 = header.version >= Lm63Version::v2002;
  std::vector<std::string_view> missing;
  for (const Required& required : kRequired) {
    if (!since_2002 && !(header.version == Lm63Version::v1991 && required.in_1991)) continue;
    const bool present = std::any_of(header.keywords.begin(), header.keywords.end(),
                                     [&](const auto& k) { return k.first == required.name; });
    if (!present) missing.push_back(required.name);
  }
  return missing;
}

}  // namespace calc
