#include "rules/binding/requirement_reader.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/base/sentences.h"
#include "calc/base/text.h"
#include "calc/base/xml_reader.h"
#include "calc/project/spaces/waiver_attributes.h"
#include "rules/binding/deviation_xml.h"
#include "rules/binding/requirement_attributes.h"
#include "rules/binding/rule_reference.h"
#include "rules/binding/waiver_xml.h"
#include "rules/catalogue/limit_text.h"
#include "rules/measure/derived_metrics.h"
#include "rules/pack/named_pack.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <initializer_list>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

namespace rules {
namespace {

using calc::DiagnosticId;
using calc::ElementReader;
using calc::Names;

constexpr const char* kElement = "require";
constexpr std::string_view kReflectance = "reflectance";

// Of grass, sand, clay, concrete and what else sport is played on.
constexpr double kLeastUsualField = 0.1, kMostUsualField = 0.4;

double read_field_reflectance(ElementReader& reader) {
  const double reflectance = reader.number(kReflectance, calc::kPositiveFraction);
  if (reflectance > 0.0 && (reflectance < kLeastUsualField || reflectance > kMostUsualField)) {
    reader.report(DiagnosticId::field_reflectance_unusual, reader.where(kReflectance), kElement,
                  reflectance);
  }
  return reflectance;
}

// Returns whether the element has an attribute of this form: its own limit, or a row of a rule
// pack.
bool has_any(const ElementReader& reader, AttributeForm form) {
  const auto& all = requirement_attributes();
  return std::any_of(all.begin(), all.end(), [&](const RequirementAttribute& attribute) {
    return attribute.form == form && reader.has(attribute.name);
  });
}

// Returns the index of the word; 0 after an error.
std::size_t read_word(ElementReader& reader, std::string_view name, std::size_t usual) {
  return reader.choice_or(name, requirement_attribute(name).type->words, usual);
}

void report_unfit(ElementReader& reader, std::string_view attribute, std::string_view beside) {
  reader.report(DiagnosticId::attribute_without_meaning, reader.where(attribute), kElement,
                attribute, beside);
}

void report_unknown(ElementReader& reader, std::string_view attribute, std::string_view kind,
                    std::string_view found, const Names& choices, std::string_view shown) {
  const std::string allowed =
      shown.empty() ? fmt::format("no {} is defined", kind) : fmt::format("allowed: {}", shown);
  reader.report(DiagnosticId::unknown_reference, reader.where(attribute), attribute, kElement, kind,
                found, allowed, calc::suggestion(found, choices));
}

// Returns whether the attribute is given; it belongs to a single quantity.
bool is_given_for(ElementReader& reader, std::string_view attribute, Metric owner, Metric metric) {
  if (owner == metric) return true;
  if (reader.has(attribute)) {
    report_unfit(reader, attribute, fmt::format("quantity=\"{}\"", calc::name_of(metric)));
  }
  return false;
}

LimitUnit read_unit(ElementReader& reader, Metric metric, calc::DerivedQuantity derived) {
  if (!has_unit_of_values(metric) || calc::is_plain_number(derived)) {
    if (reader.has("unit")) {
      report_unfit(reader, "unit", fmt::format("quantity=\"{}\"", calc::name_of(metric)));
    }
    return is_ratio(metric) ? LimitUnit::lux : LimitUnit::plain;
  }
  return read_word(reader, "unit", 0) == 0 ? LimitUnit::lux : LimitUnit::footcandle;
}

std::string read_scene(ElementReader& reader, const std::vector<calc::LightScene>& scenes) {
  if (!reader.has("scene")) return {};
  std::string scene = reader.text("scene");
  Names defined;
  for (const calc::LightScene& candidate : scenes) defined.emplace_back(candidate.id);
  const bool is_defined = std::find(defined.begin(), defined.end(), scene) != defined.end();
  if (!scene.empty() && !is_defined) {
    report_unknown(reader, "scene", "scene", scene, defined, calc::join_choices(defined));
  }
  return scene;
}

std::optional<glm::dvec3> read_direction(ElementReader& reader, const char* attribute) {
  const std::vector<double> given = reader.numbers(attribute, 3, kPointWords);
  const glm::dvec3 direction(given[0], given[1], given[2]);
  const double length = glm::length(direction);
  if (length > 0.0) return direction / length;
  reader.report(DiagnosticId::zero_vector, reader.where(attribute), attribute, kElement);
  return std::nullopt;
}

// Reads a range: for a share from, to or both; for heights of luminaires optional.
void read_range(ElementReader& reader, Metric metric, calc::DerivedQuantity derived,
                MetricArguments& arguments) {
  constexpr calc::NumberRange kHeight{0.0, 1.0e6, false, "a height in metres from 0 to 1e6"};
  constexpr calc::NumberRange kLux{0.0, 1.0e9, false, "an illuminance in lx from 0 to 1e9"};
  constexpr calc::NumberRange kPlain{0.0, 1.0e9, false, "a number from 0 to 1e9"};
  auto* heights = std::get_if<HeightRange>(&arguments);
  const bool has_heights = heights != nullptr;
  const calc::NumberRange& kEnd = has_heights                      ? kHeight
                                  : calc::is_plain_number(derived) ? kPlain
                                                                   : kLux;
  const Metric owner = has_heights ? metric : Metric::share;
  const bool has_from = is_given_for(reader, "from", owner, metric) && reader.has("from");
  const bool has_to = is_given_for(reader, "to", owner, metric) && reader.has("to");
  if (metric != owner) return;
  if (!has_from && !has_to && !has_heights) {
    reader.report(DiagnosticId::missing_form, reader.where(), kElement, "'from' or 'to', or both");
  }
  double& from = has_heights ? heights->from_m : std::get<ValueRange>(arguments).from;
  double& to = has_heights ? heights->to_m : std::get<ValueRange>(arguments).to;
  if (has_from) from = reader.number("from", kEnd);
  if (has_to) to = reader.number("to", kEnd);
  if (to < from || (has_heights && to == from)) {
    reader.report(DiagnosticId::rule_not_ascending, reader.where("to"), "to", kElement, "'from'");
  }
}

// Returns whether such points have this quantity; reports it if not.
bool check_metric(ElementReader& reader, Metric metric, const RequirementContext& context) {
  if (is_of_road(metric) && context.usual_role != calc::kCarriagewayRole) {
    reader.report(DiagnosticId::quantity_of_road, reader.where("quantity"), kElement,
                  calc::name_of(metric));
    return false;
  }
  if (!context.is_quantity_known || is_metric_of(metric, context.derived)) return true;
  Names allowed;
  for (const std::string_view name : requirement_attribute("quantity").type->words) {
    if (is_metric_of(*calc::find_value<Metric>(name), context.derived)) allowed.push_back(name);
  }
  reader.report(DiagnosticId::quantity_not_of_points, reader.where("quantity"), kElement,
                calc::name_of(metric), calc::quantity_name(context.kernel, context.derived),
                calc::join_choices(allowed));
  return false;
}

void read_quantity(ElementReader& reader, const RequirementContext& context,
                   Requirement& requirement) {
  const std::optional<Metric> metric =
      read_metric(reader, requirement_attribute("quantity").type->words);
  if (!metric || !check_metric(reader, *metric, context)) {
    // What they mean hangs on the quantity; that they are no numbers does not.
    for (const char* name :
         {"at-least", "at-most", "unit", "percent", "from", "to", "at", "facing", "reflectance"}) {
      check_value(reader, name);
    }
    return;
  }
  requirement.metric = *metric;
  requirement.arguments = metric_row(*metric).arguments;
  MetricArguments& arguments = requirement.arguments;
  const LimitUnit unit = read_unit(reader, *metric, context.derived);
  if (const std::optional<Comparison> comparison = read_comparison(reader)) {
    requirement.comparison = *comparison;
    requirement.limit = read_limit(reader, comparison_name(*comparison), *metric, unit);
  }
  if (is_given_for(reader, "percent", Metric::percentile, *metric)) {
    std::get<Percentile>(arguments).percent =
        reader.number("percent", *requirement_attribute("percent").type->range);
  }
  read_range(reader, *metric, context.derived, arguments);
  if (is_given_for(reader, kReflectance, Metric::glare_rating, *metric)) {
    std::get<LitField>(arguments).reflectance = read_field_reflectance(reader);
  }
  if (is_given_for(reader, "at", Metric::value_at_point, *metric)) {
    const std::vector<double> at = reader.numbers("at", 3, kPointWords);
    std::get<PointOfValue>(arguments).point_m = glm::dvec3(at[0], at[1], at[2]);
  }
  if (is_given_for(reader, "facing", Metric::value_at_point, *metric) && reader.has("facing")) {
    std::get<PointOfValue>(arguments).facing = read_direction(reader, "facing");
  }
}

// Reads whether reflected light is omitted. A glare rating needs it.
bool read_light(ElementReader& reader, const Requirement& requirement) {
  const bool is_known = is_of_space(requirement.metric);
  const bool is_free = !is_known && requirement.derived != calc::DerivedQuantity::ugr;
  if (!is_free && reader.has("light")) {
    report_unfit(reader, "light",
                 is_known ? fmt::format("quantity=\"{}\"", calc::name_of(requirement.metric))
                          : std::string("ugr points"));
    return false;
  }
  return read_word(reader, "light", 0) == 1;
}

std::vector<Requirement> read_own(ElementReader& reader, const RequirementContext& context) {
  Requirement requirement;
  requirement.where = reader.where();
  requirement.derived = context.derived;
  if (reader.has("id")) requirement.id = reader.id();
  if (reader.has("was")) requirement.was = reader.id("was");
  read_quantity(reader, context, requirement);
  // Glare is worst when everything is new.
  const std::size_t usual = context.derived == calc::DerivedQuantity::ugr ? 1 : 0;
  requirement.state =
      read_word(reader, "state", usual) == 0 ? LightState::maintained : LightState::initial;
  // Installed power is that of full output, and the others say of which light they are.
  const std::optional<LightState> fixed = fixed_state(requirement.metric);
  if (fixed) requirement.state = *fixed;
  for (const char* name : {"state", "scene"}) {
    const bool is_free = fixed && std::string_view(name) == "scene";
    if ((is_of_space(requirement.metric) || fixed) && !is_free && reader.has(name)) {
      report_unfit(reader, name, fmt::format("quantity=\"{}\"", calc::name_of(requirement.metric)));
    }
  }
  requirement.scene = read_scene(reader, context.scenes);
  requirement.direct_only = read_light(reader, requirement);
  requirement.clause = calc::Message::words(std::string(calc::trim(reader.text_or("clause", ""))));
  return {requirement};
}

bool dims_nothing(const std::string& scene, const std::vector<calc::LightScene>& scenes) {
  return std::any_of(scenes.begin(), scenes.end(), [&](const calc::LightScene& candidate) {
    const auto& levels = candidate.level_of_group;
    return candidate.id == scene &&
           std::all_of(levels.begin(), levels.end(),
                       [](const auto& level) { return level.second >= 1.0; });
  });
}

// Returns luminaires that a scene does not name, which are at full output; for emergencies this
// must be stated. "" = all are named.
calc::Message unnamed_luminaires(const std::string& scene, const RequirementContext& context) {
  if (scene.empty() || context.space == nullptr) return {};
  const auto is_named = [&](const std::string& group) {
    return std::any_of(context.scenes.begin(), context.scenes.end(), [&](const auto& candidate) {
      return candidate.id == scene &&
             std::any_of(candidate.level_of_group.begin(), candidate.level_of_group.end(),
                         [&](const auto& level) { return level.first == group; });
    });
  };
  std::size_t unnamed = 0;
  std::string first;
  for (const calc::Luminaire& luminaire : context.space->luminaires) {
    if (!luminaire.group.empty() && is_named(luminaire.group)) continue;
    if (++unnamed == 1) first = luminaire.id;
  }
  if (unnamed == 0) return {};
  return calc::say<calc::Sentence::emergency_not_said>(scene, unnamed, first);
}

// Returns why no single luminaire can be switched off: luminaires of one dimming group go out
// together. "" = each can.
calc::Message outage_problem(const std::string& scene, const RequirementContext& context) {
  if (scene.empty()) return calc::say<calc::Sentence::outage_not_said>();
  if (context.space == nullptr) return {};
  const auto chosen = std::find_if(context.scenes.begin(), context.scenes.end(),
                                   [&](const auto& candidate) { return candidate.id == scene; });
  if (chosen == context.scenes.end()) return {};
  std::map<std::string, std::string> first_of_group;
  for (const calc::Luminaire& luminaire : context.space->luminaires) {
    const auto& levels = chosen->level_of_group;
    const bool is_dark = std::any_of(levels.begin(), levels.end(), [&](const auto& level) {
      return level.first == luminaire.group && level.second == 0.0;
    });
    if (is_dark) continue;
    const auto [first, is_new] = first_of_group.emplace(luminaire.group, luminaire.id);
    if (is_new && !luminaire.group.empty()) continue;
    return calc::say<calc::Sentence::no_own_group>(luminaire.id, scene);
  }
  return {};
}

// Reads the reflectance of the field on which glare is rated, because no pack can know it.
void take_reflectance(ElementReader& reader, std::vector<Requirement>& requirements) {
  if (!reader.has(kReflectance)) return;
  const double reflectance = read_field_reflectance(reader);
  bool is_of_use = false;
  for (Requirement& requirement : requirements) {
    auto* field = std::get_if<LitField>(&requirement.arguments);
    if (field == nullptr) continue;
    field->reflectance = reflectance;
    is_of_use = true;
  }
  if (!is_of_use && reader.ok())
    report_unfit(reader, kReflectance, "a row that does not require GR");
}

// Reads a rule. The scene is the project's choice; everything else is the pack's. role: of a plane
// that a workplace has made; "": the element may have one.
std::vector<Requirement> read_rule(ElementReader& reader, const std::string& role,
                                   const RequirementContext& context) {
  const std::string scene = read_scene(reader, context.scenes);
  std::vector<Requirement> requirements = read_rule_reference(
      reader, role, context,
      {scene, unnamed_luminaires(scene, context), outage_problem(scene, context)});
  take_reflectance(reader, requirements);
  if (!dims_nothing(scene, context.scenes)) return requirements;
  // Right for a project of emergency luminaires alone, and a false pass for any other.
  for (Requirement& requirement : requirements) {
    add_note(calc::say<calc::Sentence::dims_nothing>(scene), requirement);
  }
  return requirements;
}

// Reads the attributes waived-because, waived-by and waived-until of an own limit: all of them or
// none.
std::optional<Waiver> read_own_waiver(ElementReader& reader) {
  const bool is_whole = reader.require_together("waived-because", "waived-by") &&
                        reader.require_together("waived-by", "waived-until");
  if (!is_whole || !reader.has("waived-until")) return std::nullopt;
  return calc::read_waiver(reader, {"waived-because", "waived-by", "waived-until"});
}

std::vector<std::string> checks_of(const std::vector<Requirement>& requirements) {
  std::vector<std::string> ids;
  for (const Requirement& requirement : requirements) ids.push_back(requirement.origin.check);
  return ids;
}

// Refuses own waivers beside a row, where they would waive checks that nobody has reviewed.
void refuse_own_waiver(ElementReader& reader, const std::vector<Requirement>& requirements) {
  for (const RequirementAttribute& attribute : requirement_attributes()) {
    if (attribute.form != AttributeForm::waiver || !reader.has(attribute.name)) continue;
    const std::string checks = fmt::format("{}", fmt::join(checks_of(requirements), " "));
    return reader.report(DiagnosticId::waiver_of_whole_row, reader.where(attribute.name),
                         attribute.name, checks.empty() ? "..." : checks);
  }
}

// Refuses attributes that only have a meaning with a row.
void refuse_parts_of_rows(ElementReader& reader) {
  for (const calc::XmlElement& child : reader.element().children) {
    if (child.name == "deviation") {
      reader.report(DiagnosticId::deviation_of_own_limit, child.where);
    }
    if (child.name == "waiver") reader.report(DiagnosticId::waiver_of_own_limit, child.where);
  }
}

// Takes the waivers. Those of a workplace were checked when its planes were made, and waivers of
// other roles than this are not used here.
void take_waivers(ElementReader& reader, const std::string& role, const RequirementContext& context,
                  std::vector<Requirement>& requirements) {
  if (!reader.has("pack")) return;
  const RulePack* pack = named_pack(reader.element().find("pack")->value, context.packs).pack;
  const std::vector<WaivedCheck> waived = read_waived_checks(reader, pack);
  if (role.empty() && pack != nullptr && !requirements.empty()) {
    check_waived_are_asked(reader, waived, *pack, checks_of(requirements));
  }
  for (Requirement& requirement : requirements) {
    for (const WaivedCheck& one : waived) {
      if (one.check == requirement.origin.check) requirement.waiver = one.by;
    }
  }
}

// Reads <require>.
std::vector<Requirement> read_written(ElementReader& reader, const RequirementContext& context) {
  reader.allow(require_element());
  std::vector<Requirement> requirements;
  if (has_any(reader, AttributeForm::row)) {
    for (const RequirementAttribute& attribute : requirement_attributes()) {
      const bool is_unfit = attribute.form == AttributeForm::own && reader.has(attribute.name);
      if (is_unfit) report_unfit(reader, attribute.name, "pack");
    }
    requirements = read_rule(reader, "", context);
  } else {
    requirements = read_own(reader, context);
  }
  if (!has_any(reader, AttributeForm::row)) {
    refuse_parts_of_rows(reader);
    const std::optional<Waiver> waiver = read_own_waiver(reader);
    for (Requirement& requirement : requirements) requirement.waiver = waiver;
  } else if (has_any(reader, AttributeForm::waiver)) {
    refuse_own_waiver(reader, requirements);
  }
  return requirements;
}

}  // namespace

std::vector<Requirement> read_requirement(const calc::RequirementText& text,
                                          const RequirementContext& context,
                                          calc::Diagnostics& diagnostics) {
  ElementReader reader(text.element, diagnostics);
  RequirementContext at_place = context;
  at_place.special = text.special;
  std::vector<Requirement> requirements =
      text.role.empty() ? read_written(reader, context) : read_rule(reader, text.role, at_place);
  take_waivers(reader, text.role, context, requirements);
  const std::vector<StatedDeviation> stated = read_deviations(reader, text.role);
  for (Requirement& requirement : requirements) {
    requirement.derived = context.derived;
    requirement.origin.workplaces = text.workplaces;
    if (!requirement.origin.pack.empty()) requirement.stated_deviations = stated;
  }
  if (!reader.ok()) requirements.clear();
  return requirements;
}

}  // namespace rules
