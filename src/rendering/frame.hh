#pragma once

#include <cstdint>
#include <span>

#include "rendering/gl.hh"
#include "rendering/resolve.hh"

namespace pongsim::rendering {

/// A framebuffer: multisampled colours, or one number for each pixel. Must not outlive its context.
class Frame {
 public:
  enum class Kind { kColors, kDepths };

  /// @param samples Colour samples for each pixel: four or one.
  /// @throws std::runtime_error if this size is not possible.
  Frame(const Gl& gl, Kind kind, std::uint32_t width, std::uint32_t height, int samples);
  ~Frame();
  Frame(const Frame&) = delete;
  Frame& operator=(const Frame&) = delete;

  /// Makes it the target of all drawing that follows.
  void use() const;

  /// @param resolve Combines the samples of each pixel.
  /// @param pixels Three bytes each.
  void read(const Resolve& resolve, std::span<std::uint8_t> pixels) const;
  void read(std::span<float> depths) const;

 private:
  void addBuffer(GLenum format, GLenum place);
  void addSamples(GLsizei samples, GLenum format, GLenum place, GLuint& texture);
  void check() const;

  const Gl& gl_;
  GLsizei width_;
  GLsizei height_;
  /// The buffer drawn into, and the one in which the samples of each pixel are combined.
  GLuint drawn_ = 0;
  GLuint whole_ = 0;
  /// Colours and depths of the samples.
  GLuint samples_[2] = {};
  GLuint buffers_[2] = {};
  int count_ = 0;
};

}  // namespace pongsim::rendering
