#pragma once
// --sandbox: the process gives up the rights it does not need before it reads untrusted files. An
// attacker who exploits a mistake in a reader then has only the remaining rights.

#include "report/shell/command/command.h"

#include <string>
#include <vector>

namespace cli {

enum class SandboxMode { automatic, on, off };

Option sandbox_option(SandboxMode& target);

// Files, and folders with everything below; links are followed at once, not later.
struct SandboxRules {
  std::vector<std::string> read;  // what is not there is left out
  // These can also be read. For a file to be created this is the closest existing folder above it,
  // and everything in that folder can be written.
  std::vector<std::string> write;
  // Folder where OpenGL's drivers store compiled programs, instead of the user's folder; "" = none.
  std::string driver_folder = {};
};

// Restricts the rest of the process, as far as the kernel can: it opens only these files and the
// system's own libraries, devices and tables (Landlock); it starts no program, makes no socket and
// touches no other process (seccomp). A refused call is an ordinary error and ends nothing. Threads
// that already run keep access to files. Returns "" or what this kernel, or the limits of the
// process, do not allow.
std::string enter_sandbox(const SandboxRules& rules, const Environment& environment);

// Does the same according to `mode`. Returns false after an error, which is printed.
bool enter_sandbox_or_print(SandboxMode mode, const SandboxRules& rules,
                            const Environment& environment);

}  // namespace cli
