#include "rendering/frame.hh"

#include <cassert>
#include <stdexcept>
#include <string>

namespace pongsim::rendering {

Frame::Frame(const Gl& gl, Kind kind, std::uint32_t width, std::uint32_t height, int samples)
    : gl_(gl), width_(static_cast<GLsizei>(width)), height_(static_cast<GLsizei>(height)) {
  GLint longest = 0;
  gl.getIntegerv(GL_MAX_RENDERBUFFER_SIZE, &longest);
  if (width_ > longest || height_ > longest) {
    throw std::runtime_error("a picture of " + std::to_string(width) + " x " + std::to_string(height) +
                             " pixels is too large to draw: the longest edge is " + std::to_string(longest));
  }
  gl.genFramebuffers(1, &drawn_);
  gl.bindFramebuffer(GL_FRAMEBUFFER, drawn_);
  if (samples > 1) {
    // linear, so that sRGB is computed for each pixel, not for each sample
    addSamples(samples, GL_RGBA16, GL_COLOR_ATTACHMENT0, samples_[0]);
    addSamples(samples, GL_DEPTH_COMPONENT32F, GL_DEPTH_ATTACHMENT, samples_[1]);
    check();
    gl.genFramebuffers(1, &whole_);
    gl.bindFramebuffer(GL_FRAMEBUFFER, whole_);
  }
  addBuffer(kind == Kind::kColors ? GL_SRGB8_ALPHA8 : GL_R32F, GL_COLOR_ATTACHMENT0);
  if (samples <= 1) addBuffer(GL_DEPTH_COMPONENT32F, GL_DEPTH_ATTACHMENT);
  check();
}

Frame::~Frame() {
  gl_.deleteRenderbuffers(count_, buffers_);
  gl_.deleteFramebuffers(1, &drawn_);
  gl_.deleteFramebuffers(1, &whole_);
  gl_.deleteTextures(2, samples_);
}

void Frame::addBuffer(GLenum format, GLenum place) {
  assert(count_ < 2);
  GLuint& buffer = buffers_[count_++];
  gl_.genRenderbuffers(1, &buffer);
  gl_.bindRenderbuffer(GL_RENDERBUFFER, buffer);
  gl_.renderbufferStorage(GL_RENDERBUFFER, format, width_, height_);
  gl_.framebufferRenderbuffer(GL_FRAMEBUFFER, place, GL_RENDERBUFFER, buffer);
}

void Frame::addSamples(GLsizei samples, GLenum format, GLenum place, GLuint& texture) {
  gl_.genTextures(1, &texture);
  gl_.activeTexture(GL_TEXTURE0);
  gl_.bindTexture(GL_TEXTURE_2D_MULTISAMPLE, texture);
  gl_.texImage2DMultisample(GL_TEXTURE_2D_MULTISAMPLE, samples, format, width_, height_, GL_TRUE);
  gl_.framebufferTexture2D(GL_FRAMEBUFFER, place, GL_TEXTURE_2D_MULTISAMPLE, texture, 0);
}

void Frame::check() const {
  if (gl_.checkFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
    // the next picture is not to blame for it
    const bool lacksMemory = gl_.getError() == GL_OUT_OF_MEMORY;
    throw std::runtime_error("this OpenGL " + std::string(lacksMemory ? "has no memory left for" : "can't draw") +
                             " a picture of " + std::to_string(width_) + " x " + std::to_string(height_) + " pixels");
  }
}

void Frame::use() const {
  gl_.bindFramebuffer(GL_FRAMEBUFFER, drawn_);
  gl_.viewport(0, 0, width_, height_);
}

void Frame::read(const Resolve& resolve, std::span<std::uint8_t> pixels) const {
  if (whole_ != 0) {
    gl_.bindFramebuffer(GL_FRAMEBUFFER, whole_);
    gl_.viewport(0, 0, width_, height_);
    resolve.draw(samples_[0]);
  }
  gl_.pixelStorei(GL_PACK_ALIGNMENT, 1);
  gl_.readPixels(0, 0, width_, height_, GL_RGB, GL_UNSIGNED_BYTE, pixels.data());
}

void Frame::read(std::span<float> depths) const {
  gl_.bindFramebuffer(GL_FRAMEBUFFER, drawn_);
  gl_.pixelStorei(GL_PACK_ALIGNMENT, 4);
  gl_.readPixels(0, 0, width_, height_, GL_RED, GL_FLOAT, depths.data());
}

}  // namespace pongsim::rendering
