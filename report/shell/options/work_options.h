#pragma once
// Options of `check` and `plan` for the amount of work and for who does it.

#include "calc/radiosity/gather/settings.h"
#include "report/check/backend.h"
#include "report/shell/command/command.h"

#include <string>
#include <vector>

namespace cli {

std::vector<Option> work_options(calc::RadiositySettings& settings);
std::vector<Option> backend_options(check::BackendRequest& request);
// Returns a problem that only all options together show; "" = none. Lowers the first sampling round
// to the most paths.
std::string complete_work(calc::RadiositySettings& settings, const check::BackendRequest& request);

// Returns "--method instant-radiosity --clamp 10": options of the method that differ from the
// default; "" = none.
std::string method_words(const calc::RadiositySettings& settings);
// Returns " --seed 2 --backend cpu": options that change results and differ from the default,
// quoted for a shell.
std::string work_words(const calc::RadiositySettings& settings,
                       const check::BackendRequest& request);

}  // namespace cli
