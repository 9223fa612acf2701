#include "rules/pack/pack_diff.h"

#include "calc/base/diagnostics.h"
#include "rules/pack/rule_pack_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <map>
#include <set>
#include <string_view>
#include <utility>

namespace rules {
namespace {

// Returns the effect if it is the same in both packs; otherwise it is unclear.
Tightening agreed(Tightening a, Tightening b) { return a == b ? a : Tightening::unclear; }

template <class Item, class Key>
Item* find_in(std::vector<Item>& items, const std::string& wanted, Key key) {
  const auto found = std::find_if(items.begin(), items.end(),
                                  [&](const Item& item) { return item.*key == wanted; });
  return found == items.end() ? nullptr : &*found;
}

// Restores a part when it goes out of scope.
template <class Part>
class Restored {
 public:
  explicit Restored(Part& part) : part_(part), was_(part) {}
  Restored(const Restored&) = delete;
  Restored& operator=(const Restored&) = delete;
  ~Restored() { part_ = std::move(was_); }

 private:
  Part& part_;
  Part was_;
};

// The effect of a single change of a pack.
class OneChange {
 public:
  explicit OneChange(const RulePack& pack) : pack_(pack), changed_(pack) {}

  // Changes a value of one of its rows to that of another row; null: removes it.
  Tightening of_value(const std::string& ref, const std::string& parameter, const RuleValue* to,
                      bool is_modified) {
    RuleRow* row = find_in(changed_.rows, ref, &RuleRow::ref);
    const Restored restored(*row);
    RuleValue* value = find_in(row->values, parameter, &RuleValue::parameter);
    if (is_modified) {
      if (value == nullptr || !value->required) return Tightening::unclear;
      value->modified = to == nullptr ? std::nullopt : to->modified;
    } else if (value == nullptr) {
      row->values.push_back(*to);
      row->values.back().modified.reset();
    } else if (to == nullptr) {
      value->required.reset();
      value->why = NoValue::not_specified;
    } else {
      value->required = to->required;
      value->why = to->why;
    }
    const auto place = static_cast<std::size_t>(row - changed_.rows.data());
    return tightening_of_row(pack_, changed_, place, [&](const RuleCheck& check) {
      return has_part(check, pack_, ExpressionKind::row_value, parameter);
    });
  }

  // Changes an entry of a table to another; null: removes it.
  Tightening of_entry(const std::string& table_id, double key, const RuleTable::Entry* to) {
    RuleTable* table = find_in(changed_.tables, table_id, &RuleTable::id);
    const Restored restored(*table);
    std::erase_if(table->entries, [&](const RuleTable::Entry& entry) { return entry.key == key; });
    if (to != nullptr) table->entries.push_back(*to);
    std::sort(table->entries.begin(), table->entries.end(),
              [](const auto& a, const auto& b) { return a.key < b.key; });
    return tightening_of(pack_, changed_, [&](const RuleCheck& check) {
      return has_part(check, pack_, ExpressionKind::table, table_id);
    });
  }

  // Gives a check the limit of another.
  Tightening of_limit(const std::string& check_id, const RuleCheck& to) {
    RuleCheck* check = find_in(changed_.checks, check_id, &RuleCheck::id);
    const Restored restored(*check);
    check->limit = to.limit;
    check->comparison = to.comparison;
    // Names that this pack does not have, other units, circles.
    calc::Diagnostics diagnostics;
    check_rule_pack(changed_, diagnostics);
    if (diagnostics.has_errors()) return Tightening::unclear;
    return tightening_of(pack_, changed_, [&](const RuleCheck& other) {
      return other.id == check_id || has_part(other, pack_, ExpressionKind::limit_of, check_id);
    });
  }

