#pragma once
// SIGINT and SIGTERM as a question. The only state of the process that is global: signals are.

namespace cli {

// After this the first SIGINT or SIGTERM sets a flag, and 0.9 s later the program ends with 130 if
// it has not ended by itself; a second one ends it at once.
void watch_for_interrupt();
bool interrupted();
// Before files are written that belong together: from here on a first signal ends nothing, so that
// they are all written, and the exit code is theirs. False: it is too late, the run was
// interrupted.
bool begin_to_write();

}  // namespace cli
