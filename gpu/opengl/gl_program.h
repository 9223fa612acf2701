#pragma once
// One compute shader.

#include "gpu/opengl/program_cache.h"

#include <cstdint>
#include <functional>
#include <map>
#include <string>

namespace gpu {

// Compiles with `compile`, which gives a linked program, or takes what the cache has for the key;
// the name of OpenGL, and whether the cache had it.
struct LinkedProgram {
  unsigned name = 0;
  bool is_from_cache = false;
};
LinkedProgram linked_program(const ProgramCache& cache, const std::string& key,
                             const std::function<unsigned()>& compile);

// All calls need the context current in which it was made, the destructor too.
class GlProgram {
 public:
  // Throws GlError with the compiler's messages. what: for messages, "gather".
  GlProgram(const std::string& what, const std::string& source, const ProgramCache& cache = {});
  ~GlProgram();
  GlProgram(const GlProgram&) = delete;
  GlProgram& operator=(const GlProgram&) = delete;

  void use() const;
  // Of the program in use. Names that the shader does not read, some in some variants of it, are
  // passed over.
  void set(const char* uniform, std::uint32_t value) const;
  void set(const char* uniform, float value) const;
  // Whether the cache had it.
  bool is_from_cache() const { return is_from_cache_; }

 private:
  int location(const char* uniform) const;

  unsigned name_ = 0;
  bool is_from_cache_ = false;
  mutable std::map<std::string, int, std::less<>> locations_;  // asked for so far
};

}  // namespace gpu
