#include "report/tools/import/import_map.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/base/file_kind.h"
#include "calc/base/text.h"
#include "calc/base/units.h"
#include "calc/base/utf8.h"

#include <fmt/format.h>

#include <toml++/toml.h>

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <utility>

namespace cli {
namespace {

constexpr std::size_t kMostBytes = 1 << 18;  // the parser recurses, a part of a dotted key a level

enum class MapValue { text, texts, flag, number, numbers3, heights };

// A key of a table; "" = of the file itself.
struct MapKey {
  std::string_view table, name;
  MapValue kind;
  bool is_needed;
  double low, high;  // of numbers, inclusive
  std::string_view words;
};
constexpr std::array kKeys = {
    MapKey{"", "unit", MapValue::text, false, 0, 0,
           "m, cm, mm, in or ft: the unit of the drawing. It overrides the file"},
    MapKey{"", "name", MapValue::text, false, 0, 0, "of the project"},
    MapKey{"", "ignore", MapValue::texts, false, 0, 0, "layers that are not read"},
    MapKey{"room", "layer", MapValue::text, false, 0, 0,
           "of closed outlines; lines whose ends meet are joined. DLX_*CONT if not given"},
    MapKey{"room", "names", MapValue::text, false, 0, 0,
           "layer of texts; those in an outline name the room. DLX_*DESC if not given"},
    MapKey{"room", "height", MapValue::number, true, 1.0, 100.0, "metres"},
    MapKey{"room", "reflectances", MapValue::numbers3, true, 0.0, 1.0, "ceiling, walls, floor"},
    MapKey{"room", "floor", MapValue::number, false, -1.0e4, 1.0e4,
           "height of the floor in metres, instead of that of the outline"},
    MapKey{"room", "close", MapValue::flag, false, 0, 0,
           "true: an outline whose ends are apart is closed by a straight line"},
    MapKey{"luminaire", "type", MapValue::text, true, 0, 0, "name of the block"},
    MapKey{"luminaire", "layer", MapValue::text, false, 0, 0, "of the block reference"},
    MapKey{"luminaire", "photometry", MapValue::text, true, 0, 0,
           "a photometry file, from the folder of the map; copied beside the project"},
    MapKey{"luminaire", "height", MapValue::heights, true, 0.0, 1000.0,
           "metres above the floor, or \"z\": as in the drawing, or \"attribute:NAME\" in the "
           "drawing's unit; a list: the first with a value"},
    MapKey{"luminaire", "group", MapValue::text, false, 0, 0,
           "name of an attribute: its value is the dimming group"},
    MapKey{"luminaire", "turn", MapValue::number, false, -360.0, 360.0,
           "degrees from the block's x axis to C0, counter-clockwise; 0 if not given"},
    MapKey{"luminaire", "flux-lm", MapValue::number, false, 1.0e-3, 1.0e9, "instead of the file's"},
    MapKey{"luminaire", "power-w", MapValue::number, false, 1.0e-3, 1.0e9, "instead of the file's"},
    MapKey{"luminaire", "maintenance-factor", MapValue::number, false, 1.0e-3, 1.0, ""},
    MapKey{"furniture", "type", MapValue::text, false, 0, 0, "name of the block"},
    MapKey{"furniture", "layer", MapValue::text, false, 0, 0,
           "of block references or rectangles; this or type is needed"},
    MapKey{"furniture", "height", MapValue::number, true, 1.0e-3, 100.0,
           "metres, of the box that it becomes, from the floor"},
    MapKey{"furniture", "reflectance", MapValue::number, true, 0.0, 1.0, ""},
    MapKey{"plane", "layer", MapValue::text, true, 0, 0, "of closed outlines"},
    MapKey{"plane", "height", MapValue::number, true, 0.0, 100.0, "metres above the floor"},
    MapKey{"route", "layer", MapValue::text, true, 0, 0, "of polylines"},
    MapKey{"route", "width", MapValue::number, true, 1.0e-3, 100.0, "metres"}};
constexpr std::array<std::string_view, 5> kTables = {"room", "luminaire", "furniture", "plane",
                                                     "route"};

std::vector<std::string_view> keys_of(std::string_view table) {
  std::vector<std::string_view> names;
  for (const MapKey& key : kKeys) {
    if (key.table == table) names.push_back(key.name);
  }
  if (table.empty()) names.insert(names.end(), kTables.begin(), kTables.end());
  return names;
}

const MapKey* find_map_key(std::string_view table, std::string_view name) {
  const auto* key = std::find_if(kKeys.begin(), kKeys.end(), [&](const MapKey& one) {
    return one.table == table && one.name == name;
  });
  return key == kKeys.end() ? nullptr : key;
}

std::optional<double> number_of(const toml::node& node) {
  if (const auto* whole = node.as_integer()) return static_cast<double>(whole->get());
  if (const auto* real = node.as_floating_point()) return real->get();
  return std::nullopt;
}

std::string range_words(const MapKey& key) {
  return fmt::format("a number from {:g} to {:g}", key.low, key.high);
}

// The values of a table, checked against their keys.
struct Values {
  std::map<std::string, std::string, std::less<>> text;
  std::map<std::string, std::vector<std::string>, std::less<>> texts;
  std::map<std::string, std::vector<double>, std::less<>> numbers;
  std::map<std::string, bool, std::less<>> flag;
  std::vector<HeightSource> heights;
  int line = 0;

