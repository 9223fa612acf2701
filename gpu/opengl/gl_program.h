#pragma once
// One compute shader.

#include "gpu/opengl/program_cache.h"

#include <cstdint>
#include <functional>
#include <map>
#include <string>

namespace gpu {

// A linked program: its OpenGL name, and whether it is from the cache. linked_program() takes it
// from the cache by the key, else from `compile`.
struct LinkedProgram {
  unsigned name = 0;
  bool is_from_cache = false;
};
LinkedProgram linked_program(const ProgramCache& cache, const std::string& key,
                             const std::function<unsigned()>& compile);

// All calls, also the destructor, need the context current in which it was made.
class GlProgram {
 public:
  // Throws GlError with the compiler's messages. what: for messages, "gather".
  GlProgram(const std::string& what, const std::string& source, const ProgramCache& cache = {});
  ~GlProgram();
  GlProgram(const GlProgram&) = delete;
  GlProgram& operator=(const GlProgram&) = delete;

  void use() const;
  // Sets a uniform of the program in use; ignores names that the shader does not read, because some
  // variants omit them.
  void set(const char* uniform, std::uint32_t value) const;
  void set(const char* uniform, float value) const;
  // Returns whether it is from the cache.
  bool is_from_cache() const { return is_from_cache_; }

 private:
  int location(const char* uniform) const;

  unsigned name_ = 0;
  bool is_from_cache_ = false;
  mutable std::map<std::string, int, std::less<>> locations_;  // asked for so far
};

}  // namespace gpu
