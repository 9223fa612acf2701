#pragma once
// The report of an import: imported things, and omitted things with reasons.

#include "report/tools/import/design.h"
#include "report/tools/import/project_text.h"

#include <string>
#include <vector>

namespace cli {

struct ImportReport {
  const Design* design = nullptr;
  const ProjectText* project = nullptr;
  std::vector<std::string> changes;    // since the last import, in words
  std::vector<std::string> conflicts;  // where the project was changed by hand, too
  std::vector<std::string> written;
};

std::string import_as_text(const ImportReport& report);
std::string import_as_json(const ImportReport& report);

}  // namespace cli
