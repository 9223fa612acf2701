#include "report/shell/options/open_backend.h"

#include "calc/base/diagnostic_ids.h"
#include "report/check/load_rules.h"
#include "report/shell/process/print.h"

namespace cli {

std::optional<std::vector<rules::RulePack>> load_packs_or_print(
    const std::vector<std::string>& paths, const calc::FileReader& files) {
  calc::Diagnostics diagnostics;
  std::vector<rules::RulePack> packs = check::load_rule_packs(paths, files, diagnostics);
  print_diagnostics(diagnostics.all(), false);
  if (diagnostics.has_errors()) return std::nullopt;
  return packs;
}

std::optional<check::OpenBackend> open_or_complain(const check::BackendChoice& choice,
                                                   gpu::Fault fault,
                                                   const std::string& program_folder, bool quiet) {
  std::string problem, software;
  std::optional<check::OpenBackend> backend =
      check::open_backend(choice, fault, program_folder, problem, software);
  if (!backend) print_error(calc::DiagnosticId::backend_not_available, "gpu", problem);
  if (!software.empty()) {
    calc::Diagnostics diagnostics;
    diagnostics.report(calc::DiagnosticId::backend_is_software, {}, software);
    print_diagnostics(diagnostics.all(), quiet);
  }
  return backend;
}

}  // namespace cli
