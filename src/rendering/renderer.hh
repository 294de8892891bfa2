#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "pongsim/sensing/camera_scene.hh"
#include "rendering/context.hh"
#include "rendering/scene.hh"
#include "rendering/values.hh"

namespace pongsim::rendering {

/// Draws scenes with OpenGL. See `CameraScene`. Logs what draws, and why the spare context has to.
class Renderer {
 public:
  explicit Renderer(Contexts contexts);
  ~Renderer();

  void drawColors(const Scene& scene, const PictureView& view, std::span<std::uint8_t> pixels);
  void drawDepths(const Scene& scene, const PictureView& view, std::span<float> depths);
  void drawNumbers(const Scene& scene, const PictureView& view, std::span<std::uint32_t> numbers);
  void drawTemperatures(const Scene& scene, const PictureView& view, const AirTemperatures& air,
                        std::span<float> temperatures);

 private:
  class Content;
  template <class Draw>
  void draw(const Draw& draw);
  template <class Draw>
  void drawNow(const Draw& draw);
  void clear();

  Contexts contexts_;
  /// Created with the first image.
  std::unique_ptr<Content> content_;
};

}  // namespace pongsim::rendering
