#include "rules/verdict/waiver_remarks.h"

#include "calc/base/day.h"
#include "calc/base/diagnostic_ids.h"

#include <fmt/format.h>

#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>

namespace rules {
namespace {

// Place and subject of a waiver: a workplace has the same for several planes.
using WaiverPlace = std::tuple<std::string, int, int, std::string>;

WaiverPlace place_of(const Waiver& waiver, const std::string& what) {
  return {waiver.where.file, waiver.where.line, waiver.where.column, what};
}

std::string waived_name(const Requirement& requirement) {
  return requirement.origin.check.empty() ? requirement.id : requirement.origin.check;
}

struct WaivedPlanes {
  const Finding* first = nullptr;
  std::size_t planes = 0;
  bool all_pass = true;
};

void warn_of_unneeded(const std::vector<JudgedPlane>& planes, calc::Diagnostics& diagnostics) {
  std::map<WaiverPlace, WaivedPlanes> waived;
  for (const JudgedPlane& judged : planes) {
    for (const Finding& finding : *judged.findings) {
      if (!finding.requirement.waiver) continue;
      WaivedPlanes& all =
          waived[place_of(*finding.requirement.waiver, waived_name(finding.requirement))];
      if (all.first == nullptr) all.first = &finding;
      ++all.planes;
      all.all_pass = all.all_pass && finding.verdict == Verdict::pass;
    }
  }
  for (const auto& [place, all] : waived) {
    if (!all.all_pass) continue;
    const Requirement& requirement = all.first->requirement;
    const Waiver& waiver = *requirement.waiver;
    diagnostics.report(calc::DiagnosticId::waiver_not_needed, waiver.where,
                       waived_name(requirement), waiver.owner, waiver.until,
                       all.planes == 1 ? fmt::format(" on plane '{}'", requirement.plane_id)
                                       : fmt::format(" on all {} planes", all.planes));
  }
}

// Reports each thing once, however many planes it is about.
class EndsSoon {
 public:
  EndsSoon(std::string_view today, calc::Diagnostics& diagnostics)
      : today_(today), diagnostics_(diagnostics) {}

  void tell(const std::string& what, const Waiver& waiver, const char* then) {
    if (!waiver.holds_on(today_)) return;
    const int days = calc::days_between(today_, waiver.until);
    if (days > kSoon_days) return;
    if (!told_.insert(place_of(waiver, what)).second) return;
    const std::string left = days == 0   ? "today"
                             : days == 1 ? "in 1 day"
                                         : fmt::format("in {} days", days);
    diagnostics_.report(calc::DiagnosticId::waiver_ends_soon, waiver.where, what, waiver.owner,
                        left, waiver.until, then);
  }

 private:
  std::string_view today_;
  calc::Diagnostics& diagnostics_;
  std::set<WaiverPlace> told_;
};

}  // namespace

void warn_about_waivers(const calc::Space& space, const std::vector<JudgedPlane>& planes,
                        std::string_view today, calc::Diagnostics& diagnostics) {
  warn_of_unneeded(planes, diagnostics);
  EndsSoon soon(today, diagnostics);
  for (const JudgedPlane& judged : planes) {
    for (const Finding& finding : *judged.findings) {
      const Requirement& requirement = finding.requirement;
      if (finding.is_waived && requirement.waiver) {
        soon.tell("the waiver", *requirement.waiver, "the waived requirement counts");
      }
      for (const Deviation& deviation : requirement.deviations) {
        if (!deviation.is_accepted || !deviation.stated) continue;
        soon.tell("the deviation", *deviation.stated, "the number is not judged");
      }
    }
  }
  for (const calc::LeftOutPlane& left_out : space.left_out) {
    soon.tell("leaving the zone out", left_out.by, "it counts as not judged");
  }
}

void warn_about_waivers(const std::vector<AggregateFinding>& buildings, std::string_view today,
                        calc::Diagnostics& diagnostics) {
  EndsSoon soon(today, diagnostics);
  for (const AggregateFinding& building : buildings) {
    if (!building.sum || !building.sum->requirement.waiver) continue;
    const Waiver& waiver = *building.sum->requirement.waiver;
    if (building.is_waived) soon.tell("the waiver", waiver, "the waived requirement counts");
    if (building.verdict != Verdict::pass) continue;
    diagnostics.report(calc::DiagnosticId::waiver_not_needed, waiver.where,
                       waived_name(building.sum->requirement), waiver.owner, waiver.until,
                       fmt::format(" for building '{}'", building.building_id));
  }
}

}  // namespace rules
