#pragma once

#include <GL/glcorearb.h>

#include "rendering/context.hh"

namespace pongsim::rendering {

/// The OpenGL functions in use, of one context. Only call them while it is bound.
struct Gl {
  /// @param context Bound.
  /// @throws std::runtime_error if it lacks one of them.
  explicit Gl(const Context& context);

  PFNGLACTIVETEXTUREPROC activeTexture = nullptr;
  PFNGLATTACHSHADERPROC attachShader = nullptr;
  PFNGLBINDBUFFERPROC bindBuffer = nullptr;
  PFNGLBINDBUFFERBASEPROC bindBufferBase = nullptr;
  PFNGLBINDFRAMEBUFFERPROC bindFramebuffer = nullptr;
  PFNGLBINDRENDERBUFFERPROC bindRenderbuffer = nullptr;
  PFNGLBINDTEXTUREPROC bindTexture = nullptr;
  PFNGLBINDVERTEXARRAYPROC bindVertexArray = nullptr;
  PFNGLBLENDFUNCPROC blendFunc = nullptr;
  PFNGLBLITFRAMEBUFFERPROC blitFramebuffer = nullptr;
  PFNGLBUFFERDATAPROC bufferData = nullptr;
  PFNGLCHECKFRAMEBUFFERSTATUSPROC checkFramebufferStatus = nullptr;
  PFNGLCLEARBUFFERFVPROC clearBufferfv = nullptr;
  PFNGLCLIPCONTROLPROC clipControl = nullptr;
  PFNGLCOLORMASKPROC colorMask = nullptr;
  PFNGLCOMPILESHADERPROC compileShader = nullptr;
  PFNGLCREATEPROGRAMPROC createProgram = nullptr;
  PFNGLCREATESHADERPROC createShader = nullptr;
  PFNGLCULLFACEPROC cullFace = nullptr;
  PFNGLDELETEBUFFERSPROC deleteBuffers = nullptr;
  PFNGLDELETEFRAMEBUFFERSPROC deleteFramebuffers = nullptr;
  PFNGLDELETEPROGRAMPROC deleteProgram = nullptr;
  PFNGLDELETERENDERBUFFERSPROC deleteRenderbuffers = nullptr;
  PFNGLDELETESHADERPROC deleteShader = nullptr;
  PFNGLDELETETEXTURESPROC deleteTextures = nullptr;
  PFNGLDELETEVERTEXARRAYSPROC deleteVertexArrays = nullptr;
  PFNGLDEPTHFUNCPROC depthFunc = nullptr;
  PFNGLDEPTHMASKPROC depthMask = nullptr;
  PFNGLDISABLEPROC disable = nullptr;
  PFNGLDRAWARRAYSPROC drawArrays = nullptr;
  PFNGLDRAWBUFFERPROC drawBuffer = nullptr;
  PFNGLDRAWELEMENTSPROC drawElements = nullptr;
  PFNGLENABLEPROC enable = nullptr;
  PFNGLENABLEVERTEXATTRIBARRAYPROC enableVertexAttribArray = nullptr;
  PFNGLFRAMEBUFFERRENDERBUFFERPROC framebufferRenderbuffer = nullptr;
  PFNGLFRAMEBUFFERTEXTURELAYERPROC framebufferTextureLayer = nullptr;
  PFNGLFRONTFACEPROC frontFace = nullptr;
  PFNGLGENBUFFERSPROC genBuffers = nullptr;
  PFNGLGENFRAMEBUFFERSPROC genFramebuffers = nullptr;
  PFNGLGENRENDERBUFFERSPROC genRenderbuffers = nullptr;
  PFNGLGENTEXTURESPROC genTextures = nullptr;
  PFNGLGENVERTEXARRAYSPROC genVertexArrays = nullptr;
  PFNGLGENERATEMIPMAPPROC generateMipmap = nullptr;
  PFNGLGETINTEGERVPROC getIntegerv = nullptr;
  PFNGLGETPROGRAMINFOLOGPROC getProgramInfoLog = nullptr;
  PFNGLGETPROGRAMIVPROC getProgramiv = nullptr;
  PFNGLGETSHADERINFOLOGPROC getShaderInfoLog = nullptr;
  PFNGLGETSHADERIVPROC getShaderiv = nullptr;
  PFNGLLINKPROGRAMPROC linkProgram = nullptr;
  PFNGLPIXELSTOREIPROC pixelStorei = nullptr;
  PFNGLREADBUFFERPROC readBuffer = nullptr;
  PFNGLREADPIXELSPROC readPixels = nullptr;
  PFNGLRENDERBUFFERSTORAGEMULTISAMPLEPROC renderbufferStorageMultisample = nullptr;
  PFNGLSHADERSOURCEPROC shaderSource = nullptr;
  PFNGLTEXIMAGE2DPROC texImage2D = nullptr;
  PFNGLTEXIMAGE3DPROC texImage3D = nullptr;
  PFNGLTEXPARAMETERIPROC texParameteri = nullptr;
  PFNGLUNIFORM1FPROC uniform1f = nullptr;
  PFNGLUNIFORM1IPROC uniform1i = nullptr;
  PFNGLUNIFORM3FVPROC uniform3fv = nullptr;
  PFNGLUNIFORM4FVPROC uniform4fv = nullptr;
  PFNGLUNIFORMMATRIX3FVPROC uniformMatrix3fv = nullptr;
  PFNGLUNIFORMMATRIX4FVPROC uniformMatrix4fv = nullptr;
  PFNGLUSEPROGRAMPROC useProgram = nullptr;
  PFNGLVERTEXATTRIBPOINTERPROC vertexAttribPointer = nullptr;
  PFNGLVIEWPORTPROC viewport = nullptr;
};

}  // namespace pongsim::rendering
