// The map to start from: see suggest_ifc_map() in ifc_import.h.
#include "calc/base/text.h"
#include "calc/base/utf8.h"
#include "report/tools/import/ifc_design.h"
#include "report/tools/import/ifc_import.h"
#include "report/tools/import/map_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace cli {
namespace {

constexpr std::size_t kMostListed = 200;  // of each kind: a map is for people to read
constexpr std::size_t kMostOfThem = 3;    // examples

// What things of one name have in common.
struct NameFacts {
  std::size_t count = 0;
  std::set<std::string> storeys, uses, numbers;
  std::set<double> heights;
  std::vector<std::pair<std::string, std::set<std::string>>> attributes;
};
using FactsByName = std::map<std::string, NameFacts>;

std::string several(std::size_t count, const char* one, const char* more) {
  return fmt::format("{} {}", count, count == 1 ? one : more);
}

// Programs give things of one kind their numbers behind a colon: "Desk:1600:345231".
std::string pattern_of(const std::string& name) {
  const std::size_t colon = name.rfind(':');
  const bool is_numbered = colon != name.npos && colon > 0 && colon + 1 < name.size() &&
                           name.find_first_not_of("0123456789", colon + 1) == name.npos;
  return is_numbered ? name.substr(0, colon + 1) + "*" : name;
}

template <class Values, class Words>
std::string examples(const Values& values, const Words& words) {
  std::string text;
  std::size_t shown = 0;
  for (const auto& value : values) {
    if (shown++ == kMostOfThem) return text + " ...";
    text += (text.empty() ? "" : ", ") + words(value);
  }
  return text;
}
std::string examples(const std::set<std::string>& values) {
  return examples(values, quoted_for_map);
}
std::string examples(const std::set<double>& values) {
  return examples(values, [](double value) { return fmt::format("{:.6g}", value); });
}

// Calls with each name and its facts, in their order; says how many are not listed.
template <class Call>
void list_names(const FactsByName& names, std::string& text, Call call) {
  std::size_t shown = 0;
  for (const auto& [name, facts] : names) {
    if (shown++ == kMostListed) {
      text += fmt::format("# {}\n", calc::and_more(names.size() - kMostListed));
      return;
    }
    call(name, facts);
  }
}

void add_place(const std::string& storey, NameFacts& facts) {
  ++facts.count;
  if (!storey.empty()) facts.storeys.insert(storey);
}

std::string on_storeys(const NameFacts& facts) {
  return facts.storeys.empty() ? "" : ", on " + examples(facts.storeys);
}

std::string rooms_text(const Design& design) {
  FactsByName names;
  std::map<std::string, std::size_t> storeys;
  for (const DesignRoom& room : design.room) {
    ++storeys[room.storey];
    NameFacts& facts = names[room.name];
    add_place(room.storey, facts);
    if (!room.number.empty()) facts.numbers.insert(room.number);
    if (!room.use.empty()) facts.uses.insert(room.use);
    if (room.height_m) facts.heights.insert(*room.height_m);
  }
  std::string text = "\n# Storeys\n";
  for (const auto& [storey, count] : storeys) {
    text += fmt::format("#   {}: {}\n", storey.empty() ? "on none" : quoted_for_map(storey),
                        several(count, "room", "rooms"));
  }
  text +=
      "\n# Rooms by their names. `layer` is a pattern for name, number, use or storey; without it\n"
      "# a [[room]] takes all that no one before it took. Heights are those of the file.\n"
      "# [[room]]\n# height = 2.8  # where the file has none\n"
      "# reflectances = [0.7, 0.5, 0.2]  # ceiling, walls, floor\n\n";
  list_names(names, text, [&](const std::string& name, const NameFacts& facts) {
    text += fmt::format("# {}: {}{}; heights {} m", name.empty() ? "No name" : quoted_for_map(name),
                        several(facts.count, "time", "times"), on_storeys(facts),
                        examples(facts.heights));
    if (!facts.numbers.empty()) text += "; numbers " + examples(facts.numbers);
    if (!facts.uses.empty()) text += "; use " + examples(facts.uses);
    text += "\n";
    if (name.empty()) return;
    text += fmt::format(
        "# [[room]]\n# layer = {}\n# height = 2.8\n# reflectances = [0.7, 0.5, 0.2]\n\n",
        quoted_for_map(name));
  });
  return text;
}

std::string luminaires_text(const Design& design) {
  FactsByName names;
  for (const DesignLuminaire& one : design.luminaire) {
    NameFacts& facts = names[one.type];
    add_place(one.storey, facts);
    facts.heights.insert(one.position_m.z + design.origin_m.z);
    for (const auto& [name, value] : one.attribute) {
      const auto known =
          std::find_if(facts.attributes.begin(), facts.attributes.end(),
                       [&name = name](const auto& other) { return other.first == name; });
      auto& values = known != facts.attributes.end()
                         ? known->second
                         : facts.attributes.emplace_back(name, std::set<std::string>()).second;
      if (values.size() <= kMostOfThem) values.insert(value);
    }
  }
  std::string text =
      "\n# Types of luminaires, with z in metres. Wall switches are often called light fixtures:\n"
      "# ignore = [\"*switch*\"]\n\n";
  list_names(names, text, [&](const std::string& name, const NameFacts& facts) {
    text += fmt::format("# {}: {}{}; z {}\n", quoted_for_map(name),
                        several(facts.count, "time", "times"), on_storeys(facts),
                        examples(facts.heights));
    for (const auto& [attribute, values] : facts.attributes) {
      text += fmt::format("#   attribute {}: {}\n", calc::printable(attribute), examples(values));
    }
    text += fmt::format(
        "# [[luminaire]]\n# type = {}\n# photometry = \"photometry/FILE.ldt\"\n# height = "
        "[\"z\", 2.8]  # or \"attribute:NAME\"\n\n",
        quoted_for_map(name));
  });
  return text;
}

std::string furniture_text(const Design& design) {
  FactsByName names;
  for (const DesignBox& box : design.box) {
    NameFacts& facts = names[pattern_of(box.name)];
    ++facts.count;
    facts.heights.insert(box.size_m.z);
  }
  std::string text = "\n# Furniture: boxes around bodies. Numbers behind a last colon are one *.\n";
  list_names(names, text, [&](const std::string& name, const NameFacts& facts) {
    text += fmt::format("# {}: {}; heights {} m\n", name.empty() ? "No name" : quoted_for_map(name),
                        several(facts.count, "time", "times"), examples(facts.heights));
    if (name.empty()) return;
    text += fmt::format(
        "# [[furniture]]\n# type = {}\n# height = 0.75  # that of the file counts\n"
        "# reflectance = 0.5\n\n",
        quoted_for_map(name));
  });
  return text;
}

}  // namespace

std::optional<std::string> suggest_ifc_map(std::string_view bytes, const std::string& file,
                                           const std::string& unit, std::string& problem) {
  const std::optional<Design> design = ifc_without_map(bytes, file, unit, problem);
  if (!design) return std::nullopt;
  std::string text = fmt::format(
      "# A map for 'luxgate import {}': remove the # from the parts that you need, and fill in\n"
      "# facts that no model has. Patterns: * and ? match any characters.\n\n"
      "# The model's unit is {} ({}).\n# unit = \"mm\"\n",
      calc::printable(std::filesystem::path(file).filename().string()),
      calc::printable(design->unit), calc::printable(design->unit_reason));
  text += rooms_text(*design) + luminaires_text(*design) + furniture_text(*design);
  text += "\n# Objects that an import will not take, or that you should check\n";
  for (const DesignNote& note : design->note) {
    if (note.kind == DesignNote::Kind::taken) continue;
    text += fmt::format("#   {} x {}: {}\n", note.count, calc::printable(note.what),
                        calc::printable(note.why));
  }
  return text;
}

}  // namespace cli
