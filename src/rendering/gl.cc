#include "rendering/gl.hh"

#include <stdexcept>
#include <string>

namespace pongsim::rendering {

namespace {

template <class Pointer>
void find(const Context& context, const char* name, Pointer& function) {
  function = reinterpret_cast<Pointer>(context.function(name));
  if (function == nullptr) throw std::runtime_error(std::string("this OpenGL has no ") + name);
}

}  // namespace

Gl::Gl(const Context& context) {
  find(context, "glActiveTexture", activeTexture);
  find(context, "glAttachShader", attachShader);
  find(context, "glBindBuffer", bindBuffer);
  find(context, "glBindBufferBase", bindBufferBase);
  find(context, "glBindFramebuffer", bindFramebuffer);
  find(context, "glBindRenderbuffer", bindRenderbuffer);
  find(context, "glBindTexture", bindTexture);
  find(context, "glBindVertexArray", bindVertexArray);
  find(context, "glBlendFunc", blendFunc);
  find(context, "glBlitFramebuffer", blitFramebuffer);
  find(context, "glBufferData", bufferData);
  find(context, "glCheckFramebufferStatus", checkFramebufferStatus);
  find(context, "glClearBufferfv", clearBufferfv);
  find(context, "glClipControl", clipControl);
  find(context, "glColorMask", colorMask);
  find(context, "glCompileShader", compileShader);
  find(context, "glCreateProgram", createProgram);
  find(context, "glCreateShader", createShader);
  find(context, "glCullFace", cullFace);
  find(context, "glDeleteBuffers", deleteBuffers);
  find(context, "glDeleteFramebuffers", deleteFramebuffers);
  find(context, "glDeleteProgram", deleteProgram);
  find(context, "glDeleteRenderbuffers", deleteRenderbuffers);
  find(context, "glDeleteShader", deleteShader);
  find(context, "glDeleteTextures", deleteTextures);
  find(context, "glDeleteVertexArrays", deleteVertexArrays);
  find(context, "glDepthFunc", depthFunc);
  find(context, "glDepthMask", depthMask);
  find(context, "glDisable", disable);
  find(context, "glDrawArrays", drawArrays);
  find(context, "glDrawBuffer", drawBuffer);
  find(context, "glDrawElements", drawElements);
  find(context, "glEnable", enable);
  find(context, "glEnableVertexAttribArray", enableVertexAttribArray);
  find(context, "glFramebufferRenderbuffer", framebufferRenderbuffer);
  find(context, "glFramebufferTextureLayer", framebufferTextureLayer);
  find(context, "glFrontFace", frontFace);
  find(context, "glGenBuffers", genBuffers);
  find(context, "glGenFramebuffers", genFramebuffers);
  find(context, "glGenRenderbuffers", genRenderbuffers);
  find(context, "glGenTextures", genTextures);
  find(context, "glGenVertexArrays", genVertexArrays);
  find(context, "glGenerateMipmap", generateMipmap);
  find(context, "glGetIntegerv", getIntegerv);
  find(context, "glGetProgramInfoLog", getProgramInfoLog);
  find(context, "glGetProgramiv", getProgramiv);
  find(context, "glGetShaderInfoLog", getShaderInfoLog);
  find(context, "glGetShaderiv", getShaderiv);
  find(context, "glLinkProgram", linkProgram);
  find(context, "glPixelStorei", pixelStorei);
  find(context, "glReadBuffer", readBuffer);
  find(context, "glReadPixels", readPixels);
  find(context, "glRenderbufferStorageMultisample", renderbufferStorageMultisample);
  find(context, "glShaderSource", shaderSource);
  find(context, "glTexImage2D", texImage2D);
  find(context, "glTexImage3D", texImage3D);
  find(context, "glTexParameteri", texParameteri);
  find(context, "glUniform1f", uniform1f);
  find(context, "glUniform1i", uniform1i);
  find(context, "glUniform3fv", uniform3fv);
  find(context, "glUniform4fv", uniform4fv);
  find(context, "glUniformMatrix3fv", uniformMatrix3fv);
  find(context, "glUniformMatrix4fv", uniformMatrix4fv);
  find(context, "glUseProgram", useProgram);
  find(context, "glVertexAttribPointer", vertexAttribPointer);
  find(context, "glViewport", viewport);
}

}  // namespace pongsim::rendering
