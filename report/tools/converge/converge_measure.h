#pragma once
// Runs all methods on a ladder of paths, and compares them with the reference.

#include "calc/scene/project.h"
#include "report/tools/converge/converge_estimators.h"
#include "report/tools/converge/converge_options.h"
#include "report/tools/converge/converge_statistics.h"

#include <functional>
#include <string>
#include <vector>

namespace cli {

// Returns values for all light groups at full output and new lamps: [replicate][point].
std::vector<std::vector<double>> replicates_of(const calc::PlaneField& field, bool is_indirect);

struct Ladder {
  std::vector<report::ConvergeMethod> methods;
  std::vector<std::vector<report::ConvergeCurve>> curves;  // [plane][method]
  std::string problem;                                     // "" = measured
  bool is_interrupted = false;
};

// Runs the ladder. truths: one per task. announce: receives the next step.
Ladder climb(const ConvergeOptions& options, const EstimatorContext& context,
             const std::vector<report::ConvergeTruth>& truths,
             const std::function<void(const std::string&)>& announce);

}  // namespace cli
