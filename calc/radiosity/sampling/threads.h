#pragma once
// Runs parallel work on a number of threads.

#include <functional>

namespace calc {

// Calls `run` with so many threads; 0: one per core. A caller that already runs among as many, as
// one of several projects or rooms, uses these: each has its own work, and helps others when it has
// none. Within `run` no thread takes work from outside it.
void on_threads(int jobs, const std::function<void()>& run);

}  // namespace calc
