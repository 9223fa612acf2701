#include "gpu/opengl/gl_program.h"

#include "gpu/opengl/gl_error.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <vector>

namespace gpu {
namespace {

template <class GetLength, class GetLog>
std::string log_of(GLuint name, const GetLength& get_length, const GetLog& get_log) {
  GLint length = 0;
  get_length(name, GL_INFO_LOG_LENGTH, &length);
  if (length <= 0) return "no message";
  std::vector<char> text(static_cast<std::size_t>(length));
  get_log(name, length, &length, text.data());
  return std::string(text.data(), static_cast<std::size_t>(length));
}

// 0 if the driver does not take it: it may have been updated.
GLuint loaded(const ProgramBinary& binary) {
  const GLuint name = glCreateProgram();
  glProgramBinary(name, binary.format, binary.bytes.data(),
                  static_cast<GLsizei>(binary.bytes.size()));
  GLint is_linked = GL_FALSE;
  glGetProgramiv(name, GL_LINK_STATUS, &is_linked);
  if (is_linked == GL_TRUE) return name;
  glDeleteProgram(name);
  forget_gl_errors();  // of a format that the driver does not know
  return 0;
}

// Empty if the driver gives none.
ProgramBinary binary_of(GLuint name) {
  GLint length = 0;
  glGetProgramiv(name, GL_PROGRAM_BINARY_LENGTH, &length);
  if (length <= 0) return {};
  ProgramBinary result;
  result.bytes.resize(static_cast<std::size_t>(length));
  GLenum format = 0;
  GLsizei written = 0;
  glGetProgramBinary(name, length, &written, &format, result.bytes.data());
  if (glGetError() != GL_NO_ERROR) return {};
  result.format = format;
  result.bytes.resize(static_cast<std::size_t>(written));
  return result;
}

GLuint compiled(const std::string& what, const std::string& source) {
  const GLuint shader = glCreateShader(GL_COMPUTE_SHADER);
  const char* text = source.c_str();
  glShaderSource(shader, 1, &text, nullptr);
  glCompileShader(shader);
  GLint is_compiled = GL_FALSE;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &is_compiled);
  if (is_compiled != GL_TRUE) {
    const std::string log = log_of(shader, glGetShaderiv, glGetShaderInfoLog);
    glDeleteShader(shader);
    throw GlError(fmt::format("the driver does not compile shader '{}': {}", what, log));
  }
  const GLuint name = glCreateProgram();
  glProgramParameteri(name, GL_PROGRAM_BINARY_RETRIEVABLE_HINT, GL_TRUE);
  glAttachShader(name, shader);
  glLinkProgram(name);
  glDeleteShader(shader);
  GLint is_linked = GL_FALSE;
  glGetProgramiv(name, GL_LINK_STATUS, &is_linked);
  if (is_linked == GL_TRUE) return name;
  const std::string log = log_of(name, glGetProgramiv, glGetProgramInfoLog);
  glDeleteProgram(name);
  throw GlError(fmt::format("the driver does not link shader '{}': {}", what, log));
}

}  // namespace

LinkedProgram linked_program(const ProgramCache& cache, const std::string& key,
                             const std::function<unsigned()>& compile) {
  GLint formats = 0;
  if (cache.is_on()) glGetIntegerv(GL_NUM_PROGRAM_BINARY_FORMATS, &formats);
  if (formats > 0) {
    const auto binary = cache.find(key);
    const GLuint name = binary ? loaded(*binary) : 0;
    if (name != 0) return {name, true};
  }
  const GLuint name = compile();
  if (formats > 0) cache.keep(key, binary_of(name));
  return {name, false};
}

GlProgram::GlProgram(const std::string& what, const std::string& source,
                     const ProgramCache& cache) {
  const LinkedProgram linked =
      linked_program(cache, source, [&] { return compiled(what, source); });
  name_ = linked.name;
  is_from_cache_ = linked.is_from_cache;
}

GlProgram::~GlProgram() { glDeleteProgram(name_); }

void GlProgram::use() const { glUseProgram(name_); }

// Drivers search all names for it, which takes longer than to dispatch.
int GlProgram::location(const char* uniform) const {
  const auto found = locations_.find(uniform);
  if (found != locations_.end()) return found->second;
  return locations_.emplace(uniform, glGetUniformLocation(name_, uniform)).first->second;
}

void GlProgram::set(const char* uniform, std::uint32_t value) const {
  glUniform1ui(location(uniform), value);
}

void GlProgram::set(const char* uniform, float value) const {
  glUniform1f(location(uniform), value);
}

}  // namespace gpu
