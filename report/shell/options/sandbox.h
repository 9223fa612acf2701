#pragma once
// --sandbox: the process gives up by itself what it does not need, before it reads anything that a
// stranger may have written. Who takes it over by a mistake in a reader has no more than that.

#include "report/shell/command/command.h"

#include <string>
#include <vector>

namespace cli {

enum class SandboxMode { automatic, on, off };

Option sandbox_option(SandboxMode& target);

// Files, and folders with all that is below them; links are followed now, not later.
struct SandboxRules {
  std::vector<std::string> read;  // what is not there is left out
  // To be read, too. Where something is to be made: the closest folder above it that exists, so
  // that whatever is in that folder can be written.
  std::vector<std::string> write;
  // Where OpenGL's drivers may keep what they compile, instead of in the user's folder; "" = they
  // keep nothing.
  std::string driver_folder = {};
};

// For the rest of the process, as far as the kernel can do it: no other file than those and the
// system's own libraries, devices and tables can be opened (Landlock); no program started, no
// socket made, no other process touched (seccomp). What is refused is an error like any other and
// ends nothing. Files are not closed to threads that run already. "" or what this kernel, or who
// rules over the process, does not allow.
std::string enter_sandbox(const SandboxRules& rules, const Environment& environment);

// The same as `mode` wants it. False after an error, which has been printed.
bool enter_sandbox_or_print(SandboxMode mode, const SandboxRules& rules,
                            const Environment& environment);

}  // namespace cli
