#include "rules/binding/rule_reference.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/base/sentences.h"
#include "calc/base/text.h"
#include "rules/binding/requirement_attributes.h"
#include "rules/measure/derived_metrics.h"
#include "rules/pack/named_pack.h"
#include "rules/pack/pack_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <variant>

namespace rules {
namespace {

using calc::DiagnosticId;
using calc::ElementReader;

// Attributes that mean nothing without a pack.
constexpr const char* kNeedPack[] = {"row", "level", "level-because", "role", "facts"};

}  // namespace

const RulePack* find_pack(ElementReader& reader, const std::vector<RulePack>& packs) {
  const std::string name = reader.text("pack");
  if (name.empty()) return nullptr;
  const NamedPack found = named_pack(name, packs);
  if (found.is_ambiguous()) {
    reader.report(DiagnosticId::ambiguous_rule_pack, reader.where("pack"), name, found.candidates);
  } else if (found.pack == nullptr) {
    std::vector<const RulePack*> all;
    calc::Names names;
    for (const RulePack& pack : packs) {
      all.push_back(&pack);
      names.emplace_back(pack.id);
    }
    reader.report(DiagnosticId::unknown_reference, reader.where("pack"), "pack",
                  reader.element().name, "rule pack", name, "allowed: " + pack_list(all),
                  calc::suggestion(name, names));
  }
  return found.pack;
}

const RuleRow* find_row(ElementReader& reader, const RulePack& pack) {
  if (!reader.has("row")) return nullptr;
  const std::string ref = reader.text("row");
  const RuleRow* row = pack.find_row(ref);
  if (row != nullptr || ref.empty()) return row;
  calc::Names refs;
  for (const RuleRow& candidate : pack.rows) refs.emplace_back(candidate.ref);
  report_unknown_name(reader.diagnostics(), reader.where("row"), "row", reader.element().name,
                      "row", ref, refs);
  return nullptr;
}

namespace {

// Returns the plane's role in the pack unless another is named; "" after an error.
std::string find_role(ElementReader& reader, const RulePack& pack, std::string_view usual_role) {
  const std::vector<std::string> roles = pack.roles();
  if (!reader.has("role")) {
    const auto known = std::find(roles.begin(), roles.end(), usual_role);
    return known == roles.end() ? pack.role : *known;
  }
  std::string role = reader.text("role");
  if (role.empty() || std::find(roles.begin(), roles.end(), role) != roles.end()) return role;
  report_unknown_name(reader.diagnostics(), reader.where("role"), "role", reader.element().name,
                      "role", role, calc::Names(roles.begin(), roles.end()));
  return {};
}

calc::Message number_of(double value, const char* unit) {
  return calc::Message::number(fmt::format("{:.6g}{}{}", value, *unit == '\0' ? "" : " ", unit));
}

// Returns the light that luxgate does not calculate; "" = it calculates it.
calc::Message uncalculated_light(const RuleCheck& check) {
  if (check.sources == LightSources::daylight) return calc::say<calc::Sentence::no_daylight>();
  if (!is_metric_of(check.metric, check.quantity->derived)) {
    return calc::say<calc::Sentence::check_means_nothing>(check.id, calc::name_of(check.metric),
                                                          check.quantity->name);
  }
  if (check.metric == Metric::value_at_point && !check.quantity->of_space) {
    return calc::say<calc::Sentence::check_of_one_value>(check.id);
  }
  return {};
}

// Adds the names of facts on which the limit depends, through other checks' limits, too.
void add_facts(const RulePack& pack, const Expression& expression, std::set<std::string>& facts) {
  if (expression.kind == ExpressionKind::fact) facts.insert(expression.name);
  if (expression.kind == ExpressionKind::limit_of) {
    const RuleCheck* other = pack.find_check(expression.name);
    if (other != nullptr) add_facts(pack, other->limit, facts);
  }
  for (const Expression& operand : expression.operands) add_facts(pack, operand, facts);
}

// Returns words for facts that the project states and that nothing verifies.
calc::Message facts_words(const RuleCheck& check, const LimitScope& scope) {
  std::set<std::string> used;
  add_facts(scope.pack, check.limit, used);
  calc::Message words;
  for (const std::string& id : used) {
    const auto stated = scope.facts.find(id);
    const RuleName* fact = scope.pack.find_fact(id);
    if (stated == scope.facts.end() || fact == nullptr) continue;
    append(words, calc::say<calc::Sentence::stated_fact>(
                      id, number_of(stated->second, base_unit(fact->unit.dimension))));
  }
  return words;
}

calc::Message note_of(const RulePack& pack, const RuleCheck& check, Trust trust) {
  calc::Message note = trust_remark(trust);
  if (pack.status != "published") {
    append(note, calc::say<calc::Sentence::pack_status>(pack.full_id(), pack.status));
  }
  append(note, calc::Message::words(check.note));
  return note;
}

struct Reference {
  const RulePack& pack;
  const RuleRow* row;
  LimitScope scope;
  std::string level_because;
  calc::ReceiverKernel kernel;
  calc::DerivedQuantity derived;
  bool is_quantity_known;
  ChosenScene scene;
  std::string_view usual_role;  // of the plane
};

// Returns whether the chosen level is easier than the row's requirement.
bool is_weakened(const RuleCheck& check, const Limit& limit, const LimitScope& scope) {
  if (scope.level == RowLevel::required && limit.special == nullptr) return false;
  const Limit required =
      evaluate_limit(check, {scope.pack, scope.row, RowLevel::required, scope.facts});
  if (limit.status != LimitStatus::known || required.status != LimitStatus::known) {
    return scope.level.steps < 0;
  }
  return is_lower_limit(check.comparison) ? limit.value.value < required.value.value
                                          : limit.value.value > required.value.value;
}

// Returns words for a number that replaces the row's; "" for any other.
calc::Message special_words(const RuleCheck& check, const Limit& limit, const LimitScope& scope) {
  if (limit.special == nullptr) return {};
  const Limit usual = evaluate_limit(check, {scope.pack, scope.row, scope.level, scope.facts});
  const char* unit = base_unit(check.dimension());
  const calc::Message is = number_of(limit.value.value, unit);
  const calc::Message was = usual.status == LimitStatus::known ? number_of(usual.value.value, unit)
                                                               : calc::Message::words("?");
  calc::Message words = limit.special->place == calc::SpecialPlace::unknown_task
                            ? calc::say<calc::Sentence::unknown_task>(is, was)
                            : calc::say<calc::Sentence::other_wall>(is, was);
  append(words, calc::Message::words(limit.special->note));
  return words;
}

Requirement requirement_of(const RuleCheck& check, const Limit& limit, const Reference& reference,
                           const calc::SourceLocation& where) {
  Requirement requirement;
  requirement.metric = check.quantity->of_space.value_or(check.metric);
  requirement.arguments = check.arguments_of(requirement.metric);
  requirement.comparison = check.comparison;
  requirement.limit = limit.status == LimitStatus::known ? limit.value.value
                                                         : std::numeric_limits<double>::quiet_NaN();
  // A pack may say that the scene's levels are those of a battery in the end.
  const bool is_of_battery =
      check.state == LightState::end_of_duration && is_of_luminaires(requirement.metric);
  requirement.state =
      is_of_battery ? check.state : fixed_state(requirement.metric).value_or(check.state);
  requirement.scene = reference.scene.id;
  requirement.clause = clause_text(reference.pack, check, reference.row, limit.level, limit.trust);
  requirement.note = note_of(reference.pack, check, limit.trust);
  add_note(facts_words(check, reference.scope), requirement);
  add_note(special_words(check, limit, reference.scope), requirement);
  requirement.severity = check.severity;
  requirement.mask = check.mask;
  requirement.direct_only = check.direct_only;
  requirement.policy = reference.pack.policy;
  requirement.origin = {reference.pack.full_id(),
                        check.id,
                        reference.row == nullptr ? "" : reference.row->ref,
                        reference.scope.level,
                        reference.scope.facts,
                        {},
                        is_weakened(check, limit, reference.scope),
                        check.role == reference.pack.role,
                        !reference.pack.is_built_in};
  if (limit.level != RowLevel::required && !reference.level_because.empty()) {
    add_note(
        calc::say<calc::Sentence::level_because>(level_words(limit.level), reference.level_because),
        requirement);
  }
  if (limit.status == LimitStatus::unknown) requirement.problem = limit.reason;
  if (requirement.problem.empty()) requirement.problem = uncalculated_light(check);
  requirement.any_one_unit_out = check.any_one_unit_out;
  if (check.any_one_unit_out) {
    add_note(calc::say<calc::Sentence::one_out>(), requirement);
    if (requirement.problem.empty()) requirement.problem = reference.scene.outage_problem;
  }
  if (requirement.problem.empty() && check.sources == LightSources::emergency) {
    requirement.problem = reference.scene.problem;
  }
  requirement.where = where;
  return requirement;
}

// Returns whether the check fits the plane; false after an error.
bool fits_plane(ElementReader& reader, const RuleCheck& check, const Reference& reference) {
  // The mean of four planes is an approximation of the cylindrical illuminance, not it.
  const bool is_of_points = !check.quantity->of_space && reference.is_quantity_known;
  if (is_of_points && (check.quantity->kernel != reference.kernel ||
                       check.quantity->derived != reference.derived)) {
    reader.report(DiagnosticId::rule_wrong_quantity, reader.where(), check.role,
                  reference.pack.full_id(), check.quantity->name,
                  calc::quantity_name(reference.kernel, reference.derived));
    return false;
  }
  if (check.sources == LightSources::emergency && reference.scene.id.empty()) {
    reader.report(DiagnosticId::rule_needs_scene, reader.where(), check.role,
                  reference.pack.full_id());
    return false;
  }
  if (reference.row == nullptr && needs_row(check, reference.pack)) {
    reader.report(DiagnosticId::missing_partner, reader.where("pack"), reader.element().name,
                  "pack", "row");
    return false;
  }
  return true;
}

// Returns whether the check is required of the right plane, such as a road; false after an error.
bool is_where_it_can_be(ElementReader& reader, const RuleCheck& check, const Reference& reference) {
  const bool is_of_a_road = check.quantity->of_space && is_of_road(*check.quantity->of_space);
  if (is_of_a_road && reference.usual_role != calc::kCarriagewayRole) {
    reader.report(DiagnosticId::quantity_of_road, reader.where(), reader.element().name,
                  check.quantity->name);
    return false;
  }
  return true;
}

// Returns "; it does of 'task-vertical', 'wall'": the roles of planes for which the row has values.
std::string roles_words(const Reference& reference) {
  calc::Names roles;
  for (const RuleCheck& check : reference.pack.checks) {
    if (!check.quantity->kernel || !needs_row(check, reference.pack)) continue;
    if (evaluate_limit(check, reference.scope).status == LimitStatus::not_applicable) continue;
    const std::string_view role = check.role;
    if (std::find(roles.begin(), roles.end(), role) == roles.end()) roles.push_back(role);
  }
  return roles.empty() ? "" : "; it requires something of " + calc::join_choices(roles);
}

// Returns whether the check is required together with the pack's own role, because no plane has its
// role: requiring a row's task includes the colour rendering of its luminaires.
bool is_asked_along(const RuleCheck& check, const std::string& role, const LimitScope& scope) {
  return scope.row != nullptr && role == scope.pack.role && check.role != role &&
         check.quantity->of_space == Metric::colour_rendering &&
         evaluate_limit(check, scope).status != LimitStatus::not_applicable;
}

void add_asked_along(const std::string& role, const Reference& reference,
                     const calc::SourceLocation& where, std::vector<Requirement>& requirements) {
  for (const RuleCheck& check : reference.pack.checks) {
    if (!is_asked_along(check, role, reference.scope)) continue;
    requirements.push_back(
        requirement_of(check, evaluate_limit(check, reference.scope), reference, where));
    requirements.back().is_optional = true;
  }
}

std::vector<Requirement> requirements_of_role(ElementReader& reader, const std::string& role,
                                              const Reference& reference) {
  std::vector<Requirement> requirements;
  for (const RuleCheck& check : reference.pack.checks) {
    if (check.role != role) continue;
    if (!fits_plane(reader, check, reference)) return {};
    const Limit limit = evaluate_limit(check, reference.scope);
    if (limit.status == LimitStatus::not_applicable) continue;
    if (!is_where_it_can_be(reader, check, reference)) return {};
    requirements.push_back(requirement_of(check, limit, reference, reader.where()));
  }
  if (requirements.empty()) {
    reader.report(DiagnosticId::rule_requires_nothing, reader.where(), reference.pack.full_id(),
                  reference.row == nullptr ? "" : fmt::format(" row '{}'", reference.row->ref),
                  role, roles_words(reference));
    return {};
  }
  add_asked_along(role, reference, reader.where(), requirements);
  return requirements;
}

}  // namespace

std::vector<std::string> asked_checks(const std::string& role, const LimitScope& scope) {
  std::vector<std::string> ids;
  for (const RuleCheck& check : scope.pack.checks) {
    const bool is_own =
        check.role == role && evaluate_limit(check, scope).status != LimitStatus::not_applicable;
    if (is_own || is_asked_along(check, role, scope)) ids.push_back(check.id);
  }
  return ids;
}

ChosenLevel read_level(ElementReader& reader, const RulePack& pack, const RuleRow* row) {
  const std::string_view word = level_names()[reader.choice_or("level", level_names(), 0)];
  const RowLevel level = level_named(word);
  if (level == RowLevel::required && reader.has("level-because")) {
    reader.report(DiagnosticId::attribute_without_meaning, reader.where("level-because"),
                  reader.element().name, "level-because", "level=\"required\"");
  }
  if (level.steps != 0 && !reader.has("level-because")) {
    reader.report(DiagnosticId::missing_partner, reader.where("level"), reader.element().name,
                  "level", "level-because");
  }
  if (row != nullptr) {
    const calc::Names levels = pack.levels_of(*row);
    if (std::find(levels.begin(), levels.end(), word) == levels.end()) {
      reader.report(DiagnosticId::no_such_level, reader.where("level"), row->ref, pack.full_id(),
                    word, calc::join_choices(levels));
    }
  }
  return {level, reader.has("level-because") ? reader.text("level-because") : ""};
}

calc::Message clause_text(const RulePack& pack, const RuleCheck& check, const RuleRow* row,
                          const RowLevel& level, Trust trust) {
  std::string text = fmt::format("{}:{}", pack.title, pack.edition);
  if (!check.clause.empty()) {
    text += " " + check.clause;
  } else if (row != nullptr) {
    text += " " + row->ref;
  }
  if (level != RowLevel::required) text += fmt::format(" ({})", level_words(level));
  return with_trust(calc::Message::words(text), trust);
}

std::map<std::string, double> read_facts(ElementReader& reader, const RulePack& pack) {
  std::map<std::string, double> facts;
  if (!reader.has("facts")) return facts;
  const std::string text = reader.text("facts");
  calc::Names names;
  for (const RuleName& fact : pack.facts) names.push_back(fact.id);
  std::string_view rest = text;
  while (!calc::trim(rest).empty()) {
    const std::string_view part = calc::trim(rest.substr(0, rest.find(';')));
    rest = rest.find(';') == std::string_view::npos ? "" : rest.substr(rest.find(';') + 1);
    const std::size_t equals = part.find('=');
    const std::string id(calc::trim(part.substr(0, equals)));
    const RuleName* fact = pack.find_fact(id);
    if (fact == nullptr) {
      report_unknown_name(reader.diagnostics(), reader.where("facts"), "facts",
                          reader.element().name, "fact", id, names);
      continue;
    }
    const ParsedExpression value = parse_expression(
        equals == std::string_view::npos ? "" : calc::trim(part.substr(equals + 1)));
    const bool fits = value.expression && value.expression->kind == ExpressionKind::number &&
                      value.expression->dimension == fact->unit.dimension;
    if (!fits || !facts.emplace(id, value.expression->number).second) {
      reader.report(DiagnosticId::rule_fact, reader.where("facts"), part, id,
                    dimension_name(fact->unit.dimension), id, fact->unit.name);
    }
  }
  return facts;
}

void check_row_values(ElementReader& reader) {
  for (const char* name : kNeedPack) check_value(reader, name);
}

std::vector<Requirement> read_rule_reference(ElementReader& reader, const std::string& given_role,
                                             const RequirementContext& context,
                                             const ChosenScene& scene) {
  for (const char* name : kNeedPack) {
    if (!reader.has(name) || reader.has("pack")) continue;
    reader.report(DiagnosticId::missing_partner, reader.where(name), reader.element().name, name,
                  "pack");
    check_row_values(reader);
    return {};
  }
  const RulePack* pack = find_pack(reader, context.packs);
  if (pack == nullptr) {
    check_row_values(reader);
    return {};
  }
  const RuleRow* row = find_row(reader, *pack);
  const std::string role =
      given_role.empty() ? find_role(reader, *pack, context.usual_role) : given_role;
  if (reader.has("level")) reader.require_together("level", "row");
  const ChosenLevel chosen = read_level(reader, *pack, row);
  std::map<std::string, double> facts = read_facts(reader, *pack);
  if (!reader.ok() || role.empty()) return {};
  return requirements_of_role(
      reader, role,
      {*pack, row, LimitScope{*pack, row, chosen.level, std::move(facts), {}, context.special},
       chosen.because, context.kernel, context.derived, context.is_quantity_known, scene,
       context.usual_role});
}

}  // namespace rules
