#pragma once

#include "rendering/gl.hh"

namespace pongsim::rendering {

/// A linked shader program. Must not outlive its context, and can be used while that is bound.
class Program {
 public:
  /// @throws std::runtime_error if they can't be compiled.
  Program(const Gl& gl, const char* vertexSource, const char* fragmentSource);
  ~Program();
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  void use() const { gl_.useProgram(id_); }

 private:
  const Gl& gl_;
  GLuint id_;
};

}  // namespace pongsim::rendering
