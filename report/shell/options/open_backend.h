#pragma once
// What `check`, `plan` and `validate` need before they start, or a message.

#include "report/check/backend.h"
#include "report/shell/options/recording_reader.h"
#include "rules/pack/rule_pack.h"

#include <optional>
#include <string>
#include <vector>

namespace cli {

// Delivered packs and those of `paths`. Empty after an error, which has been printed.
std::optional<std::vector<rules::RulePack>> load_packs_or_print(
    const std::vector<std::string>& paths, const calc::FileReader& files);

// Empty after an error, which has been printed. Another backend is never taken instead.
std::optional<check::OpenBackend> open_or_complain(const check::BackendChoice& choice,
                                                   gpu::Fault fault,
                                                   const std::string& program_folder, bool quiet);

}  // namespace cli
