#include "report/policy/judge_policy.h"

#include "calc/base/day.h"
#include "calc/base/diagnostic_ids.h"
#include "calc/base/text.h"
#include "calc/project/reading/project_files.h"
#include "calc/scene/polygon.h"
#include "calc/scene/waiver.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace report {
namespace {

constexpr std::size_t kMostNamed = 8;

bool counts(const rules::Finding& finding) {
  return finding.requirement.severity != rules::Severity::advice;
}

std::vector<const PlanePart*> planes_of(const SpacePart& space,
                                        const std::vector<rules::RequirementName>& asked) {
  std::vector<const PlanePart*> planes;
  for (const PlanePart& plane : space.planes) {
    const bool is_one =
        std::any_of(asked.begin(), asked.end(),
                    [&](const rules::RequirementName& name) { return name.plane_id == plane.id; });
    if (is_one) planes.push_back(&plane);
  }
  return planes;
}

// Of the floor, how much lies under at least one of the planes, looked at from above at some ten
// thousand places: so that planes one above the other count once. Lists of points and planes that
// stand cover nothing.
double floor_share(const SpacePart& space, const std::vector<const PlanePart*>& planes) {
  constexpr int kPlaces = 120;  // along both sides
  struct Cover {
    std::vector<glm::dvec2> outline;
    std::vector<std::vector<glm::dvec2>> holes;

    bool has(const glm::dvec2& at) const {
      return calc::contains_point(outline, at) &&
             std::none_of(holes.begin(), holes.end(),
                          [&](const auto& hole) { return calc::contains_point(hole, at); });
    }
  };
  std::vector<Cover> covers;
  for (const PlanePart* plane : planes) {
    const calc::SensorGrid& grid = plane->grid;
    const auto seen_from_above = [&](const std::vector<glm::dvec2>& corners) {
      std::vector<glm::dvec2> seen;
      for (const glm::dvec2& corner : corners) {
        seen.emplace_back(grid.origin_m + corner.x * grid.u + corner.y * grid.v);
      }
      return seen;
    };
    Cover& cover = covers.emplace_back();
    cover.outline = seen_from_above(plane->outline_m);
    for (const auto& hole : plane->holes_m) cover.holes.push_back(seen_from_above(hole));
  }
  glm::dvec2 low = space.footprint_m.front(), high = low;
  for (const glm::dvec2& corner : space.footprint_m) {
    low = glm::min(low, corner);
    high = glm::max(high, corner);
  }
  int floor = 0, covered = 0;
  for (int i = 0; i < kPlaces * kPlaces; ++i) {
    const glm::dvec2 part((i % kPlaces + 0.5) / kPlaces, (i / kPlaces + 0.5) / kPlaces);
    const glm::dvec2 at = low + part * (high - low);
    if (!calc::contains_point(space.footprint_m, at)) continue;
    ++floor;
    covered += std::any_of(covers.begin(), covers.end(),
                           [&](const Cover& cover) { return cover.has(at); });
  }
  return floor > 0 ? static_cast<double>(covered) / floor : 0.0;
}

class PolicyJudge {
 public:
  PolicyJudge(const Policy& policy, std::string_view today, const ProjectPart& project)
      : policy_(policy), today_(today), project_(project) {}

  calc::Diagnostics judge() {
    for (const SpacePart& space : project_.spaces) {
      judge_signatures(space);
      if (policy_.every_space != PolicyEverySpace::nothing) judge_questions(space);
    }
    for (const rules::AggregateFinding& aggregate : project_.aggregates) {
      if (aggregate.sum) judge_finding("building '" + aggregate.building_id + "'", *aggregate.sum);
    }
    judge_photometry();
    for (const PolicyRow& row : policy_.rows) {
      if (row.is_for(project_.path)) judge_row(row);
    }
    for (const PolicyBound& bound : policy_.bounds) judge_bound(bound);
    return std::move(diagnostics_);
  }

 private:
  void fail(const calc::SourceLocation& where, const std::string& words) {
    diagnostics_.report(calc::DiagnosticId::policy_not_met, where, words);
  }
  void fail(const std::string& words) { fail({project_.path, 0, 0}, words); }

