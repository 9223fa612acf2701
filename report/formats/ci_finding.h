#pragma once
// The document for CI systems: a flat list of findings, each with its own words, a place in a file
// and a fingerprint that is the same in every revision.

#include "report/document/document.h"
#include "report/text/texts.h"

#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <vector>

namespace report {

struct CiFinding {
  const ProjectPart* project = nullptr;
  const SpacePart* space = nullptr;         // null: the whole project
  const PlanePart* plane = nullptr;         // null: the whole project
  const rules::Finding* finding = nullptr;  // null: nothing of the plane or project was judged
  // Not null: the entry is this aggregate of the project, and finding is null.
  const rules::AggregateFinding* aggregate = nullptr;
  rules::Verdict verdict = rules::Verdict::not_judged;
  bool counts = true;  // false: waived, advice, or known: it does not decide the exit code
  // It failed in the baseline, too, and the gate is for regressions.
  bool is_known = false;
  // Change since the baseline; none: there is no baseline.
  std::optional<ResultChange> change = {};

  // "average", "Uo", ..., "aggregate", "class"; "plane" or "project" without a finding.
  std::string rule;
  // Unique among the findings of a project, made of ids: "room/plane/requirement".
  std::string key;
  calc::SourceLocation where;  // of the <require>, the plane or the project
  std::string place;           // "Office / Desk 1", or the project's path
  // "average 462.0 ± 7.1 lx, required ≥ 500 lx, margin -7.6 %", or why there is no value.
  std::string message;
  // 64 hexadecimal digits of project path and key; not of values, lines or names.
  std::string fingerprint;
};

// Returns everything to be known of a project beside its findings: zones of workplaces that were
// not made or are omitted, the required parts of rows, planes changed by the project, remarks on
// planes and doubts about their points. "room: what", "room / plane: what"; printable(), in
// document order.
std::vector<std::string> ci_notes(const ProjectPart& project, const Texts& t = {});

// Returns the zones that workplaces omit, with who accepts that and the last day: "room: desk, EN
// ... 34.2: left out: wall.2 (glass, by A. Meier until 2027-06-30)"; printable(), in document
// order. For formats without ci_notes().
std::vector<std::string> ci_left_out(const ProjectPart& project, const Texts& t = {});

// Returns whether the requirement or aggregate is waived.
bool is_waived(const CiFinding& entry);

// The findings of a project, in its order: every requirement, every plane that was not computed
// although nothing that counts is required of it, and every project that could not be judged; then
// every aggregate and class. Text is printable(). Valid as long as the project. t: for messages of
// planes and projects; those of findings are English.
class CiFindings {
 public:
  // revision: contains the projects; null: none. It must outlive this.
  CiFindings(const Texts& t, const Revision* revision);
  explicit CiFindings(const DocumentFrame& frame, const Texts& t = {});
  std::vector<CiFinding> of(const ProjectPart& project) const;

 private:
  // Whether it is an aggregate; project, space, plane, item.
  using PlaceKey = std::tuple<bool, std::string, std::string, std::string, std::string>;

  static PlaceKey place_of(const CiFinding& entry);
  void add_change(CiFinding& entry) const;

  Texts t_;
  const Revision* revision_;
  std::map<PlaceKey, const ChangedResult*> changed_;
  std::set<const ChangedResult*> reasons_;  // at which the gate stops
};

}  // namespace report
