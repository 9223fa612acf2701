#include "report/formats/ci_finding.h"

#include "calc/base/file_hash.h"
#include "report/revision/gate.h"
#include "report/text/aggregate_words.h"
#include "report/text/clause_words.h"
#include "report/text/notices.h"
#include "report/text/number_format.h"
#include "report/text/plain_text.h"
#include "report/text/sentences.h"
#include "report/text/words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace report {
namespace {

std::string finding_message(const PlanePart& plane, const rules::Finding& finding) {
  const rules::Requirement& requirement = finding.requirement;
  const char* unit = rules::unit_of(requirement);
  const Threshold threshold{requirement.limit, requirement.comparison};
  std::string text = quantity_words(requirement, plane.kernel);
  const bool is_judged = finding.verdict != rules::Verdict::not_judged;
  if (is_judged) text += " " + measured_words({}, finding);
  text += ", required " + format_required(threshold, unit);
  if (requirement.state != rules::LightState::maintained) {
    text += fmt::format(" ({})", calc::name_of(requirement.state));
  }
  if (!requirement.scene.empty()) text += " in scene " + requirement.scene;
  if (is_judged && std::isfinite(finding.margin)) text += ", margin " + margin_words({}, finding);
  if (is_judged && finding.place_m) text += ", at " + format_position(*finding.place_m);
  if (!requirement.clause.empty()) text += " [" + clause_words({}, requirement) + "]";
  if (!finding.reason.empty()) text += ": " + finding.reason.english();
  if (const std::string note = note_words(finding); !note.empty()) text += " (" + note + ")";
  if (finding.is_close) text += " (" + close_words(finding) + ")";
  return printable(text);
}

std::string project_message(const Texts& t, const ProjectPart& project) {
  const auto error =
      std::find_if(project.diagnostics.begin(), project.diagnostics.end(),
                   [](const calc::Diagnostic& d) { return d.severity() == calc::Severity::error; });
  if (error == project.diagnostics.end()) return t[Text::project_unreadable_brief];
  return printable(error->message);
}

CiFinding of_project(const Texts& t, const ProjectPart& project) {
  CiFinding entry;
  entry.project = &project;
  entry.rule = entry.key = "project";
  entry.where = {project.path, 0, 0};
  entry.place = printable(project.path);
  entry.message = t.say<Text::nothing_is_judged>(project_message(t, project));
  return entry;
}

CiFinding of_plane(const Texts& t, const ProjectPart& project, const SpacePart& space,
                   const PlanePart& plane) {
  CiFinding entry;
  entry.project = &project;
  entry.space = &space;
  entry.plane = &plane;
  entry.rule = "plane";
  entry.key = printable(space.id + "/" + plane.id);
  entry.where = plane.where;
  entry.place =
      printable(title_of(space.name, space.id)) + " / " + printable(plane_title(t, plane));
  entry.message = t.say<Text::not_computed_brief>(printable(sentence(t, plane.reason)));
  return entry;
}

CiFinding of_finding(CiFinding entry, const rules::Finding& finding) {
  entry.finding = &finding;
  entry.verdict = finding.verdict;
  entry.counts = rules::counts(outcome_of(finding));
  entry.rule = calc::name_of(finding.requirement.metric);
  entry.key += "/" + printable(finding.requirement.id);
  if (!finding.requirement.where.file.empty()) entry.where = finding.requirement.where;
  entry.message = finding_message(*entry.plane, finding);
  return entry;
}

std::string aggregate_message(const rules::AggregateFinding& finding) {
  std::string text = fmt::format("{}: {}, required {}", aggregate_title({}, finding),
                                 aggregate_measured({}, finding), aggregate_required({}, finding));
  if (!finding.clause.empty()) text += " [" + clause_words({}, finding) + "]";
  if (!finding.reason.empty()) text += ": " + finding.reason.english();
  if (const std::string note = aggregate_note({}, finding); !note.empty())
    text += " (" + note + ")";
  return printable(text);
}

// number: how many of that name the place has had so far, with this one.
CiFinding of_aggregate(const ProjectPart& project, const rules::AggregateFinding& finding,
                       int number) {
  CiFinding entry;
  entry.project = &project;
  for (const SpacePart& space : project.spaces) {
    if (space.id == finding.space_id) entry.space = &space;
  }
  entry.aggregate = &finding;
  entry.verdict = finding.verdict;
  entry.counts = rules::counts(outcome_of(finding));
  entry.rule = calc::name_of(finding.kind);
  entry.key = printable(
      fmt::format("{}:{}/{}/{}", entry.rule, finding.space_id, finding.plane_id, finding.id));
  if (number > 1) entry.key += fmt::format("-{}", number);
  entry.where = finding.where;
  entry.place = printable(aggregate_place(project, finding));
  entry.message = aggregate_message(finding);
  return entry;
}

void add_aggregates(const ProjectPart& project, std::vector<CiFinding>& list) {
  std::map<std::string, int> seen;
  for (const rules::AggregateFinding& finding : project.aggregates) {
    const CiFinding first = of_aggregate(project, finding, 1);
    list.push_back(of_aggregate(project, finding, ++seen[first.key]));
  }
}

}  // namespace

