#include "report/tools/rules/diff_text.h"

#include "report/text/json_layout.h"
#include "report/text/words.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <string_view>

namespace cli {
namespace {

using nlohmann::ordered_json;
using rules::FieldDifference;
using rules::PartChange;
using rules::PartDifference;
using rules::Tightening;

std::string pack_line(char letter, const rules::RulePack& pack) {
  return fmt::format("{}  {}  {}:{} ({}), version {} of the pack, {}\n", letter, pack.full_id(),
                     pack.title, pack.edition, pack.status, pack.version, pack.file);
}

// "row 5.26.2 = 34.2"
std::string name_of(const PartDifference& part) {
  std::string text(calc::name_of(part.part));
  if (!part.id.empty()) text += " " + part.id;
  if (!part.id_after.empty()) text += " = " + part.id_after;
  if (!part.title.empty()) text += fmt::format(" ({})", part.title);
  return text;
}

// ", stricter", or nothing.
std::string tightening_text(Tightening tightening) {
  const std::string_view word = calc::name_of(tightening);
  return word.empty() ? "" : fmt::format("  [{}]", word);
}

std::string field_text(const FieldDifference& field) {
  const auto text = [](const std::optional<rules::PackField>& side) {
    return side ? side->text : std::string("(none)");
  };
  return fmt::format("    {}: {} -> {}{}\n", field.name, text(field.before), text(field.after),
                     tightening_text(field.tightening));
}

// What there is, or was, of a part that has no other.
std::string contents_text(const PartDifference& part) {
  std::string text;
  for (const FieldDifference& field : part.fields) {
    const bool is_in_title =
        part.part == rules::PackPart::row && (field.name == "ref" || field.name == "name");
    if (is_in_title) continue;
    const rules::PackField& side = field.before ? *field.before : *field.after;
    text += fmt::format("{}{} {}", text.empty() ? "    " : "; ", field.name, side.text);
  }
  return text.empty() ? text : text + "\n";
}

std::string part_text(const PartDifference& part) {
  if (part.change != PartChange::changed) {
    return fmt::format("{} {}{}\n{}", name_of(part), calc::name_of(part.change),
                       tightening_text(part.tightening), contents_text(part));
  }
  std::string text = name_of(part) + "\n";
  for (const FieldDifference& field : part.fields) text += field_text(field);
  return text;
}

struct Counts {
  std::size_t added = 0, removed = 0, changed = 0;    // parts
  std::size_t stricter = 0, easier = 0, unclear = 0;  // changes of them
};

Counts count(const std::vector<PartDifference>& parts) {
  Counts counts;
  const auto add = [&](Tightening tightening) {
    if (tightening == Tightening::stricter) ++counts.stricter;
    if (tightening == Tightening::easier) ++counts.easier;
    if (calc::name_of(tightening).empty()) ++counts.unclear;
  };
  for (const PartDifference& part : parts) {
    if (part.change == PartChange::added) ++counts.added;
    if (part.change == PartChange::removed) ++counts.removed;
    if (part.change != PartChange::changed) {
      add(part.tightening);
      continue;
    }
    ++counts.changed;
    for (const FieldDifference& field : part.fields) add(field.tightening);
  }
  return counts;
}

std::string counts_text(const Counts& counts) {
  return fmt::format(
      "Only in A: {}, only in B: {}, changed: {}. By itself a change is [stricter] ({}), [easier] "
      "({}), or neither for certain ({}).\n",
      counts.removed, counts.added, counts.changed, counts.stricter, counts.easier, counts.unclear);
}

std::string likely_text(const std::vector<PartDifference>& parts) {
  const rules::RowNames names = rules::likely_row_names(parts);
  if (names.empty()) return {};
  std::string text = "Rows that have one name and two numbers are compared with:";
  for (const auto& [from, to] : names) text += fmt::format(" --rows {}={}", from, to);
  return text + "\n";
}

std::string side_text(const std::optional<JudgedLimit>& side) {
  if (!side) return "not asked";
  const std::string severity = side->severity.empty() ? "" : " (" + side->severity + ")";
  return (side->limit.empty() ? "" : side->limit + " ") + side->verdict + severity;
}

std::string effect_text(const ProjectEffect& effect) {
  std::string text =
      fmt::format("\n{}: {} with A, {} with B\n", effect.project,
                  report::outcome_words(effect.before), report::outcome_words(effect.after));
  for (const ChangedVerdict& changed : effect.changed) {
    text += fmt::format("    {}{}{}: {} -> {}\n", changed.place, changed.place.empty() ? "" : ", ",
                        changed.id, side_text(changed.before), side_text(changed.after));
  }
  if (effect.asked == 0) return text + "    It asks for nothing of A or B.\n";
  if (effect.changed.empty()) text += "    No limit and no verdict changes.\n";
  return text;
}

void add_tightening(ordered_json& json, Tightening tightening) {
  const std::string_view word = calc::name_of(tightening);
  if (!word.empty()) json["is"] = word;
}

void add_side(ordered_json& json, const std::string& name,
              const std::optional<rules::PackField>& side) {
  json[name] = side ? ordered_json(side->text) : ordered_json();
  if (side && side->value) json[name + "_value"] = *side->value;
}

ordered_json pack_json(const rules::RulePack& pack) {
  return {{"pack", pack.full_id()}, {"version", pack.version}, {"file", pack.file}};
}

ordered_json part_json(const PartDifference& part) {
  ordered_json json{{"part", calc::name_of(part.part)}, {"id", part.id}};
  if (!part.id_after.empty()) json["id_after"] = part.id_after;
  if (!part.title.empty()) json["name"] = part.title;
  json["change"] = calc::name_of(part.change);
  add_tightening(json, part.tightening);
  ordered_json fields = ordered_json::array();
  for (const FieldDifference& field : part.fields) {
    ordered_json one{{"field", field.name}};
    add_side(one, "before", field.before);
    add_side(one, "after", field.after);
    add_tightening(one, field.tightening);
    fields.push_back(std::move(one));
  }
  json["fields"] = std::move(fields);
  return json;
}

ordered_json effect_json(const ProjectEffect& effect) {
  const auto side = [](const std::optional<JudgedLimit>& judged) {
    if (!judged) return ordered_json();
    ordered_json one{{"limit", judged->limit}, {"verdict", judged->verdict}};
    if (!judged->severity.empty()) one["severity"] = judged->severity;
    return one;
  };
  ordered_json changed = ordered_json::array();
  for (const ChangedVerdict& one : effect.changed) {
    changed.push_back({{"place", one.place},
                       {"id", one.id},
                       {"before", side(one.before)},
                       {"after", side(one.after)}});
  }
  return {{"path", effect.project},
          {"before", report::outcome_words(effect.before)},
          {"after", report::outcome_words(effect.after)},
          {"asked", effect.asked},
          {"changed", std::move(changed)}};
}

}  // namespace

std::string diff_text(const ShownDiff& diff) {
  std::string text = pack_line('A', diff.before) + pack_line('B', diff.after) + "\n";
  for (const PartDifference& part : diff.parts) text += part_text(part);
  text += diff.parts.empty() ? "They are equal.\n"
                             : "\n" + counts_text(count(diff.parts)) + likely_text(diff.parts);
  return diff.effect ? text + effect_text(*diff.effect) : text;
}

std::string diff_json(const ShownDiff& diff) {
  ordered_json json{{"before", pack_json(diff.before)},
                    {"after", pack_json(diff.after)},
                    {"equal", diff.parts.empty()},
                    {"differences", ordered_json::array()}};
  for (const PartDifference& part : diff.parts) json["differences"].push_back(part_json(part));
  if (diff.effect) json["project"] = effect_json(*diff.effect);
  return report::json_layout(json);
}

}  // namespace cli