  std::string text_or(std::string_view name, std::string_view other = "") const {
    const auto found = text.find(name);
    return std::string(found == text.end() ? other : std::string_view(found->second));
  }
  std::optional<double> number(std::string_view name) const {
    const auto found = numbers.find(name);
    return found == numbers.end() ? std::nullopt : std::optional(found->second.front());
  }
};

class MapReader {
 public:
  MapReader(std::string file, calc::Diagnostics& diagnostics)
      : file_(std::move(file)),
        diagnostics_(diagnostics),
        errors_before_(diagnostics.error_count()) {}

  ImportMap read(const toml::table& table) {
    ImportMap map;
    map.file = file_;
    const Values top = read_table("", table, {1, 1});
    map.unit = top.text_or("unit");
    if (top.text.count("unit") != 0 && !metres_per_import_unit(map.unit)) {
      refuse(table.get("unit")->source().begin, "unit",
             fmt::format("'{}' is not one of {}", calc::printable(map.unit),
                         calc::join_choices(kImportUnits)));
    }
    map.name = top.text_or("name");
    if (const auto found = top.texts.find("ignore"); found != top.texts.end()) {
      map.ignore = found->second;
    }
    for (const std::string_view name : kTables) {
      const toml::node* node = table.get(name);
      if (node == nullptr) continue;
      const toml::array* list = node->as_array();
      if (list == nullptr || !list->is_homogeneous(toml::node_type::table)) {
        refuse(node->source().begin, name, fmt::format("[[{}]] is needed, once or more", name));
        continue;
      }
      for (const toml::node& one : *list) {
        const Values values = read_table(name, *one.as_table(), one.source().begin);
        if (diagnostics_.error_count() == errors_before_)
          add(name, values, one.source().begin, map);
      }
    }
    return map;
  }

 private:
  void refuse(const toml::source_position& at, std::string_view name, const std::string& problem) {
    diagnostics_.report(calc::DiagnosticId::config_value,
                        {file_, static_cast<int>(at.line), static_cast<int>(at.column)},
                        std::string(name), problem);
  }

  Values read_table(std::string_view table, const toml::table& source,
                    const toml::source_position& at) {
    Values values;
    values.line = static_cast<int>(at.line);
    for (const auto& [key, node] : source) {
      const std::string name(key.str());
      const MapKey* row = find_map_key(table, name);
      if (row != nullptr) {
        read_value(*row, node, values);
      } else if (!table.empty() ||
                 std::find(kTables.begin(), kTables.end(), name) == kTables.end()) {
        const std::vector<std::string_view> names = keys_of(table);
        diagnostics_.report(
            calc::DiagnosticId::config_unknown,
            {file_, static_cast<int>(key.source().begin.line),
             static_cast<int>(key.source().begin.column)},
            name, fmt::format("{}{}", calc::join_choices(names), calc::suggestion(name, names)));
      }
    }
    for (const MapKey& key : kKeys) {
      if (key.table == table && key.is_needed && source.get(key.name) == nullptr) {
        refuse(at, key.name, fmt::format("it is needed in each [[{}]] ({})", table, key.words));
      }
    }
    return values;
  }

