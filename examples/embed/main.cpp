// Checks one project and prints the average of each plane and the verdict of each requirement.
//   embed PROJECT.xml
#include "report/check/run.h"
#include "report/text/words.h"

#include <cstdio>

int main(int argc, char** argv) {
  if (argc != 2) return std::fprintf(stderr, "usage: embed PROJECT.xml\n"), 2;
  check::Settings settings;
  settings.confidence = 0.99;

  const check::Run run(settings);
  const report::ProjectPart project = run.check(argv[1]);
  for (const calc::Diagnostic& message : project.diagnostics) {
    std::fprintf(stderr, "%s\n", calc::format_diagnostic(message).c_str());
  }
  for (const report::SpacePart& space : project.spaces) {
    for (const report::PlanePart& plane : space.planes) {
      if (!plane.is_computed) continue;
      const calc::Estimate& average = plane.average;
      std::printf("%s/%s: %zu points, average %.1f lx (%.1f to %.1f)\n", space.id.c_str(),
                  plane.id.c_str(), plane.points.size(), average.value, average.low, average.high);
      for (const rules::Finding& finding : plane.findings) {
        std::printf("  %s: %s\n", report::quantity_words(finding.requirement).c_str(),
                    report::verdict_words({}, finding.verdict));
      }
    }
  }
  return outcome_of(project) == rules::Outcome::pass ? 0 : 1;
}
