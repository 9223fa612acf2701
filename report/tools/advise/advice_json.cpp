#include "report/text/json_layout.h"
#include "report/tools/advise/advice.h"

#include <nlohmann/json.hpp>

#include <cmath>

namespace cli {
namespace {

using AdviceJson = nlohmann::ordered_json;

AdviceJson number_or_null(double value) {
  return std::isfinite(value) ? AdviceJson(value) : AdviceJson(nullptr);
}

AdviceJson finding_json(const rules::Finding& finding) {
  AdviceJson json{{"verdict", calc::name_of(finding.verdict)}};
  const bool is_judged = finding.verdict != rules::Verdict::not_judged;
  json["value"] = is_judged ? number_or_null(finding.measured.value) : AdviceJson(nullptr);
  json["low"] = is_judged ? number_or_null(finding.measured.low) : AdviceJson(nullptr);
  json["high"] = is_judged ? number_or_null(finding.measured.high) : AdviceJson(nullptr);
  if (finding.place_m) {
    json["place_m"] = {finding.place_m->x, finding.place_m->y, finding.place_m->z};
  }
  if (!finding.reason.empty()) json["reason"] = finding.reason;
  return json;
}

AdviceJson requirement_json(const AdvisedRequirement& one, bool has_levels) {
  const rules::Requirement& requirement = one.before.requirement;
  AdviceJson json{{"space", one.space},
                  {"plane", requirement.plane_id},
                  {"id", requirement.id},
                  {"quantity", calc::name_of(requirement.metric)},
                  {"comparison", calc::name_of(requirement.comparison)},
                  {"limit", number_or_null(requirement.limit)},
                  {"unit", rules::unit_of(requirement)},
                  {"clause", requirement.clause},
                  {"is_searched", one.not_searched.empty()}};
  if (!one.not_searched.empty()) json["not_searched"] = one.not_searched;
  json["before"] = finding_json(one.before);
  if (has_levels) json["after"] = finding_json(one.after);
  return json;
}

AdviceJson scene_json(const SceneAdvice& advice) {
  AdviceJson json{{"scene", advice.scene},
                  {"outcome", calc::name_of(advice.outcome)},
                  {"is_all_met", advice.has_levels() && advice.is_all_met()}};
  if (!advice.reason.empty()) json["reason"] = advice.reason;
  json["unit"] = advice.is_by_flux ? "lm" : "W";
  json["now"] = advice.now;
  if (advice.has_levels()) {
    json["advised"] = advice.advised;
    json["least"] = advice.least;
  }
  json["groups"] = AdviceJson::array();
  for (const AdvisedGroup& group : advice.groups) {
    AdviceJson row{{"group", group.group},
                   {"luminaires", group.luminaires},
                   {"power_w", group.power_w},
                   {"flux_lm", group.flux_lm},
                   {"level_now", group.now}};
    if (advice.has_levels()) row["level"] = group.level;
    json["groups"].push_back(std::move(row));
  }
  json["requirements"] = AdviceJson::array();
  for (const AdvisedRequirement& one : advice.requirements) {
    json["requirements"].push_back(requirement_json(one, advice.has_levels()));
  }
  json["raised_for"] = AdviceJson::array();
  for (const std::size_t i : advice.raised_for) json["raised_for"].push_back(i);
  json["aggregates_not_met"] = advice.aggregates_not_met;
  json["contradicting"] = AdviceJson::array();
  for (const std::size_t i : advice.contradicting) json["contradicting"].push_back(i);
  return json;
}

}  // namespace

std::string render_advice_json(const Advice& advice) {
  AdviceJson json{{"format", "luxgate-advice"}, {"format_version", 1}, {"project", advice.project}};
  json["scenes"] = AdviceJson::array();
  for (const SceneAdvice& scene : advice.scenes) json["scenes"].push_back(scene_json(scene));
  return report::json_layout(json);
}

}  // namespace cli
