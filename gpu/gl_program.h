#pragma once
// One compute shader.

#include "gpu/program_cache.h"

#include <cstdint>
#include <string>

namespace gpu {

// All calls need the context current in which it was made, the destructor too.
class GlProgram {
 public:
  // Throws GlError with the compiler's messages. what: for messages, "gather".
  GlProgram(const std::string& what, const std::string& source, const ProgramCache& cache = {});
  ~GlProgram();
  GlProgram(const GlProgram&) = delete;
  GlProgram& operator=(const GlProgram&) = delete;

  void use() const;
  // Of the program in use; names that the shader does not read are passed over.
  void set(const char* uniform, std::uint32_t value) const;
  void set(const char* uniform, float value) const;
  // Whether the cache had it.
  bool is_from_cache() const { return is_from_cache_; }

 private:
  bool load(const ProgramBinary& binary);
  void compile(const std::string& what, const std::string& source);
  ProgramBinary binary() const;

  unsigned name_ = 0;
  bool is_from_cache_ = false;
};

}  // namespace gpu
