#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "pongsim/sensing/camera_scene.hh"
#include "pongsim/types.hh"

namespace pongsim::cli {

/// The world that `pongsim view` draws, wherever it comes from.
class Sight {
 public:
  virtual ~Sight() = default;

  /// @return What can be looked at: models, "outer::inner", then actors.
  virtual std::vector<std::string> names() = 0;

  /// See `CameraScene::bounds`.
  /// @param name One of `names`; empty: all of them.
  virtual Eigen::AlignedBox3d bounds(const std::string& name) = 0;

  /// @param name One of `names`.
  /// @return The origin of its frame, in the world; nothing if it is not there any more.
  virtual std::optional<Vector3> position(const std::string& name) = 0;

  /// Goes on: what is drawn afterwards is as it is then. Reports failures.
  /// @param time Since the first picture: simulated for the world of a file, wall time for a running one.
  /// @return The time that it has come to, at least that one; nothing on failure.
  virtual std::optional<Time> advance(Time time) = 0;

  /// See `CameraScene`.
  virtual void drawColors(const PictureView& view, std::span<std::uint8_t> pixels) = 0;
  virtual void drawDepths(const PictureView& view, std::span<float> depths) = 0;
  virtual void drawTemperatures(const PictureView& view, std::span<float> temperatures) = 0;
  virtual void drawNumbers(const PictureView& view, std::span<std::uint32_t> numbers) = 0;
  virtual std::span<const SeenVisual> visuals() = 0;
};

}  // namespace pongsim::cli
