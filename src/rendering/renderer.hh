#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "pongsim/sensing/camera_scene.hh"
#include "rendering/context.hh"
#include "rendering/scene.hh"

namespace pongsim::rendering {

/// Draws scenes with OpenGL. See `CameraScene`.
class Renderer {
 public:
  explicit Renderer(std::unique_ptr<Context> context);
  ~Renderer();

  void drawColors(const Scene& scene, const PictureView& view, std::span<std::uint8_t> pixels);
  void drawDepths(const Scene& scene, const PictureView& view, std::span<float> depths);

 private:
  class Content;
  Content& content();

  std::unique_ptr<Context> context_;
  /// Created with the first image.
  std::unique_ptr<Content> content_;
};

}  // namespace pongsim::rendering
