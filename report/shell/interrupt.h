#pragma once
// SIGINT and SIGTERM as a question. The only state of the process that is global: signals are.

namespace cli {

// After this the first SIGINT or SIGTERM sets a flag, and 0.9 s later the program ends with 130 if
// it has not ended by itself; a second one ends it at once.
void watch_for_interrupt();
bool interrupted();

}  // namespace cli
