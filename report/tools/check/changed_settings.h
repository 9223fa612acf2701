#pragma once
// Changes that a revision of designs makes to the settings by which it would be judged after a
// merge.

#include "report/document/revision.h"
#include "report/shell/command/command.h"

#include <vector>

namespace cli {

// Adds settings that judge as requirements of the whole run, because a design must not bring weaker
// ones. A note names all that differ, with the values of the revision.
void add_changed_settings(const std::vector<SettingChange>& changes, report::Revision& revision);

}  // namespace cli
