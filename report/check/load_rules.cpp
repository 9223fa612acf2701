#include "report/check/load_rules.h"

#include "calc/base/diagnostic_ids.h"

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>

namespace check {
namespace {

std::vector<std::string> packs_in(const std::filesystem::path& folder, std::error_code& error) {
  std::vector<std::string> files;
  for (std::filesystem::directory_iterator it(folder, error), end; !error && it != end;
       it.increment(error)) {
    if (it->path().extension() == ".xml") files.push_back(it->path().string());
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

std::vector<std::string> rule_files(const std::vector<std::string>& paths,
                                    calc::Diagnostics& diagnostics) {
  std::vector<std::string> files;
  for (const std::string& path : paths) {
    std::error_code error;
    if (!std::filesystem::is_directory(path, error)) {
      files.push_back(path);
      continue;
    }
    const std::vector<std::string> found = packs_in(path, error);
    if (error || found.empty()) {
      diagnostics.report(calc::DiagnosticId::file_not_readable, {path, 0, 0}, path,
                         error ? error.message() : "the folder has no *.xml file");
    }
    files.insert(files.end(), found.begin(), found.end());
  }
  return files;
}

std::vector<rules::RulePack> load_rule_packs(const std::vector<std::string>& paths,
                                             const calc::FileReader& files,
                                             calc::Diagnostics& diagnostics) {
  std::vector<rules::RulePack> packs = rules::builtin_rule_packs();
  for (const std::string& path : rule_files(paths, diagnostics)) {
    const calc::FileContent content = files.read(path);
    if (!content.ok()) {
      diagnostics.report(calc::DiagnosticId::file_not_readable, {path, 0, 0}, path, content.error);
      continue;
    }
    std::optional<rules::RulePack> pack = rules::parse_rule_pack(content.bytes, path, diagnostics);
    if (!pack) continue;
    for (const rules::RulePack& known : packs) {
      if (known.full_id() != pack->full_id()) continue;
      diagnostics.report(calc::DiagnosticId::rule_pack_loaded_twice, {path, 0, 0}, pack->full_id(),
                         known.file);
    }
    packs.push_back(std::move(*pack));
  }
  return packs;
}

}  // namespace check
