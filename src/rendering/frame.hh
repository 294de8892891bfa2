#pragma once

#include <cstdint>
#include <span>

#include "rendering/gl.hh"

namespace pongsim::rendering {

/// What pictures are drawn into: colours with several samples a pixel, or one number. It lives while its context does.
class Frame {
 public:
  enum class Kind { kColors, kDepths };

  /// @param samples A pixel, of colours.
  /// @throws std::runtime_error where there can be none of that size.
  Frame(const Gl& gl, Kind kind, std::uint32_t width, std::uint32_t height, int samples);
  ~Frame();
  Frame(const Frame&) = delete;
  Frame& operator=(const Frame&) = delete;

  /// Lets all that follows be drawn into it.
  void use() const;

  /// @param pixels Three bytes each.
  void read(std::span<std::uint8_t> pixels) const;
  void read(std::span<float> depths) const;

 private:
  GLuint addBuffer(GLenum format, GLenum place, int samples);
  void check() const;

  const Gl& gl_;
  GLsizei width_;
  GLsizei height_;
  /// Where it is drawn, and where the samples of a pixel become one.
  GLuint drawn_ = 0;
  GLuint whole_ = 0;
  GLuint buffers_[3] = {};
  int count_ = 0;
};

}  // namespace pongsim::rendering
