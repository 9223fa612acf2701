#pragma once
// The threads that parallel work is shared among.

#include <functional>

namespace calc {

// Calls `run` among so many threads; 0: one per core. Where the caller already is among as many,
// as one of several projects or rooms, these are used: each has work of its own then, and helps
// others when it has none. Inside of `run` no thread takes up work from outside of it.
void on_threads(int jobs, const std::function<void()>& run);

}  // namespace calc
