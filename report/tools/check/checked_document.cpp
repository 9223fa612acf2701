#include "report/tools/check/checked_document.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/base/diagnostics.h"
#include "calc/base/numbers_version.h"
#include "report/document/program_version.h"
#include "report/document/same_bits.h"

#include <fmt/format.h>

#include <string>
#include <vector>

namespace cli {
void tell_set_values(const std::vector<check::SetValue>& set, report::ProjectPart& part) {
  std::vector<std::string> words;
  for (const check::SetValue& value : set) {
    if (!check::is_about_project(value)) words.push_back(value.words());
  }
  if (words.empty()) return;
  calc::Diagnostics diagnostics;
  diagnostics.report(calc::DiagnosticId::values_set, {part.path, 0, 0}, fmt::join(words, ", "));
  part.diagnostics.insert(part.diagnostics.begin(), diagnostics.all().front());
}

report::Provenance provenance_of(const CheckOptions& options, const check::Run& run) {
  const check::Settings& settings = run.settings();
  const check::Backend backend = run.backend().backend;
  report::Provenance provenance;
  provenance.program_version = report::program_version();
  CheckOptions used = options;  // what `auto` came to; its answer `cpu` is the usual one
  if (backend == check::Backend::gpu) used.backend.backend = backend;
  provenance.command_line = reproducible_command(used);
  provenance.selection = check::selection_words(settings.selection);
  provenance.timestamp = options.timestamp;
  provenance.seed = settings.radiosity.seed;
  provenance.confidence = settings.confidence;
  provenance.goal = settings.goal;
  provenance.tolerance = settings.tolerance;
  provenance.max_paths = settings.radiosity.max_paths;
  provenance.replicates = settings.radiosity.replicates;
  provenance.method = method_words(settings.radiosity);
  provenance.backend = run.description();
  provenance.numbers_version = calc::kNumbersVersion;
  return provenance;
}

void complete_provenance(report::Provenance& provenance, const report::Totals& totals,
                         const check::Run& run) {
  if (totals.hangs_on_the_day) provenance.judged_on = run.settings().today;
  provenance.same_bits = report::same_bits_of(totals, run.backend().backend == check::Backend::gpu);
}

}  // namespace cli
