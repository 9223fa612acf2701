#include "report/tools/check/checked_document.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/base/numbers_version.h"
#include "report/document/program_version.h"
#include "report/document/same_bits.h"

#include <fmt/format.h>

#include <exception>
#include <new>

namespace cli {
namespace {

report::ProjectPart failed_project(const std::string& path, calc::DiagnosticId id,
                                   const std::string& reason) {
  calc::Diagnostics diagnostics;
  diagnostics.report(id, {path, 0, 0}, reason);
  report::ProjectPart part;
  part.path = path;
  part.diagnostics = diagnostics.all();
  return part;
}

}  // namespace

report::ProjectPart check_safely(const std::string& path, const check::Context& context) {
  try {
    return check::check_project(path, context);
  } catch (const calc::BackendFailure& failure) {
    return failed_project(path, calc::DiagnosticId::backend_failed, failure.what());
  } catch (const std::bad_alloc&) {
    calc::Diagnostics diagnostics;
    diagnostics.report(calc::DiagnosticId::not_enough_memory, {path, 0, 0});
    report::ProjectPart part;
    part.path = path;
    part.diagnostics = diagnostics.all();
    return part;
  } catch (const std::exception& error) {
    return failed_project(path, calc::DiagnosticId::internal_error, error.what());
  }
}

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

report::Provenance provenance_of(const CheckOptions& options, check::Backend backend,
                                 const std::string& description) {
  const check::Settings& settings = options.settings;
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
  provenance.backend = description;
  provenance.numbers_version = calc::kNumbersVersion;
  return provenance;
}

void complete_provenance(report::Provenance& provenance, const report::Totals& totals,
                         const std::string& today, check::Backend backend) {
  if (totals.hangs_on_the_day) provenance.judged_on = today;
  provenance.same_bits = report::same_bits_of(totals, backend == check::Backend::gpu);
}

}  // namespace cli