  void compare(double value, const std::optional<double>& at_least,
               const std::optional<double>& at_most, const std::string& what,
               const calc::SourceLocation& where) {
    if (at_least && !(value >= *at_least)) {
      fail(where, fmt::format("{} is {:.9g}; at least {} is allowed", what, value, *at_least));
    }
    if (at_most && !(value <= *at_most)) {
      fail(where, fmt::format("{} is {:.9g}; at most {} is allowed", what, value, *at_most));
    }
  }

  // what: "the waiver of 'average' of plane 'desk'".
  void judge_permit(const std::optional<PolicyPermit>& permit, const calc::Waiver& by,
                    const calc::SourceLocation& where, const std::string& what) {
    const calc::SourceLocation& place = by.where.line > 0 ? by.where : where;
    if (!permit) {
      fail(place, fmt::format("{} is not allowed for anybody", what));
      return;
    }
    const std::vector<std::string>& names = permit->by;
    if (!names.empty() && std::find(names.begin(), names.end(), by.owner) == names.end()) {
      fail(place, fmt::format("{} is by '{}'; allowed: {}", what, by.owner,
                              calc::list_names(names, kMostNamed)));
    }
    if (!permit->most_days) return;
    const int days = calc::days_between(today_, by.until);
    if (days > *permit->most_days) {
      fail(place, fmt::format("{} ends on {}, in {} days; allowed: {} days", what, by.until, days,
                              *permit->most_days));
    }
  }

  void judge_signatures(const SpacePart& space) {
    for (const PlanePart& plane : space.planes) {
      for (const rules::Finding& finding : plane.findings)
        judge_finding("plane '" + plane.id + "'", finding);
    }
    for (const rules::RowCoverage& row : space.coverage) {
      for (const rules::RoleCoverage& role : row.roles) {
        for (const rules::LeftOutZone& zone : role.left_out) {
          if (zone.has_ended) continue;
          judge_permit(policy_.left_out, zone.by, {project_.path, 0, 0},
                       fmt::format("leaving out zone '{}' of {} in space '{}'", zone.zone,
                                   row.clause.english(), space.id));
        }
      }
    }
  }

  // place: "plane 'desk'"
  void judge_finding(const std::string& place, const rules::Finding& finding) {
    const rules::Requirement& asked = finding.requirement;
    const std::string name = fmt::format("requirement '{}' of {}", asked.id, place);
    if (finding.is_waived && asked.waiver) {
      judge_permit(policy_.waivers, *asked.waiver, asked.where, "the waiver of " + name);
    }
    for (const rules::Deviation& deviation : asked.deviations) {
      if (!deviation.is_accepted || !deviation.stated) continue;
      judge_permit(policy_.deviations, *deviation.stated, asked.where,
                   fmt::format("the deviation in {} of {}", calc::name_of(deviation.aspect), name));
    }
    if (asked.origin.is_weakened && !policy_.allows_lowered_levels) {
      const std::string level = rules::level_words(asked.origin.level);
      fail(asked.where,
           fmt::format("{} is below what its row requires, {}", name,
                       level.empty() ? "by what the project says of its place" : level));
    }
    judge_facts(asked, name);
  }

  void judge_facts(const rules::Requirement& asked, const std::string& name) {
    for (const auto& [fact_id, value] : asked.origin.facts) {
      const std::string& id = fact_id;  // Clang 14 takes no binding into a lambda
      const auto allowed = std::find_if(
          policy_.facts.begin(), policy_.facts.end(),
          [&](const PolicyFact& fact) { return fact.pack == asked.origin.pack && fact.id == id; });
      const std::string what = fmt::format("fact '{}' of {}", id, name);
      if (allowed == policy_.facts.end()) {
        fail(asked.where, what + " is stated, but no <fact> allows it");
        continue;
      }
      compare(value, allowed->at_least, allowed->at_most, what, asked.where);
    }
  }

