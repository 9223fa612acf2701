#pragma once
// Processor time that a thread spends in OpenGL: the driver's, which is not the program's.

namespace bench {

// Of the calling thread.
double thread_s();

struct OpenGlTime {
  double calls_s = 0.0;
  double clock_s = 0.0;  // asking the clock about them, not part of the calls
};

// Of the calling thread too, which has to be the only one with a context: in those calls that work
// on a device repeats. Each counts from the first question after its first use on.
OpenGlTime opengl_time();

}  // namespace bench