bool is_waived(const CiFinding& entry) {
  if (entry.aggregate != nullptr) return entry.aggregate->is_waived;
  return entry.finding != nullptr && entry.finding->is_waived;
}

std::vector<std::string> ci_notes(const ProjectPart& project, const Texts& t) {
  std::vector<std::string> lines;
  for (const Notice& notice : notices_of(project)) {
    if (notice.kind != NoticeKind::left_out) lines.push_back(notice_line(t, notice));
  }
  return lines;
}

std::vector<std::string> ci_left_out(const ProjectPart& project, const Texts& t) {
  std::vector<std::string> lines;
  for (const Notice& notice : notices_of(project)) {
    if (notice.kind == NoticeKind::left_out) lines.push_back(notice_line(t, notice));
  }
  return lines;
}

CiFindings::CiFindings(const Texts& t, const Revision* revision) : t_(t), revision_(revision) {
  if (revision_ == nullptr) return;
  for (const ChangedResult& result : revision_->results) {
    const RevisionPlace& place = result.place;
    changed_[{result.is_aggregate, place.project, place.space, place.plane, place.item}] = &result;
  }
  const GateReasons reasons = reasons_of(*revision_);
  reasons_.insert(reasons.results.begin(), reasons.results.end());
}

CiFindings::CiFindings(const DocumentFrame& frame, const Texts& t)
    : CiFindings(t, frame.revised == nullptr ? nullptr : &*frame.revised->revision) {}

CiFindings::PlaceKey CiFindings::place_of(const CiFinding& entry) {
  if (entry.aggregate != nullptr) {
    const rules::AggregateFinding& finding = *entry.aggregate;
    return {true, entry.project->path, finding.space_id, finding.plane_id, finding.id};
  }
  return {false, entry.project->path, entry.space->id, entry.plane->id,
          entry.finding->requirement.id};
}

// What the revision did to it, and whether it is a failure that it may keep.
void CiFindings::add_change(CiFinding& entry) const {
  if (entry.finding == nullptr && entry.aggregate == nullptr) return;
  const auto found = changed_.find(place_of(entry));
  const ChangedResult* result = found == changed_.end() ? nullptr : found->second;
  entry.change = result == nullptr ? ResultChange::same : result->change;
  if (revision_->gate.mode == GateMode::all || entry.verdict != rules::Verdict::fail) return;
  // What failed before and became worse stands among the changes, with how much worse it is.
  const bool stops = entry.change != ResultChange::worse && reasons_.contains(result);
  entry.is_known = entry.counts && !stops;
  entry.counts = entry.counts && stops;
}

std::vector<CiFinding> CiFindings::of(const ProjectPart& project) const {
  std::vector<CiFinding> list;
  if (!project.is_judged) list.push_back(of_project(t_, project));
  for (const SpacePart& space : project.spaces) {
    for (const PlanePart& plane : space.planes) {
      const CiFinding entry = of_plane(t_, project, space, plane);
      bool is_told = plane.is_computed;
      for (const rules::Finding& finding : plane.findings) {
        list.push_back(of_finding(entry, finding));
        is_told = is_told || list.back().counts;
      }
      if (!is_told) list.push_back(entry);  // it decides the exit code all the same
    }
  }
  add_aggregates(project, list);
  for (CiFinding& entry : list) {
    if (entry.where.file.empty()) entry.where.file = project.path;
    // Lengths keep one pair of names from looking like another.
    entry.fingerprint =
        calc::sha256_hex(std::to_string(project.path.size()) + ":" + project.path + entry.key);
    if (revision_ != nullptr) add_change(entry);
  }
  return list;
}

}  // namespace report
