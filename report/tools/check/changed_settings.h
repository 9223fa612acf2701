#pragma once
// What a revision of designs changes in the settings by which it would be judged once it is merged.

#include "report/document/revision.h"
#include "report/shell/command/command.h"

#include <vector>

namespace cli {

// Settings that judge are questions of the whole run: none that asks for less is let in with a
// design. All that differ are named in a note, as those of the revision hold.
void add_changed_settings(const std::vector<SettingChange>& changes, report::Revision& revision);

}  // namespace cli
