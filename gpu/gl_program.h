#pragma once
// One compute shader.

#include <cstdint>
#include <string>

namespace gpu {

// All calls need the context current in which it was made, the destructor too.
class GlProgram {
 public:
  // Throws GlError with the compiler's messages. what: for messages, "gather".
  GlProgram(const std::string& what, const std::string& source);
  ~GlProgram();
  GlProgram(const GlProgram&) = delete;
  GlProgram& operator=(const GlProgram&) = delete;

  void use() const;
  // Of the program in use; names that the shader does not read are passed over.
  void set(const char* uniform, std::uint32_t value) const;
  void set(const char* uniform, float value) const;

 private:
  unsigned name_ = 0;
};

}  // namespace gpu
