#pragma once
// A document in which every name is an attack on whoever shows it.

#include "tests/support/sample_document.h"

#include <string>
#include <vector>

namespace report {

// One string of everything that breaks out of text, attributes, scripts, styles or lines.
inline std::string hostile_name() {
  return "</title></style></script><script>window.hacked=1</script><img src=x "
         "onerror=\"window.hacked=1\">\"'`&lt;]]>--><svg onload=window.hacked=1>"
         "\u202Eesrever \u05E9\u05DC\u05D5\u05DD \U0001F4A1\u200D\U0001F525 "
         "e\u0301\x01\x1B[31m\xFF\xC0\xAF";
}

// In every place where a name or a text of a file can stand; every second one has 10,000
// characters.
inline Document hostile_document() {
  int count = 0;
  const auto evil = [&count]() {
    return ++count % 2 == 0 ? hostile_name() + std::string(10000, 'x') : hostile_name();
  };
  Document document = sample_document();
  document.provenance.program_version = evil();
  document.provenance.command_line = evil();
  document.provenance.timestamp = evil();
  document.provenance.backend = evil();
  for (ProjectPart& project : document.projects) {
    project.path = evil();
    project.name = evil();
    for (const calc::AboutText& one : calc::kAboutTexts) project.about.*one.text = evil();
    for (calc::Diagnostic& diagnostic : project.diagnostics) {
      diagnostic.message = evil();
      diagnostic.where.file = evil();
    }
    for (LuminaireRow& row : project.luminaires) {
      row.type_id = evil();
      row.photometry_file = evil();
      row.name = evil();
      row.format = evil();
      row.sha256 = evil();
    }
    project.advice = {{evil(),
                       AdviceOutcome::levels,
                       {},
                       CostUnit::lumen,
                       2.0,
                       1.0,
                       {{evil(), 1, 0.0, 1.0, 0.0, 1.0, 0.5}},
                       0,
                       2,
                       {{evil(), evil()}},
                       {evil()},
                       {}},
                      {evil(),
                       AdviceOutcome::none_found,
                       calc::Message::words(evil()),
                       CostUnit::watt,
                       0,
                       0,
                       {},
                       0,
                       0,
                       {},
                       {},
                       {{evil(), evil()}}}};
    for (calc::InputFile& input : project.inputs) input = {evil(), evil()};
    for (SpacePart& space : project.spaces) {
      space.id = evil();
      space.name = evil();
      space.pictures.problem = evil();
      for (LuminaireMark& mark : space.luminaires) {
        mark.type_id = evil();
        mark.group = evil();
      }
      space.bodies = {{evil(), 0, 1, {{glm::dvec2(0), glm::dvec2(1)}}}};
      for (PlanePart& plane : space.planes) {
        plane.id = evil();
        plane.name = evil();
        plane.space_id = evil();
        plane.reason = calc::Message::words(evil());
        plane.where.file = evil();
        plane.grid.rule = calc::Message::words(evil());
        for (calc::DroppedPoint& point : plane.grid.dropped) point.body = evil();
        plane.by_luminaire.largest = {{evil(), evil(), evil(), {}, estimate(300, 3), 200, {}, 0}};
        plane.groups = {{evil(), estimate(300, 3), 200}, {evil(), estimate(100, 1), 50}};
        plane.looks = {{1024, 4096, plane.points.size(), plane.average, {}}};
        for (rules::Finding& finding : plane.findings) {
          finding.reason = calc::Message::words(evil());
          rules::Requirement& requirement = finding.requirement;
          requirement.id = evil();
          requirement.clause = calc::Message::words(evil());
          requirement.scene = evil();
          requirement.note = calc::Message::words(evil());
          requirement.mask.id = evil();
          requirement.where.file = evil();
          requirement.policy.tolerance_reason = evil();
          requirement.waiver = rules::Waiver{evil(), evil(), evil()};
          plane.looks[0].findings.push_back({finding.verdict, finding.measured});
        }
      }
    }
    label_luminaires(project);
  }
  return document;
}

}  // namespace report