 private:
  const RulePack& pack_;
  RulePack changed_;  // the same between two calls
};

bool is_changed(const PartDifference& part, std::string_view field) {
  return std::any_of(part.fields.begin(), part.fields.end(),
                     [&](const FieldDifference& f) { return f.name == field; });
}

// Returns the entry of a table for a field.
const RuleTable::Entry* find_entry(const RuleTable& table, const std::string& field) {
  const auto found =
      std::find_if(table.entries.begin(), table.entries.end(),
                   [&](const RuleTable::Entry& entry) { return key_field(table, entry) == field; });
  return found == table.entries.end() ? nullptr : &*found;
}

Tightening stricter_if_more(const FieldDifference& field) {
  if (!field.before || !field.after) return Tightening::unclear;
  if (!field.before->value || !field.after->value) return Tightening::unclear;
  return *field.after->value > *field.before->value ? Tightening::stricter : Tightening::easier;
}

Tightening opposite(Tightening tightening) {
  if (tightening == Tightening::stricter) return Tightening::easier;
  if (tightening == Tightening::easier) return Tightening::stricter;
  return tightening;
}

Tightening of_severity(const FieldDifference& field) {
  const std::string_view before = field.before->text, after = field.after->text;
  const std::string_view shall = calc::name_of(Severity::shall);
  const std::string_view advice = calc::name_of(Severity::advice);
  if (before == advice && after == shall) return Tightening::stricter;
  if (before == shall && after == advice) return Tightening::easier;
  return Tightening::unclear;
}

class PackDiff {
 public:
  PackDiff(const RulePack& before, const RulePack& after, const RowNames& rows)
      : before_(before), after_(after), rows_(rows), in_before_(before), in_after_(after) {
    for (const auto& [from, to] : rows) taken_.insert(to);
  }

  std::vector<PartDifference> find() {
    const std::vector<PartFields> parts_before = fields_of(before_, rows_);
    const std::vector<PartFields> parts_after = fields_of(after_);
    for (std::size_t i = 0; i < std::size(calc::EnumNames<PackPart>::list); ++i) {
      const PackPart kind = calc::EnumNames<PackPart>::list[i].value;
      std::set<std::string> matched;
      for (const PartFields& part : parts_before) {
        if (part.part != kind) continue;
        const std::optional<std::string> id_after = id_in_after(part);
        const PartFields* other = id_after ? find_part(parts_after, kind, *id_after) : nullptr;
        if (other != nullptr) matched.insert(other->id);
        add(&part, other);
      }
      for (const PartFields& part : parts_after) {
        if (part.part == kind && !matched.contains(part.id)) add(nullptr, &part);
      }
    }
    return std::move(differences_);
  }

 private:
  // Returns the id in the other pack; empty: the name means another row there.
  std::optional<std::string> id_in_after(const PartFields& part) const {
    if (part.part != PackPart::row) return part.id;
    const auto found = rows_.find(part.id);
    if (found != rows_.end()) return found->second;
    return taken_.contains(part.id) ? std::nullopt : std::optional(part.id);
  }

  static const PartFields* find_part(const std::vector<PartFields>& parts, PackPart kind,
                                     const std::string& id) {
    const auto found = std::find_if(parts.begin(), parts.end(), [&](const PartFields& part) {
      return part.part == kind && part.id == id;
    });
    return found == parts.end() ? nullptr : &*found;
  }

  void add(const PartFields* before, const PartFields* after) {
    PartDifference difference;
    const PartFields& any = before != nullptr ? *before : *after;
    difference.part = any.part;
    difference.id = any.id;
    difference.change = before == nullptr  ? PartChange::added
                        : after == nullptr ? PartChange::removed
                                           : PartChange::changed;
    if (before != nullptr && after != nullptr && before->id != after->id) {
      difference.id_after = after->id;
    }
    add_fields(difference, before, after);
    if (any.part == PackPart::row) leave_out_trust_of_row(difference, before, after);
    if (before != nullptr && after != nullptr && difference.fields.empty()) return;
    if (any.part == PackPart::row) {
      const RulePack& pack = before != nullptr ? before_ : after_;
      difference.title = pack.find_row(any.id)->name;
    }
    judge(difference);
    differences_.push_back(std::move(difference));
  }

