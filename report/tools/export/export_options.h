#pragma once
// The options of `luxgate export`.

#include <string>
#include <vector>

namespace cli {

struct ListedCommand;

struct ExportOptions {
  std::string target;  // "radiance"
  std::string project, folder;
  std::string space;                    // "" = the only one
  std::vector<std::string> rule_files;  // packs besides those delivered, folders too
  bool overwrites = false;
};

ListedCommand export_command(ExportOptions& options);
// "" = nothing is wrong.
std::string export_contradiction(const ExportOptions& options);

}  // namespace cli
