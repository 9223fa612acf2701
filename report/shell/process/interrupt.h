#pragma once
// SIGINT and SIGTERM as a query. This is the only global state of the process, because signals are
// global.

namespace cli {

// Makes the first SIGINT or SIGTERM set a flag; 0.9 s later the program ends with 130 if it has not
// ended by itself. A second signal ends it at once.
void watch_for_interrupt();
bool interrupted();
// To be called before writing files that belong together: a first signal then ends nothing, so that
// all are written, and the exit code is that of the files. Returns false if it is too late: the run
// was interrupted.
bool begin_to_write();

}  // namespace cli