  static void add_fields(PartDifference& difference, const PartFields* before,
                         const PartFields* after) {
    const auto find = [](const PartFields* part, const std::string& name) -> const PackField* {
      if (part == nullptr) return nullptr;
      const auto found = std::find_if(part->fields.begin(), part->fields.end(),
                                      [&](const PackField& field) { return field.name == name; });
      return found == part->fields.end() ? nullptr : &*found;
    };
    const auto add_field = [&](const PackField* was, const PackField* is) {
      FieldDifference field;
      field.name = was != nullptr ? was->name : is->name;
      if (was != nullptr) field.before = *was;
      if (is != nullptr) field.after = *is;
      difference.fields.push_back(std::move(field));
    };
    if (before != nullptr) {
      for (const PackField& field : before->fields) {
        const PackField* other = find(after, field.name);
        if (other == nullptr || !is_same(field, *other)) add_field(&field, other);
      }
    }
    if (after == nullptr) return;
    for (const PackField& field : after->fields) {
      if (find(before, field.name) == nullptr) add_field(nullptr, &field);
    }
  }

  // Removes the trust of values that have the trust of their row, which reports it once.
  void leave_out_trust_of_row(PartDifference& difference, const PartFields* before,
                              const PartFields* after) const {
    const std::string_view was =
        before == nullptr ? "" : calc::name_of(before_.find_row(before->id)->trust);
    const std::string_view is =
        after == nullptr ? "" : calc::name_of(after_.find_row(after->id)->trust);
    const auto is_trust = [&](const FieldDifference& field) {
      const auto names_it = [&](const RuleName& parameter) {
        return field.name == trust_field(parameter.id);
      };
      return std::any_of(before_.parameters.begin(), before_.parameters.end(), names_it) ||
             std::any_of(after_.parameters.begin(), after_.parameters.end(), names_it);
    };
    std::erase_if(difference.fields, [&](const FieldDifference& field) {
      return is_trust(field) && (!field.before || field.before->text == was) &&
             (!field.after || field.after->text == is);
    });
  }

  void judge(PartDifference& part) {
    if (part.change != PartChange::changed) {
      if (part.part == PackPart::check) part.tightening = of_check(part);
      return;
    }
    for (FieldDifference& field : part.fields) {
      if (part.part == PackPart::row) field.tightening = of_row_field(part, field);
      if (part.part == PackPart::table) field.tightening = of_table_field(part, field);
      if (part.part == PackPart::check) field.tightening = of_check_field(part, field);
      if (part.part == PackPart::aggregate) field.tightening = of_aggregate_field(part, field);
      if (part.part == PackPart::policy && field.name == "tolerance") {
        field.tightening = opposite(stricter_if_more(field));
      }
    }
  }

  // Returns the effect of an added or removed requirement, unless it is only an alternative.
  Tightening of_check(const PartDifference& part) const {
    const bool is_added = part.change == PartChange::added;
    const RulePack& pack = is_added ? after_ : before_;
    const RuleCheck& check = *pack.find_check(part.id);
    const bool is_linked =
        !check.instead_of.empty() ||
        std::any_of(pack.checks.begin(), pack.checks.end(),
                    [&](const RuleCheck& other) { return other.instead_of == check.id; }) ||
        std::any_of(pack.aggregates.begin(), pack.aggregates.end(),
                    [&](const RuleAggregate& aggregate) {
                      const auto& ids = aggregate.checks;
                      return std::find(ids.begin(), ids.end(), check.id) != ids.end();
                    });
    if (is_linked || check.severity != Severity::shall) return Tightening::unclear;
    return is_added ? Tightening::stricter : Tightening::easier;
  }

  Tightening of_row_field(const PartDifference& part, const FieldDifference& field) {
    const RuleRow& was = *before_.find_row(part.id);
    const std::string& ref_after = part.id_after.empty() ? part.id : part.id_after;
    const RuleRow& is = *after_.find_row(ref_after);
    for (const RuleName& parameter : before_.parameters) {
      const bool is_modified = field.name == modified_field(parameter.id);
      if (field.name != parameter.id && !is_modified) continue;
      const RuleName* other = after_.find_parameter(parameter.id);
      if (other == nullptr || other->unit.dimension != parameter.unit.dimension) break;
      return agreed(
          in_before_.of_value(was.ref, parameter.id, is.find_value(parameter.id), is_modified),
          opposite(
              in_after_.of_value(is.ref, parameter.id, was.find_value(parameter.id), is_modified)));
    }
    return Tightening::unclear;
  }