  void read_value(const MapKey& key, const toml::node& node, Values& values) {
    const std::string name(key.name);
    const toml::source_position at = node.source().begin;
    const auto add_number = [&](const toml::node& one) {
      const std::optional<double> number = number_of(one);
      if (number && *number >= key.low && *number <= key.high) {
        values.numbers[name].push_back(*number);
        return true;
      }
      refuse(at, name, range_words(key) + " is needed");
      return false;
    };
    switch (key.kind) {
      case MapValue::text:
        if (const auto* text = node.as_string(); text != nullptr && is_text(text->get())) {
          values.text[name] = text->get();
        } else {
          refuse(at, name, "a text is needed, in quotes and not empty");
        }
        return;
      case MapValue::texts: {
        const toml::array* list = node.as_array();
        if (list == nullptr || !list->is_homogeneous(toml::node_type::string)) {
          return refuse(at, name, "a list of texts is needed");
        }
        for (const toml::node& one : *list) values.texts[name].push_back(one.as_string()->get());
        return;
      }
      case MapValue::flag:
        if (const auto* flag = node.as_boolean()) {
          values.flag[name] = flag->get();
        } else {
          refuse(at, name, "true or false is needed");
        }
        return;
      case MapValue::number:
        add_number(node);
        return;
      case MapValue::numbers3: {
        const toml::array* list = node.as_array();
        if (list == nullptr || list->size() != 3) {
          return refuse(at, name, fmt::format("a list of three numbers is needed ({})", key.words));
        }
        for (const toml::node& one : *list) {
          if (!add_number(one)) return;
        }
        return;
      }
      case MapValue::heights:
        if (const toml::array* list = node.as_array(); list != nullptr && !list->empty()) {
          for (const toml::node& one : *list) add_height(key, one, values);
        } else {
          add_height(key, node, values);
        }
        return;
    }
  }

  // No bytes 0, which end paths, and something to see.
  static bool is_text(const std::string& text) {
    return !calc::trim(text).empty() && text.find('\0') == text.npos;
  }

  void add_height(const MapKey& key, const toml::node& node, Values& values) {
    constexpr std::string_view kAttribute = "attribute:";
    if (const std::optional<double> number = number_of(node);
        number && *number >= key.low && *number <= key.high) {
      values.heights.emplace_back(*number);
      return;
    }
    if (const auto* text = node.as_string()) {
      const std::string& words = text->get();
      if (words == "z") {
        values.heights.emplace_back(FromZ{});
        return;
      }
      if (words.compare(0, kAttribute.size(), kAttribute) == 0 &&
          words.size() > kAttribute.size()) {
        values.heights.emplace_back(FromAttribute{words.substr(kAttribute.size())});
        return;
      }
    }
    refuse(node.source().begin, key.name,
           fmt::format("{}, \"z\" or \"attribute:NAME\" is needed, or a list of these",
                       range_words(key)));
  }

  void add(std::string_view table, const Values& values, const toml::source_position& at,
           ImportMap& map) {
    if (table == "room") {
      MapRoom room;
      room.layer = values.text_or("layer", "DLX_*CONT");
      room.names = values.text_or("names", "DLX_*DESC");
      room.height_m = *values.number("height");
      const std::vector<double>& shares = values.numbers.at("reflectances");
      room.ceiling = shares[0];
      room.walls = shares[1];
      room.floor = shares[2];
      room.floor_z_m = values.number("floor");
      room.closes = values.flag.count("close") != 0 && values.flag.at("close");
      room.line = values.line;
      map.room.push_back(room);
    } else if (table == "luminaire") {
      map.luminaire.push_back({values.text_or("type"), values.text_or("layer"),
                               values.text_or("photometry"), values.heights,
                               values.text_or("group"), values.number("turn").value_or(0.0),
                               values.number("flux-lm"), values.number("power-w"),
                               values.number("maintenance-factor"), values.line});
    } else if (table == "furniture") {
      MapFurniture furniture{values.text_or("type"), values.text_or("layer"),
                             *values.number("height"), *values.number("reflectance"), values.line};
      if (furniture.type.empty() && furniture.layer.empty()) {
        refuse(at, "type", "type, layer or both are needed in each [[furniture]]");
      }
      map.furniture.push_back(furniture);
    } else if (table == "plane") {
      map.plane.push_back({values.text_or("layer"), *values.number("height"), values.line});
    } else {
      map.route.push_back({values.text_or("layer"), *values.number("width"), values.line});
    }
  }

