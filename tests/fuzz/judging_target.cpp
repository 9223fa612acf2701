// Small projects from their text to every report: grids, a few light paths, verdicts.
#include "report/check/check_project.h"
#include "report/check/run.h"
#include "report/formats/format.h"
#include "tests/fuzz/checks.h"
#include "tests/fuzz/small_files.h"
#include "tests/fuzz/target.h"

#include <algorithm>
#include <utility>

namespace {

check::Settings small_settings() {
  check::Settings settings;
  settings.radiosity.replicates = 4;
  settings.radiosity.first_paths = settings.radiosity.max_paths = 16;
  settings.radiosity.jobs = 1;
  settings.today = "2026-01-01";
  using enum calc::BudgetOf;
  for (const auto& [of, most] : {std::pair{objects, 200.0}, std::pair{triangles, 2000.0},
                                 std::pair{points, 400.0}, std::pair{memory, 256.0 * (1 << 20)}}) {
    settings.budget[of] = most;
  }
  return settings;
}

bool has_error(const report::ProjectPart& part) {
  return std::any_of(part.diagnostics.begin(), part.diagnostics.end(), [](const auto& diagnostic) {
    return diagnostic.severity() == calc::Severity::error;
  });
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static fuzz::SmallFiles files;
  static const check::Run kRun = check::Run(small_settings()).with_files(files);
  files.project = fuzz::as_text(data, size);
  check::Observer nobody;
  report::Document document;
  document.projects.push_back(check::check_project("d/p.xml", kRun, nobody));
  const report::ProjectPart& part = document.projects.front();
  if (part.is_judged) fuzz::count_result();
  fuzz::require(part.is_judged || has_error(part), "judged, or why not");
  for (const report::SpacePart& space : part.spaces) {
    for (const report::PlanePart& plane : space.planes) {
      fuzz::require(plane.is_computed || !plane.reason.empty(), "computed, or why not");
      for (const rules::Finding& finding : plane.findings) {
        const bool is_pass = finding.verdict == rules::Verdict::pass;
        fuzz::require(!is_pass || (plane.is_computed && finding.requirement.problem.empty()),
                      "what is not computed or has a problem does not pass");
      }
    }
  }
  const report::FormatStyle style{report::TextOptions(), report::Texts()};
  for (const report::Format& format : report::formats()) {
    fuzz::require(!format.render(document, style).empty(), "a format that says something");
  }
  return 0;
}