  Tightening of_table_field(const PartDifference& part, const FieldDifference& field) {
    const RuleTable& was = *before_.find_table(part.id);
    const RuleTable& is = *after_.find_table(part.id);
    if (was.key_unit.dimension != is.key_unit.dimension ||
        was.value_unit.dimension != is.value_unit.dimension) {
      return Tightening::unclear;
    }
    const RuleTable::Entry* entry = find_entry(was, field.name);
    const RuleTable::Entry* other = find_entry(is, field.name);
    if (entry == nullptr && other == nullptr) return Tightening::unclear;
    const double key = entry != nullptr ? entry->key : other->key;
    return agreed(in_before_.of_entry(part.id, key, other),
                  opposite(in_after_.of_entry(part.id, key, entry)));
  }

  Tightening of_check_field(const PartDifference& part, const FieldDifference& field) {
    const RuleCheck& was = *before_.find_check(part.id);
    const RuleCheck& is = *after_.find_check(part.id);
    if (field.name == "severity") {
      const bool is_plain = was.instead_of.empty() && is.instead_of.empty();
      return is_plain ? of_severity(field) : Tightening::unclear;
    }
    if (field.name != "limit") return Tightening::unclear;
    // A limit of something else is neither more nor less.
    for (const char* other : {"role", "quantity", "statistic", "percent", "from", "to", "mask",
                              "state", "sources", "light", "outage"}) {
      if (is_changed(part, other)) return Tightening::unclear;
    }
    return agreed(in_before_.of_limit(part.id, is), opposite(in_after_.of_limit(part.id, was)));
  }

  static Tightening of_aggregate_field(const PartDifference& part, const FieldDifference& field) {
    for (const char* other : {"rule", "of", "over", "by"}) {
      if (is_changed(part, other)) return Tightening::unclear;
    }
    if (field.name == "severity") return of_severity(field);
    if (field.name == "count" || field.name == "share") return stricter_if_more(field);
    return Tightening::unclear;
  }

  const RulePack& before_;
  const RulePack& after_;
  const RowNames& rows_;
  OneChange in_before_, in_after_;
  std::set<std::string> taken_;  // names in the second pack that rows of other names have
  std::vector<PartDifference> differences_;
};

}  // namespace

std::vector<PartDifference> diff_of(const RulePack& before, const RulePack& after,
                                    const RowNames& rows) {
  return PackDiff(before, after, rows).find();
}

RowNames likely_row_names(const std::vector<PartDifference>& parts) {
  std::map<std::string, std::vector<std::string>> removed, added;
  for (const PartDifference& part : parts) {
    if (part.part != PackPart::row) continue;
    if (part.change == PartChange::removed) removed[part.title].push_back(part.id);
    if (part.change == PartChange::added) added[part.title].push_back(part.id);
  }
  RowNames names;
  for (const auto& [title, ids] : removed) {
    const auto found = added.find(title);
    if (found == added.end() || ids.size() != 1 || found->second.size() != 1) continue;
    names[ids.front()] = found->second.front();
  }
  return names;
}

ReadRowNames read_row_names(const std::vector<std::string>& texts, const RulePack& before,
                            const RulePack& after) {
  ReadRowNames result;
  std::set<std::string> taken;
  for (const std::string& text : texts) {
    const std::size_t equals = text.find('=');
    const std::string from = text.substr(0, equals);
    const std::string to = equals == std::string::npos ? "" : text.substr(equals + 1);
    if (equals == std::string::npos) {
      result.problem = fmt::format("'{}' is not FROM=TO", text);
    } else if (before.find_row(from) == nullptr) {
      result.problem = fmt::format("{} has no row '{}'", before.full_id(), from);
    } else if (after.find_row(to) == nullptr) {
      result.problem = fmt::format("{} has no row '{}'", after.full_id(), to);
    } else if (!result.names.emplace(from, to).second) {
      result.problem = fmt::format("row '{}' is matched twice", from);
    } else if (!taken.insert(to).second) {
      result.problem = fmt::format("row '{}' is matched twice", to);
    }
    if (!result.problem.empty()) break;
  }
  return result;
}

}  // namespace rules