  void judge_photometry() {
    const std::vector<std::string>& allowed = policy_.photometry;
    if (allowed.empty()) return;
    const auto is_allowed = [&](const std::string& sha256) {
      return std::find(allowed.begin(), allowed.end(), sha256) != allowed.end();
    };
    constexpr std::string_view kWords = "is not an allowed photometry file; its SHA-256 is";
    std::vector<std::string> told;
    for (const LuminaireRow& luminaire : project_.luminaires) {
      if (luminaire.photometry_file.empty()) {
        fail(fmt::format("'{}' sends light without a photometry file", luminaire.type_id));
      } else if (!is_allowed(luminaire.sha256)) {
        told.push_back(luminaire.photometry_file);
        fail(fmt::format("'{}' of luminaire type '{}' {} {}", luminaire.photometry_file,
                         luminaire.type_id, kWords, luminaire.sha256));
      }
    }
    // And what such a file takes from others: the factors of a tilt.
    for (const calc::InputFile& input : project_.inputs) {
      const bool is_other =
          input.path == project_.path || calc::is_named_as_other_than_photometry(input.path);
      if (is_other || is_allowed(input.sha256)) continue;
      if (std::find(told.begin(), told.end(), input.path) != told.end()) continue;
      fail(fmt::format("'{}' {} {}", input.path, kWords, input.sha256));
    }
  }

  void judge_questions(const SpacePart& space) {
    const bool is_asked =
        std::any_of(space.planes.begin(), space.planes.end(), [](const PlanePart& plane) {
          return std::any_of(plane.findings.begin(), plane.findings.end(), counts);
        });
    if (!is_asked) fail(fmt::format("space '{}' has no requirement that counts", space.id));
    if (policy_.every_space != PolicyEverySpace::row) return;
    const std::vector<PolicyRow>& rows = policy_.rows;
    const bool is_wanted = std::any_of(rows.begin(), rows.end(), [&](const PolicyRow& row) {
      return row.is_for(project_.path) && row.spaces.has(space.id, space.name);
    });
    if (rows.empty() || is_wanted) return;
    fail(fmt::format("space '{}' matches no <asked>", space.id));
  }

  void judge_row(const PolicyRow& row) {
    int spaces = 0;
    for (const SpacePart& space : project_.spaces) {
      if (!row.spaces.has(space.id, space.name)) continue;
      ++spaces;
      judge_row_in(row, space);
    }
    if (spaces < row.at_least) {
      fail(fmt::format("{} spaces match '{}' of <asked> for {} {}; at least {} are needed", spaces,
                       row.spaces.pattern, row.pack, row.row, row.at_least));
    }
  }

  // All that is asked of the row there, and nothing of it left.
  void judge_row_in(const PolicyRow& row, const SpacePart& space) {
    std::vector<rules::RequirementName> asked;
    for (const PlanePart& plane : space.planes) {
      for (const rules::Finding& finding : plane.findings) {
        const rules::RuleOrigin& origin = finding.requirement.origin;
        if (counts(finding) && origin.pack == row.pack && origin.row == row.row) {
          asked.push_back({plane.id, finding.requirement.id});
        }
      }
    }
    const std::string name = fmt::format("{} {} of space '{}'", row.pack, row.row, space.id);
    if (asked.empty()) {
      fail(name + " is not required");
      return;
    }
    const auto is_of = [&](const rules::RequirementName& one) {
      return std::any_of(asked.begin(), asked.end(), [&](const rules::RequirementName& other) {
        return one.plane_id == other.plane_id && one.id == other.id;
      });
    };
    judge_zones(row, space, asked, name);
    // Several workplaces may ask for it, each of its own zones.
    std::vector<rules::RequirementName> of_role;
    bool is_known = false;
    for (const rules::RowCoverage& part : space.coverage) {
      const bool is_of_row =
          std::any_of(part.roles.begin(), part.roles.end(), [&](const rules::RoleCoverage& role) {
            return std::any_of(role.of.begin(), role.of.end(), is_of);
          });
      if (!is_of_row) continue;
      is_known = true;
      if (!part.is_whole()) fail(name + " is required only in part");
      for (const rules::RoleCoverage& role : part.roles) {
        if (role.role != row.role) continue;
        of_role.insert(of_role.end(), role.of.begin(), role.of.end());
      }
    }
    if (!is_known) fail(name + ": it is not known whether all of it is required");
    if (row.floor_share) judge_floor(row, space, of_role, name);
  }

