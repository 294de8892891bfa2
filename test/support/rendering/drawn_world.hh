#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

#include "rendering/renderer.hh"
#include "rendering/renderer_choice.hh"
#include "rendering/scene.hh"
#include "support/visual_world.hh"

namespace pongsim::rendering::test {

/// Visuals and what draws them.
class DrawnWorld : public pongsim::test::VisualWorld {
 public:
  DrawnWorld() { description().scene.background = {0, 0, 0, 1}; }

  /// Adds a visual that shows a colour, whatever light there is.
  description::Visual& addShining(const description::Geometry& geometry, const Vector3& position,
                                  const description::Color& emitted) {
    description::Visual& visual = add(geometry, {position, Quaternion::Identity()});
    visual.material.emplace();
    visual.material->emissive = emitted;
    visual.material->isLit = false;
    return visual;
  }

  /// To be called once all is in it.
  void start() {
    populate();
    scene_.build(entities(), state(), diagnostics());
    drawWith(openContexts());
  }

  /// From now on, beginning with nothing.
  void drawWith(Contexts contexts) { renderer_ = std::make_unique<Renderer>(std::move(contexts)); }

  std::vector<std::uint8_t> colors(const PictureView& view) {
    std::vector<std::uint8_t> pixels(std::size_t{3} * view.width * view.height);
    renderer_->drawColors(scene_, view, pixels);
    return pixels;
  }
  /// Draws as the first picture, for which nothing was kept.
  std::vector<std::uint8_t> colorsAnew(const PictureView& view) {
    drawWith(openContexts());
    return colors(view);
  }
  std::vector<float> depths(const PictureView& view) {
    std::vector<float> depths(std::size_t{view.width} * view.height);
    renderer_->drawDepths(scene_, view, depths);
    return depths;
  }

  std::vector<std::uint32_t> numbers(const PictureView& view) {
    std::vector<std::uint32_t> numbers(std::size_t{view.width} * view.height);
    renderer_->drawNumbers(scene_, view, numbers);
    return numbers;
  }
  std::vector<float> temperatures(const PictureView& view, const AirTemperatures& air) {
    std::vector<float> temperatures(std::size_t{view.width} * view.height);
    renderer_->drawTemperatures(scene_, view, air, temperatures);
    return temperatures;
  }

  void letPass(Time time) {
    state().time += time;
    scene_.update(entities(), state());
  }

  void move(std::size_t model, const Vector3& position) {
    state().links[model].X_WorldLink.position = position;
    scene_.update(entities(), state());
  }

  /// Adds an emitter to the link of the last visual. To be called before `start`.
  description::ParticleEmitter& addEmitter() { return description().models.back().links[0].emitters.emplace_back(); }
  /// Shows a particle of the first emitter, at a share of its life of two seconds.
  void show(const Vector3& place, double share) {
    particles_.follow(entities(), 0);
    const Time life = std::chrono::seconds(2), born = state().time - fromSeconds(2 * share);
    particles_.emitters().at(0).particles.push_back({place, Vector3::Zero(), born, born + life});
    scene_.place(particles_, entities(), state().time);
  }

  void paint(const std::map<VisualId, VisualColors>& colors) { scene_.paint(colors); }

  void show(const MarkerList& markers) { scene_.show(markers, entities(), state()); }
  std::optional<Pose> parentPose(const std::string& parent) { return markerParentPose(parent, entities(), state()); }

  const Scene& scene() const { return scene_; }

 private:
  Scene scene_;
  world::Particles particles_;
  std::unique_ptr<Renderer> renderer_;
};

/// A pinhole at the origin that looks along x.
inline PictureView view(std::uint32_t width, std::uint32_t height, double focal) {
  PictureView result;
  result.width = width;
  result.height = height;
  result.fx = result.fy = focal;
  result.cx = width / 2.0;
  result.cy = height / 2.0;
  return result;
}

/// Skips where there is nothing to draw with: worlds run without cameras there.
class Pictures : public ::testing::Test {
 protected:
  void SetUp() override {
    try {
      openContexts();
    } catch (const std::runtime_error& error) {
      GTEST_SKIP() << error.what();
    }
  }
};

}  // namespace pongsim::rendering::test
