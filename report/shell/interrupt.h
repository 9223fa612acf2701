#pragma once
// SIGINT and SIGTERM as a question. The only state of the process that is global: signals are.

namespace cli {

// After this the first SIGINT or SIGTERM only sets a flag; a second one ends the program at once.
void watch_for_interrupt();
bool interrupted();

}  // namespace cli
