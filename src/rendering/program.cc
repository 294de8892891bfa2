#include "rendering/program.hh"

#include <array>
#include <stdexcept>
#include <string>
#include <utility>

namespace pongsim::rendering {

namespace {

GLuint compile(const Gl& gl, GLenum type, const char* source) {
  const GLuint shader = gl.createShader(type);
  gl.shaderSource(shader, 1, &source, nullptr);
  gl.compileShader(shader);
  GLint isCompiled = 0;
  gl.getShaderiv(shader, GL_COMPILE_STATUS, &isCompiled);
  if (isCompiled == GL_TRUE) return shader;
  std::array<char, 1000> said{};
  gl.getShaderInfoLog(shader, said.size(), nullptr, said.data());
  gl.deleteShader(shader);
  throw std::runtime_error(std::string("the shader can't be compiled: ") + said.data());
}

}  // namespace

Program::Program(const Gl& gl, const char* vertexSource, const char* fragmentSource)
    : gl_(gl), id_(gl.createProgram()) {
  for (const auto& [type, source] :
       {std::pair(GLenum{GL_VERTEX_SHADER}, vertexSource), std::pair(GLenum{GL_FRAGMENT_SHADER}, fragmentSource)}) {
    const GLuint shader = compile(gl, type, source);
    gl.attachShader(id_, shader);
    // deleted together with the program
    gl.deleteShader(shader);
  }
  gl.linkProgram(id_);
  GLint isLinked = 0;
  gl.getProgramiv(id_, GL_LINK_STATUS, &isLinked);
  if (isLinked == GL_TRUE) return;
  std::array<char, 1000> said{};
  gl.getProgramInfoLog(id_, said.size(), nullptr, said.data());
  throw std::runtime_error(std::string("the shaders can't be linked: ") + said.data());
}

Program::~Program() { gl_.deleteProgram(id_); }

}  // namespace pongsim::rendering
