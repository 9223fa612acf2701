#pragma once
// Options of `check` and `plan`: what the amount of work depends on, and who does it.

#include "calc/radiosity/gather/settings.h"
#include "report/check/backend.h"
#include "report/shell/command/command.h"

#include <string>
#include <vector>

namespace cli {

std::vector<Option> work_options(calc::RadiositySettings& settings);
std::vector<Option> backend_options(check::BackendRequest& request);
// What only all of them together show; "" = nothing is wrong. Lowers the first look to the most
// paths.
std::string complete_work(calc::RadiositySettings& settings, const check::BackendRequest& request);

// "--method instant-radiosity --clamp 10": what of the method is not as by default; "" = all is.
std::string method_words(const calc::RadiositySettings& settings);
// " --seed 2 --backend cpu": options that change results and are not as by default, quoted for a
// shell.
std::string work_words(const calc::RadiositySettings& settings,
                       const check::BackendRequest& request);

}  // namespace cli
