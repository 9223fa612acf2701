#include "report/tools/check/policy_bounds.h"

#include "calc/base/diagnostic_ids.h"
#include "report/shell/process/print.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>

namespace cli {
namespace {

// Whether `path` is it, or ends with it behind a '/', as it is from any folder above.
bool is_named(const std::string& path, const std::string& end) {
  std::error_code error;
  const std::string full = std::filesystem::absolute(path, error).lexically_normal().string();
  const std::string name = std::filesystem::path(end).lexically_normal().string();
  return full == name || full.ends_with("/" + name);
}

bool is_written(const OutputOptions& output, std::string_view kind) {
  const report::Format* standard = stdout_format(output);
  if (standard != nullptr && standard->name == kind) return true;
  const std::vector<OutputFormat> files = planned_files(output);
  return std::any_of(files.begin(), files.end(),
                     [kind](const OutputFormat& file) { return file.format->name == kind; });
}

}  // namespace

bool is_allowed_or_print(const report::Policy& policy, const CheckOptions& options) {
  calc::Diagnostics diagnostics;
  const auto forbid = [&](const std::string& words) {
    diagnostics.report(calc::DiagnosticId::policy_forbids, {}, policy.name, words);
  };
  const check::Settings& settings = options.settings;
  if (policy.confidence && settings.confidence < *policy.confidence) {
    forbid(fmt::format("--confidence {}; at least {} is allowed", settings.confidence,
                       *policy.confidence));
  }
  if (policy.tolerance && settings.tolerance > *policy.tolerance) {
    forbid(fmt::format("--tolerance {}; at most {} is allowed", settings.tolerance,
                       *policy.tolerance));
  }
  if (policy.replicates && settings.radiosity.replicates < *policy.replicates) {
    forbid(fmt::format("--replicates {}; at least {} is allowed", settings.radiosity.replicates,
                       *policy.replicates));
  }
  if (policy.max_paths && settings.radiosity.max_paths < *policy.max_paths) {
    forbid(fmt::format("--max-paths {}; at least {} is allowed", settings.radiosity.max_paths,
                       *policy.max_paths));
  }
  const bool wants_accuracy =
      policy.confidence || policy.tolerance || policy.replicates || policy.max_paths;
  if (wants_accuracy && settings.radiosity.clamp_per_m2 > 0.0) {
    forbid(fmt::format("--clamp {}; intervals do not include the light that it cuts off",
                       settings.radiosity.clamp_per_m2));
  }
  const std::vector<std::string>& given = options.input.projects;
  for (const std::string& project : policy.projects) {
    if (std::any_of(given.begin(), given.end(),
                    [&](const std::string& path) { return is_named(path, project); })) {
      continue;
    }
    forbid(fmt::format("'{}' is not among the projects, and must be", project));
  }
  for (const std::string& format : policy.formats) {
    if (!is_written(options.output, format)) {
      forbid(fmt::format("'--format {}' is missing, and must be written", format));
    }
  }
  print_diagnostics(diagnostics.all(), true);
  return !diagnostics.has_errors();
}

}  // namespace cli
