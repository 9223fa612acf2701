#include "gpu/raster/gl_render_program.h"

#include "gpu/opengl/gl_error.h"
#include "gpu/opengl/gl_program.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <array>
#include <utility>
#include <vector>

namespace gpu {
namespace {

// Frees a shader when it goes.
class Shader {
 public:
  Shader(GLenum kind, const std::string& what, const std::string& source)
      : name_(glCreateShader(kind)) {
    const char* text = source.c_str();
    glShaderSource(name_, 1, &text, nullptr);
    glCompileShader(name_);
    GLint is_compiled = GL_FALSE;
    glGetShaderiv(name_, GL_COMPILE_STATUS, &is_compiled);
    if (is_compiled == GL_TRUE) return;
    std::array<char, 2000> log{};
    glGetShaderInfoLog(name_, static_cast<GLsizei>(log.size()), nullptr, log.data());
    glDeleteShader(name_);
    throw GlError(fmt::format("the driver does not compile shader '{}': {}", what, log.data()));
  }
  ~Shader() { glDeleteShader(name_); }
  Shader(const Shader&) = delete;
  Shader& operator=(const Shader&) = delete;
  GLuint name() const { return name_; }

 private:
  GLuint name_;
};

GLuint compiled(const std::string& what, const RenderShaders& source) {
  const Shader vertex(GL_VERTEX_SHADER, what, source.vertex);
  const Shader fragment(GL_FRAGMENT_SHADER, what, source.fragment);
  const GLuint name = glCreateProgram();
  glProgramParameteri(name, GL_PROGRAM_BINARY_RETRIEVABLE_HINT, GL_TRUE);
  glAttachShader(name, vertex.name());
  glAttachShader(name, fragment.name());
  glLinkProgram(name);
  GLint is_linked = GL_FALSE;
  glGetProgramiv(name, GL_LINK_STATUS, &is_linked);
  if (is_linked == GL_TRUE) return name;
  std::array<char, 2000> log{};
  glGetProgramInfoLog(name, static_cast<GLsizei>(log.size()), nullptr, log.data());
  glDeleteProgram(name);
  throw GlError(fmt::format("the driver does not link shader '{}': {}", what, log.data()));
}

}  // namespace

GlRenderProgram::GlRenderProgram(const std::string& what, const RenderShaders& source,
                                 const ProgramCache& cache) {
  const LinkedProgram linked = linked_program(cache, source.vertex + "// and\n" + source.fragment,
                                              [&] { return compiled(what, source); });
  name_ = linked.name;
  is_from_cache_ = linked.is_from_cache;
}

GlRenderProgram::~GlRenderProgram() { glDeleteProgram(name_); }

void GlRenderProgram::use() const { glUseProgram(name_); }

void GlRenderProgram::set(const char* uniform, std::uint32_t value) const {
  glUniform1ui(glGetUniformLocation(name_, uniform), value);
}

void GlRenderProgram::set(const char* uniform, float value) const {
  glUniform1f(glGetUniformLocation(name_, uniform), value);
}

void GlRenderProgram::set(const char* uniform, const glm::mat4& value) const {
  glUniformMatrix4fv(glGetUniformLocation(name_, uniform), 1, GL_FALSE, &value[0][0]);
}

}  // namespace gpu
