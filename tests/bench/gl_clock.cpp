#include "tests/bench/gl_clock.h"

#include <epoxy/gl.h>

#include <ctime>

#include <cstdint>
#include <utility>

namespace bench {
namespace {

// What two questions in a row find.
double seconds_of_asking() {
  constexpr int kTimes = 1000;
  const double begin_s = thread_s();
  for (int k = 0; k < kTimes; ++k) thread_s();
  return (thread_s() - begin_s) / kTimes;
}

thread_local OpenGlTime sum;
double asking_s = 0.0;

class Stay {
 public:
  Stay() : begin_s_(thread_s()) {}
  ~Stay() {
    sum.calls_s += thread_s() - begin_s_ - asking_s;
    sum.clock_s += 2.0 * asking_s;
  }
  Stay(const Stay&) = delete;
  Stay& operator=(const Stay&) = delete;

 private:
  double begin_s_;
};

// libepoxy's pointer to a function of OpenGL: first to one that looks it up, which must stay alone.
template <auto& pointer>
struct Clocked;

template <class Result, class... Arguments, Result (*&pointer)(Arguments...)>
struct Clocked<pointer> {
  static inline Result (*const unknown)(Arguments...) = pointer;
  static inline Result (*original)(Arguments...) = nullptr;

  static Result call(Arguments... arguments) {
    const Stay stay;
    return original(arguments...);
  }
  static void install() {
    if (pointer != unknown && original == nullptr) original = std::exchange(pointer, &call);
  }
};

template <auto&... pointers>
void install() {
  (Clocked<pointers>::install(), ...);
}

}  // namespace

double thread_s() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

OpenGlTime opengl_time() {
  if (asking_s == 0.0) asking_s = seconds_of_asking();
  install<glBindBuffer, glBindBufferBase, glBufferData, glBufferStorage, glBufferSubData,
          glClearBufferSubData, glClientWaitSync, glCopyBufferSubData, glDeleteBuffers,
          glDeleteSync, glDispatchCompute, glDispatchComputeIndirect, glFenceSync, glFlush,
          glGenBuffers, glGetBufferSubData, glGetError, glGetInteger64v, glGetUniformLocation,
          glMapBufferRange, glMemoryBarrier, glUniform1f, glUniform1ui, glUseProgram>();
  return sum;
}

}  // namespace bench
