#pragma once
// Manual pages, as troff with the macros of man(7).

#include "report/shell/command/command.h"

#include <string>
#include <vector>

namespace cli {

struct ManPage {
  std::string file;  // "luxgate-check.1"
  std::string text;
};

// Returns the page of a command that exists. command: its name; "" = the program.
ManPage man_page(const std::vector<Command>& commands, const std::string& command);

}  // namespace cli
