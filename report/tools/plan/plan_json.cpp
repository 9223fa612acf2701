#include "calc/proofs/skips.h"
#include "report/text/json_layout.h"
#include "report/tools/plan/plan.h"

#include <nlohmann/json.hpp>

namespace cli {
namespace {

using Json = nlohmann::ordered_json;

Json prediction_json(const calc::Prediction& prediction, std::uint64_t paths) {
  const calc::Work& work = prediction.work;
  const calc::Seconds& seconds = prediction.seconds;
  return {{"paths_per_replicate", paths},
          {"light_paths", work.light_paths},
          {"pool_rays", work.pool_rays},
          {"direct_rays", work.direct_rays},
          {"connection_rays", work.connection_rays},
          {"near_rays", work.near_rays},
          {"prepare_s", seconds.prepare},
          {"direct_s", seconds.direct},
          {"pool_s", seconds.pool},
          {"connect_s", seconds.connect},
          {"near_s", seconds.near_field},
          {"total_s", seconds.total()},
          {"bytes", prediction.bytes}};
}

Json space_json(const check::SpacePlan& space, const calc::RadiositySettings& settings) {
  Json json = {{"id", space.id},
               {"name", space.name},
               {"triangles", space.triangles},
               {"luminaires", space.plan.luminaires},
               {"looks", space.plan.looks},
               {"threads", space.plan.threads},
               {"planes", Json::array()},
               {"skips", Json::array()},
               {"first_look", prediction_json(space.plan.first_look, settings.first_paths)},
               {"last_look", prediction_json(space.plan.last_look, settings.max_paths)}};
  json["notes"] = Json::array();
  for (const calc::Message& note : space.notes) json["notes"].push_back(note.english());
  for (std::size_t p = 0; p < space.plan.planes.size(); ++p) {
    const calc::PlanePlan& plane = space.plan.planes[p];
    json["planes"].push_back({{"id", plane.plane_id},
                              {"grid", space.rule_of_grid[p]},
                              {"points", plane.points},
                              {"luminaires", plane.luminaires},
                              {"points_with_reflected_light", plane.seeing_points},
                              {"exact", plane.is_exact}});
  }
  for (const calc::SkipDecision& decision : space.plan.skips) {
    Json skip = {{"name", calc::name_of(decision.skip)},
                 {"state", calc::name_of(decision.state)},
                 {"why", decision.why},
                 {"planes", decision.planes}};
    if (decision.body) skip["body"] = space.obstacle;
    json["skips"].push_back(std::move(skip));
  }
  return json;
}

}  // namespace

std::string render_plan_json(const std::vector<check::ProjectPlan>& projects,
                             const calc::RadiositySettings& settings,
                             const check::BackendChoice& backend,
                             const check::DrawingChoice& pictures) {
  Json json = {{"backend", backend.backend == check::Backend::gpu ? "gpu" : "cpu"},
               {"why_backend", backend.why},
               {"gpu_stages", Json::array()},
               {"pictures", pictures.is_hardware ? "gpu" : "software"},
               {"why_pictures", pictures.why},
               {"projects", Json::array()}};
  if (backend.backend == check::Backend::gpu) {
    for (const std::string_view name : check::gpu_stage_names(backend.stages)) {
      json["gpu_stages"].push_back(name);
    }
  }
  for (const check::ProjectPlan& project : projects) {
    Json part = {{"path", project.path},
                 {"name", project.name},
                 {"planned", project.is_planned},
                 {"spaces", Json::array()}};
    for (const check::SpacePlan& space : project.spaces) {
      part["spaces"].push_back(space_json(space, settings));
    }
    json["projects"].push_back(std::move(part));
  }
  return report::json_layout(json);
}

}  // namespace cli
