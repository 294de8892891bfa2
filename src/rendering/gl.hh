#pragma once

#include <GL/glcorearb.h>

#include "rendering/context.hh"

namespace pongsim::rendering {

/// The OpenGL functions in use, of one context. Only call them while it is bound.
class Gl {
  /// Converts to a pointer to a function of any type.
  struct Function {
    Context::Function address;
    template <class Pointer>
    operator Pointer() const {
      return reinterpret_cast<Pointer>(address);
    }
  };
  Function find(const char* name) const;
  const Context& context_;

 public:
  /// @param context Bound; must outlive this.
  /// @throws std::runtime_error if it lacks one of them.
  explicit Gl(const Context& context) : context_(context) {}

  /// @throws std::runtime_error if it has refused something since the last call, such as memory.
  void check() const;

  PFNGLACTIVETEXTUREPROC activeTexture = find("glActiveTexture");
  PFNGLATTACHSHADERPROC attachShader = find("glAttachShader");
  PFNGLBINDBUFFERPROC bindBuffer = find("glBindBuffer");
  PFNGLBINDBUFFERBASEPROC bindBufferBase = find("glBindBufferBase");
  PFNGLBINDFRAMEBUFFERPROC bindFramebuffer = find("glBindFramebuffer");
  PFNGLBINDRENDERBUFFERPROC bindRenderbuffer = find("glBindRenderbuffer");
  PFNGLBINDTEXTUREPROC bindTexture = find("glBindTexture");
  PFNGLBINDVERTEXARRAYPROC bindVertexArray = find("glBindVertexArray");
  PFNGLBLENDFUNCPROC blendFunc = find("glBlendFunc");
  PFNGLBUFFERDATAPROC bufferData = find("glBufferData");
  PFNGLCHECKFRAMEBUFFERSTATUSPROC checkFramebufferStatus = find("glCheckFramebufferStatus");
  PFNGLCLEARBUFFERFVPROC clearBufferfv = find("glClearBufferfv");
  PFNGLCLIPCONTROLPROC clipControl = find("glClipControl");
  PFNGLCOLORMASKPROC colorMask = find("glColorMask");
  PFNGLCOMPILESHADERPROC compileShader = find("glCompileShader");
  PFNGLCREATEPROGRAMPROC createProgram = find("glCreateProgram");
  PFNGLCREATESHADERPROC createShader = find("glCreateShader");
  PFNGLCULLFACEPROC cullFace = find("glCullFace");
  PFNGLDELETEBUFFERSPROC deleteBuffers = find("glDeleteBuffers");
  PFNGLDELETEFRAMEBUFFERSPROC deleteFramebuffers = find("glDeleteFramebuffers");
  PFNGLDELETEPROGRAMPROC deleteProgram = find("glDeleteProgram");
  PFNGLDELETERENDERBUFFERSPROC deleteRenderbuffers = find("glDeleteRenderbuffers");
  PFNGLDELETESHADERPROC deleteShader = find("glDeleteShader");
  PFNGLDELETETEXTURESPROC deleteTextures = find("glDeleteTextures");
  PFNGLDELETEVERTEXARRAYSPROC deleteVertexArrays = find("glDeleteVertexArrays");
  PFNGLDEPTHFUNCPROC depthFunc = find("glDepthFunc");
  PFNGLDEPTHMASKPROC depthMask = find("glDepthMask");
  PFNGLDISABLEPROC disable = find("glDisable");
  PFNGLDRAWARRAYSPROC drawArrays = find("glDrawArrays");
  PFNGLDRAWBUFFERPROC drawBuffer = find("glDrawBuffer");
  PFNGLDRAWELEMENTSPROC drawElements = find("glDrawElements");
  PFNGLENABLEPROC enable = find("glEnable");
  PFNGLENABLEVERTEXATTRIBARRAYPROC enableVertexAttribArray = find("glEnableVertexAttribArray");
  PFNGLFRAMEBUFFERRENDERBUFFERPROC framebufferRenderbuffer = find("glFramebufferRenderbuffer");
  PFNGLFRAMEBUFFERTEXTURE2DPROC framebufferTexture2D = find("glFramebufferTexture2D");
  PFNGLFRAMEBUFFERTEXTURELAYERPROC framebufferTextureLayer = find("glFramebufferTextureLayer");
  PFNGLFRONTFACEPROC frontFace = find("glFrontFace");
  PFNGLGENBUFFERSPROC genBuffers = find("glGenBuffers");
  PFNGLGENFRAMEBUFFERSPROC genFramebuffers = find("glGenFramebuffers");
  PFNGLGENRENDERBUFFERSPROC genRenderbuffers = find("glGenRenderbuffers");
  PFNGLGENTEXTURESPROC genTextures = find("glGenTextures");
  PFNGLGENVERTEXARRAYSPROC genVertexArrays = find("glGenVertexArrays");
  PFNGLGENERATEMIPMAPPROC generateMipmap = find("glGenerateMipmap");
  PFNGLGETERRORPROC getError = find("glGetError");
  PFNGLGETINTEGERVPROC getIntegerv = find("glGetIntegerv");
  PFNGLGETPROGRAMINFOLOGPROC getProgramInfoLog = find("glGetProgramInfoLog");
  PFNGLGETPROGRAMIVPROC getProgramiv = find("glGetProgramiv");
  PFNGLGETSHADERINFOLOGPROC getShaderInfoLog = find("glGetShaderInfoLog");
  PFNGLGETSHADERIVPROC getShaderiv = find("glGetShaderiv");
  PFNGLGETSTRINGPROC getString = find("glGetString");
  PFNGLLINKPROGRAMPROC linkProgram = find("glLinkProgram");
  PFNGLPIXELSTOREIPROC pixelStorei = find("glPixelStorei");
  PFNGLREADBUFFERPROC readBuffer = find("glReadBuffer");
  PFNGLREADPIXELSPROC readPixels = find("glReadPixels");
  PFNGLRENDERBUFFERSTORAGEPROC renderbufferStorage = find("glRenderbufferStorage");
  PFNGLSCISSORPROC scissor = find("glScissor");
  PFNGLSHADERSOURCEPROC shaderSource = find("glShaderSource");
  PFNGLTEXIMAGE2DPROC texImage2D = find("glTexImage2D");
  PFNGLTEXIMAGE2DMULTISAMPLEPROC texImage2DMultisample = find("glTexImage2DMultisample");
  PFNGLTEXIMAGE3DPROC texImage3D = find("glTexImage3D");
  PFNGLTEXPARAMETERIPROC texParameteri = find("glTexParameteri");
  PFNGLUNIFORM1FPROC uniform1f = find("glUniform1f");
  PFNGLUNIFORM1IPROC uniform1i = find("glUniform1i");
  PFNGLUNIFORM2FVPROC uniform2fv = find("glUniform2fv");
  PFNGLUNIFORM3FVPROC uniform3fv = find("glUniform3fv");
  PFNGLUNIFORM4FVPROC uniform4fv = find("glUniform4fv");
  PFNGLUNIFORMMATRIX3FVPROC uniformMatrix3fv = find("glUniformMatrix3fv");
  PFNGLUNIFORMMATRIX4FVPROC uniformMatrix4fv = find("glUniformMatrix4fv");
  PFNGLUSEPROGRAMPROC useProgram = find("glUseProgram");
  PFNGLVERTEXATTRIBPOINTERPROC vertexAttribPointer = find("glVertexAttribPointer");
  PFNGLVIEWPORTPROC viewport = find("glViewport");
};

}  // namespace pongsim::rendering