  std::string file_;
  calc::Diagnostics& diagnostics_;
  std::size_t errors_before_;
};

}  // namespace

const std::vector<std::string_view> kImportUnits = {"m", "cm", "mm", "in", "ft"};

std::optional<double> metres_per_import_unit(std::string_view unit) {
  const std::array metres = {1.0, calc::kMetresPerCentimetre, calc::kMetresPerMillimetre,
                             calc::kMetresPerInch, calc::kMetresPerFoot};
  const auto found = std::find(kImportUnits.begin(), kImportUnits.end(), unit);
  if (found == kImportUnits.end()) return std::nullopt;
  return metres[static_cast<std::size_t>(found - kImportUnits.begin())];
}

std::optional<ImportMap> read_import_map(const std::string& bytes, const std::string& file,
                                         calc::Diagnostics& diagnostics) {
  const std::size_t errors = diagnostics.error_count();
  std::optional<ImportMap> map;
  if (bytes.size() > kMostBytes) {
    diagnostics.report(calc::DiagnosticId::config_syntax, {file, 0, 0},
                       "it is larger than 256 KiB");
    return map;
  }
  if (!calc::check_file_kind(bytes, file, calc::FileUse::settings, diagnostics)) return map;
  try {
    map = MapReader(file, diagnostics).read(toml::parse(bytes, file));
  } catch (const toml::parse_error& error) {
    const toml::source_position at = error.source().begin;
    diagnostics.report(calc::DiagnosticId::config_syntax,
                       {file, static_cast<int>(at.line), static_cast<int>(at.column)},
                       error.description());
  }
  if (diagnostics.error_count() > errors) map.reset();
  return map;
}

std::string import_map_reference() {
  std::string text = "| table | key | meaning |\n|---|---|---|\n";
  for (const MapKey& key : kKeys) {
    std::string words(key.words);
    if (key.kind == MapValue::number) {
      words = range_words(key) + (words.empty() ? "" : ": ") + words;
    }
    text += fmt::format("| {} | `{}`{} | {} |\n",
                        key.table.empty() ? "" : fmt::format("`[[{}]]`", key.table), key.name,
                        key.is_needed ? " (needed)" : "", words);
  }
  return text;
}

bool matches_name(std::string_view pattern, std::string_view name) {
  const std::string p = calc::ascii_lowered(pattern), n = calc::ascii_lowered(name);
  std::size_t i = 0, k = 0, star = p.npos, mark = 0;
  while (k < n.size()) {
    if (i < p.size() && p[i] == '*') {
      star = i++;
      mark = k;
    } else if (i < p.size() && (p[i] == '?' || p[i] == n[k])) {
      ++k;
      while (p[i] == '?' && k < n.size() && calc::is_utf8_continuation(n[k])) ++k;
      ++i;
    } else if (star != p.npos) {
      i = star + 1;
      k = ++mark;
    } else {
      return false;
    }
  }
  while (i < p.size() && p[i] == '*') ++i;
  return i == p.size();
}

bool matches_bound_name(std::string_view pattern, std::string_view name) {
  constexpr std::string_view kBound = "$0$";
  if (matches_name(pattern, name)) return true;
  const std::size_t at = name.rfind(kBound);
  return at != name.npos && matches_name(pattern, name.substr(at + kBound.size()));
}

}  // namespace cli
