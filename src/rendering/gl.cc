#include "rendering/gl.hh"

#include <stdexcept>
#include <string>

namespace pongsim::rendering {

Gl::Function Gl::find(const char* name) const {
  const Function function{context_.function(name)};
  if (function.address == nullptr) throw std::runtime_error(std::string("this OpenGL has no ") + name);
  return function;
}

}  // namespace pongsim::rendering