  void judge_zones(const PolicyRow& row, const SpacePart& space,
                   const std::vector<rules::RequirementName>& asked, const std::string& name) {
    if (row.zones == PolicyZones::any) return;
    for (const PlanePart* plane : planes_of(space, asked)) {
      if (plane->made_by.empty()) {
        fail(plane->where,
             fmt::format("{} is required on plane '{}', which no <workplace> has made", name,
                         plane->id));
      } else if (row.zones == PolicyZones::unchanged && !plane->changed.empty()) {
        fail(plane->where,
             fmt::format("{} is required on plane '{}', which the project has changed: {}", name,
                         plane->id, plane->changed.english()));
      }
    }
  }

  void judge_floor(const PolicyRow& row, const SpacePart& space,
                   const std::vector<rules::RequirementName>& of_role, const std::string& name) {
    if (space.footprint_m.empty()) {
      fail(fmt::format("{}: the size of the floor is not known", name));
      return;
    }
    const double share = floor_share(space, planes_of(space, of_role));
    if (share >= *row.floor_share) return;
    fail(fmt::format("{}: planes of role '{}' cover {:.3g} of the floor; at least {} is needed",
                     name, row.role, share, *row.floor_share));
  }

  // Of what glare outdoors is rated on, which is stated with the requirement.
  void compare_fields(const auto& compare) {
    for (const SpacePart& space : project_.spaces) {
      for (const PlanePart& plane : space.planes) {
        for (const rules::Finding& finding : plane.findings) {
          const rules::Requirement& asked = finding.requirement;
          const double reflectance = rules::argument_of<rules::LitField>(asked).reflectance;
          if (!(reflectance > 0.0)) continue;
          compare(reflectance, fmt::format("the field of '{}'", asked.plane_id));
        }
      }
    }
  }

  void judge_bound(const PolicyBound& bound) {
    const auto compare = [&](double value, const std::string& of) {
      this->compare(value, bound.at_least, bound.at_most,
                    fmt::format("{} of {}", calc::name_of(bound.of), of), {project_.path, 0, 0});
    };
    if (bound.of == PolicyBoundOf::reflectance) {
      for (const MaterialRow& material : project_.materials) {
        compare(material.reflectance, fmt::format("material '{}'", material.id));
      }
      compare_fields(compare);
      return;
    }
    for (const LuminaireRow& luminaire : project_.luminaires) {
      const std::string name = fmt::format("luminaire type '{}'", luminaire.type_id);
      if (bound.of == PolicyBoundOf::maintenance_factor) {
        compare(luminaire.maintenance_factor, name);
        continue;
      }
      const bool is_flux = bound.of == PolicyBoundOf::flux_ratio;
      const double own = is_flux ? luminaire.flux_lm : luminaire.power_w;
      const double of_file = is_flux ? luminaire.file_flux_lm : luminaire.file_power_w;
      if (of_file > 0.0) {
        // Two roundings of the same number are no other number.
        constexpr double kSame = 1e-9;
        const double ratio = own / of_file;
        compare(std::abs(ratio - 1.0) < kSame ? 1.0 : ratio, name);
      } else {
        fail(fmt::format("{} of {} is not known: its file does not state it",
                         calc::name_of(bound.of), name));
      }
    }
  }

  const Policy& policy_;
  const std::string_view today_;
  const ProjectPart& project_;
  calc::Diagnostics diagnostics_;
};

}  // namespace

void judge_policy(const Policy& policy, std::string_view today, ProjectPart& project) {
  if (!project.is_judged) return;
  const calc::Diagnostics found = PolicyJudge(policy, today, project).judge();
  project.diagnostics.insert(project.diagnostics.end(), found.all().begin(), found.all().end());
}

}  // namespace report
