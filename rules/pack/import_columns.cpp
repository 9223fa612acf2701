#include "rules/pack/import_columns.h"

#include "calc/base/text.h"
#include "rules/pack/import_plane.h"

#include <fmt/format.h>

#include <utility>
#include <vector>

namespace rules {
namespace {

constexpr std::array<ImportColumn, kImportColumnCount> kColumns{{
    {"ref",
     "reference refno refnumber no nr number row rowno finalref",
     "number of the row: letters, digits, and . - _ :",
     true,
     {"A.1", "A.2"}},
    {"name",
     "activity task use space typeoftask typeoftaskactivityarea typeofinteriortaskoractivity",
     "use of the space",
     true,
     {"aisle between the benches", "repair bench"}},
    {"group", "section heading", "put before the name", false, {"Workshop", "Workshop"}},
    {"plane", "referenceplane", "where the task lies", false, {"floor", "0.9 m"}},
    {"Em_lx",
     "emrequired emreq emmin required illuminance maintainedilluminance eav eavg",
     "maintained average of the task area, above 0 lx; empty if 'notes' says why",
     true,
     {"150", "750"}},
    {"Em_modified_lx",
     "emmod modified",
     "the same at the level 'modified', Em_lx or more",
     false,
     {"200", "1000"}},
    {"Uo", "u0 uomin u0min uniformity", "minimum / average, 0 to 1", false, {"0.40", "0.60"}},
    {"Ra",
     "ramin cri colourrendering colorrendering",
     "colour rendering index, 0 to 100",
     false,
     {"80", "80"}},
    {"RUGL",
     "ruglmax rugl rug ugr ugrl ugrmax ugrlmax ugrlimit",
     "limit of the glare rating, 10 to 30",
     false,
     {"25", "19"}},
    {"Ez_lx",
     "ezm emz ezmin cylindrical cylindricalilluminance",
     "maintained average of the mean cylindrical illuminance",
     false,
     {"50", "150"}},
    {"Ewall_lx", "emwall wall walls", "maintained average of each wall", false, {"50", "150"}},
    {"Eceiling_lx", "emceiling ceiling", "maintained average of the ceiling", false, {"30", "100"}},
    {"trust",
     "",
     "A or confirmed: found in two sources; A-part: only what 'confirmed' names; B or "
     "single-source "
     "(so without this column): in one; anything else: unverified",
     false,
     {"B", "B"}},
    {"confirmed",
     "confirmedfields",
     "of rows of trust A-part: Em_required, Em_modified, Uo, Ra, RUGL, Ez, Em_wall, Em_ceiling, "
     "separated by ;",
     false,
     {"", ""}},
    {"status",
     "finalrefconfidence",
     "dropped_in_final: the row is left out; anything else: it is kept",
     false,
     {"", ""}},
    {"notes",
     "note remark remarks comment comments specificrequirements",
     "of your own, beside the row",
     false,
     {"walked on", "0.9 m: people stand"}},
    {"sources", "source", "where the numbers are from", false, {"own table", "own table"}},
}};

std::vector<std::string> plain_names(const ImportColumn& column) {
  std::vector<std::string> names{plain_column_name(column.name)};
  for (const std::string_view alias : calc::split_words(column.aliases)) names.emplace_back(alias);
  return names;
}

// Capital E with a macron, the macron itself and the small zero, as the standard prints its heads.
constexpr std::array<std::pair<std::string_view, std::string_view>, 3> kPrinted{
    {{"\u0112", "e"}, {"\u0304", ""}, {"\u2080", "0"}}};

std::string meaning_of(std::size_t index) {
  std::string text(kColumns[index].meaning);
  if (index == kPlaneColumn) text += ": " + task_plane_words();
  return text;
}

// Returns lines of at most 80 characters, all with the same indent.
std::string wrapped(std::string_view text, std::size_t indent) {
  constexpr std::size_t kWidth = 80;
  std::string lines, line;
  for (const std::string_view word : calc::split_words(text)) {
    if (!line.empty() && indent + line.size() + 1 + word.size() > kWidth) {
      lines += std::string(indent, ' ') + line + "\n";
      line.clear();
    }
    line += (line.empty() ? "" : " ") + std::string(word);
  }
  return lines + std::string(indent, ' ') + line + "\n";
}

}  // namespace

const std::array<ImportColumn, kImportColumnCount>& import_columns() { return kColumns; }

const std::array<std::string_view, kImportColumnCount>& import_column_names() {
  static const auto kNames = [] {
    std::array<std::string_view, kImportColumnCount> names;
    for (std::size_t i = 0; i < kImportColumnCount; ++i) names[i] = kColumns[i].name;
    return names;
  }();
  return kNames;
}

std::string plain_column_name(std::string_view written) {
  std::string plain;
  while (!written.empty()) {
    bool is_printed = false;
    for (const auto& [printed, letters] : kPrinted) {
      if (!written.starts_with(printed)) continue;
      plain += letters;
      written.remove_prefix(printed.size());
      is_printed = true;
      break;
    }
    if (is_printed) continue;
    const char c = written.front();
    if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9')) plain += c;
    if (c >= 'A' && c <= 'Z') plain += static_cast<char>(c - 'A' + 'a');
    written.remove_prefix(1);
  }
  constexpr std::string_view kUnit = "lx";
  if (plain.size() > kUnit.size() && plain.ends_with(kUnit)) {
    plain.resize(plain.size() - kUnit.size());
  }
  return plain;
}

std::string_view import_column_name(std::string_view written) {
  const std::string plain = plain_column_name(written);
  for (const ImportColumn& column : kColumns) {
    for (const std::string& name : plain_names(column)) {
      if (name == plain) return column.name;
    }
  }
  return written;
}

std::string import_column_suggestion(std::string_view written) {
  std::string nearest;
  const std::string plain = plain_column_name(written);
  std::vector<std::string> names;
  for (const ImportColumn& column : kColumns) {
    for (std::string& name : plain_names(column)) names.push_back(std::move(name));
  }
  nearest = calc::suggestion(plain, std::vector<std::string_view>(names.begin(), names.end()));
  for (const std::string& name : names) {
    if (nearest != fmt::format("; did you mean '{}'?", name)) continue;
    return fmt::format("; did you mean '{}'?", import_column_name(name));
  }
  return {};
}

std::string import_template() {
  std::string header, rows[2];
  for (const ImportColumn& column : kColumns) {
    const char* comma = header.empty() ? "" : ",";
    header += comma + std::string(column.name);
    for (std::size_t i = 0; i < 2; ++i) rows[i] += comma + std::string(column.examples[i]);
  }
  return header + "\n" + rows[0] + "\n" + rows[1] + "\n";
}

std::string import_columns_help() {
  std::string text =
      "Columns, in any order; case, blanks and signs in their names do not matter, and what\n"
      "is empty is not required ('--template' prints a table to begin with):\n";
  for (std::size_t i = 0; i < kImportColumnCount; ++i) {
    const ImportColumn& column = kColumns[i];
    text += fmt::format("  {}{}\n", column.name, column.is_needed ? " (needed)" : "");
    text += wrapped(meaning_of(i), 6);
    if (column.aliases.empty()) continue;
    text +=
        wrapped("or " + fmt::format("{}", fmt::join(calc::split_words(column.aliases), ", ")), 6);
  }
  return text;
}

}  // namespace rules
