#pragma once
// Opens rule packs and backend before `check`, `plan` and `validate` start, or prints a message.

#include "report/check/backend.h"
#include "report/shell/options/recording_reader.h"
#include "rules/pack/rule_pack.h"

#include <optional>
#include <string>
#include <vector>

namespace cli {

// Returns delivered packs and those of `paths`; empty after an error, which is printed.
std::optional<std::vector<rules::RulePack>> load_packs_or_print(
    const std::vector<std::string>& paths, const calc::FileReader& files);

// Returns the backend; empty after an error, which is printed. Another backend is never used
// instead.
std::optional<check::OpenBackend> open_or_complain(const check::BackendChoice& choice,
                                                   gpu::Fault fault,
                                                   const std::string& program_folder, bool quiet);

}  // namespace cli
