#include "report/tools/rules/find_rows.h"

#include "calc/base/text.h"
#include "report/formats/console_lines.h"
#include "report/text/plain_text.h"
#include "report/tools/rules/pack_words.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <utility>

namespace cli {
namespace {

// What German letters are written as where a keyboard does not have them; also letters with a
// separate diaeresis, as some systems store them.
constexpr std::pair<std::string_view, std::string_view> kLetters[] = {
    {"ä", "ae"}, {"ö", "oe"},       {"ü", "ue"},       {"Ä", "ae"},       {"Ö", "oe"}, {"Ü", "ue"},
    {"ß", "ss"}, {"a\u0308", "ae"}, {"o\u0308", "oe"}, {"u\u0308", "ue"}, {"ẞ", "ss"}};

// Beginnings of words that mean the same, in search form. A word of a search that begins with one
// of them also finds the others of its line.
constexpr std::string_view kSynonyms[] = {
    "meeting conference besprech konferenz sitzung",
    "classroom klassenraum klassenraeum klassenzimmer unterricht",
    "office buero",
    "desk schreibtisch",
    "corridor hallway flur korridor verkehrsflaech",
    "waiting warteraum warteraeum wartebereich wartezimmer",
    "cloakroom umkleide garderobe",
    "stair treppe",
    "lift elevator aufzug aufzueg fahrstuhl",
    "toilet restroom washroom lavator waschraum waschraeum",
    "canteen cafeteria kantine mensa",
    "break pausenraum pausenraeum",
    "kitchen kueche",
    "restaurant dining gaststaett speiseraum speisesaal",
    "warehouse storage lager",
    "parking garage parkhaus parkplatz parkplaetz tiefgarage",
    "reception empfang",
    "archive archiv",
    "library bibliothek buecherei",
    "shop sales retail verkauf",
    "lobby foyer eingangshalle",
    "laboratory labor",
    "lecture auditorium hoersaal hoersaele vorlesung",
    "nursery kindergarten kita",
    "hospital clinic doctor krankenhaus krankenhaeus klinik arztpraxis",
    "patient krankenzimmer bettenzimmer",
    "operating surgery operationssaal",
    "gym sporthalle turnhalle",
    "football soccer fussball",
    "assembly montage",
    "board tafel",
};

bool begins_with(std::string_view text, std::string_view start) {
  return text.substr(0, start.size()) == start;
}

// What a row is searched by.
struct RowText {
  std::string ref, names;  // in search form
};

// How well a row fits; the least is the best.
enum class Fit : std::uint8_t { at_word_start, inside_word, by_synonym, none };

bool is_letter_before(std::string_view text, std::size_t at) {
  return at > 0 && text[at - 1] >= 'a' && text[at - 1] <= 'z';
}

Fit fit_of_text(const RowText& row, std::string_view word) {
  if (begins_with(row.ref, word)) return Fit::at_word_start;
  Fit best = Fit::none;
  for (std::size_t at = row.names.find(word); at != std::string::npos;
       at = row.names.find(word, at + 1)) {
    if (!is_letter_before(row.names, at)) return Fit::at_word_start;
    best = Fit::inside_word;
  }
  return best;
}

// A plural in "s" finds the singular, too.
bool is_by_synonym(const RowText& row, std::string_view word) {
  constexpr std::size_t kShortestPlural = 5;
  if (word.size() >= kShortestPlural && word.back() == 's' &&
      fit_of_text(row, word.substr(0, word.size() - 1)) != Fit::none) {
    return true;
  }
  return std::any_of(std::begin(kSynonyms), std::end(kSynonyms), [&](std::string_view line) {
    const std::vector<std::string_view> same = calc::split_words(line);
    const auto is_meant = [&](std::string_view start) { return begins_with(word, start); };
    const auto has = [&](std::string_view start) {
      return fit_of_text(row, start) == Fit::at_word_start;
    };
    return std::any_of(same.begin(), same.end(), is_meant) &&
           std::any_of(same.begin(), same.end(), has);
  });
}

Fit fit_of(const RowText& row, const std::vector<std::string_view>& words) {
  Fit worst = Fit::at_word_start;
  for (const std::string_view word : words) {
    Fit fit = fit_of_text(row, word);
    if (fit == Fit::none && is_by_synonym(row, word)) fit = Fit::by_synonym;
    worst = std::max(worst, fit);
  }
  return worst;
}

}  // namespace

std::string search_form(std::string_view text) {
  const std::string lowered = calc::ascii_lowered(text);  // of German letters the table has both
  std::string form;
  for (std::string_view rest = lowered; !rest.empty();) {
    const auto* letter =
        std::find_if(std::begin(kLetters), std::end(kLetters),
                     [&](const auto& known) { return begins_with(rest, known.first); });
    const bool is_known = letter != std::end(kLetters);
    form += is_known ? letter->second : rest.substr(0, 1);
    rest.remove_prefix(is_known ? letter->first.size() : 1);
  }
  return form;
}

std::string FoundRow::id() const { return pack->full_id() + "/" + row->ref; }

std::vector<FoundRow> find_rows(std::string_view words, const std::vector<rules::RulePack>& packs) {
  const std::string form = search_form(words);
  const std::vector<std::string_view> parts = calc::split_words(form);
  if (parts.empty()) return {};
  std::vector<std::pair<Fit, FoundRow>> found;
  for (const rules::RulePack& pack : packs) {
    for (const rules::RuleRow& row : pack.rows) {
      const Fit fit =
          fit_of({search_form(row.ref), search_form(row.name + " / " + row.name_de)}, parts);
      if (fit != Fit::none) found.push_back({fit, {&pack, &row}});
    }
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<FoundRow> rows;
  rows.reserve(found.size());
  for (const auto& [fit, row] : found) rows.push_back(row);
  return rows;
}

std::string row_list(const std::vector<FoundRow>& rows, std::size_t most) {
  constexpr std::size_t kWidestColumn = 40;
  const std::size_t count = std::min(rows.size(), most);
  std::size_t width = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t own = report::display_width(report::printable(rows[i].id()));
    if (own <= kWidestColumn) width = std::max(width, own);
  }
  std::string text;
  for (std::size_t i = 0; i < count; ++i) {
    const rules::RuleRow& row = *rows[i].row;
    const std::string german = row.name_de.empty() ? "" : " / " + row.name_de;
    const std::string id = report::padded(report::printable(rows[i].id()), width, false);
    text += report::wrapped_lines(id + "  ", report::printable(row.name + german), width + 2,
                                  kTextColumns);
  }
  return text;
}

}  // namespace cli
