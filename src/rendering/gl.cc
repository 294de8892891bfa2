#include "rendering/gl.hh"

#include <stdexcept>
#include <string>

namespace pongsim::rendering {

Gl::Function Gl::find(const char* name) const {
  const Function function{context_.function(name)};
  if (function.address == nullptr) throw std::runtime_error(std::string("this OpenGL has no ") + name);
  return function;
}

void Gl::check() const {
  const GLenum error = getError();
  if (error == GL_NO_ERROR) return;
  throw std::runtime_error(error == GL_OUT_OF_MEMORY ? "OpenGL has no memory left"
                                                     : "OpenGL failed with error " + std::to_string(error));
}

}  // namespace pongsim::rendering
