#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "pongsim/appearance.hh"
#include "pongsim/diagnostic.hh"
#include "pongsim/export.hh"
#include "pongsim/handles.hh"
#include "pongsim/sensing/marker_services.hh"
#include "pongsim/sensing/seen_visual.hh"
#include "pongsim/types.hh"

namespace pongsim {

/// Projection and drawing options of a pinhole camera.
///
/// A point (x, y, z) in the camera frame, with x ahead, y to the left and z up, is at u = cx - (fx y + skew z) / x, v =
/// cy - fy z / x, in pixels from the left and top edges of the image; the centre of the first pixel is at (0.5, 0.5).
struct PictureView {
  Pose X_WorldEye;
  /// [pixels]
  std::uint32_t width = 320;
  std::uint32_t height = 240;
  double fx = 277;
  double fy = 277;
  double cx = 160;
  double cy = 120;
  double skew = 0;
  /// Clip distances along x [m]; `far` may be infinite.
  double near = 0.1;
  double far = 100;
  /// A visual is drawn if it shares a bit with its `<visibility_flags>`.
  std::uint32_t visibilityMask = 0xFFFFFFFF;
  /// Samples per pixel for anti-aliasing: four, or one if fewer are requested.
  std::uint32_t antiAliasing = 4;
  /// Helpers to draw: a grid on the ground with lines 1 m apart, the world's axes.
  bool showsGrid = false;
  bool showsAxes = false;
};

/// The visuals and lights of a world, for cameras, drawn by OpenGL without a display: on the processor, or by a
/// graphics card if the environment variable PONGSIM_RENDERER says so ("auto", "egl").
///
/// The same world and view give the same bits on the same machine, on the processor with any number of threads. Use it
/// on one thread at a time. `rebuild`, `update` and `scatterDepths` read the world, and are for its thread; another
/// thread may draw while the world goes on.
class PONGSIM_API CameraScene {
 public:
  /// A scene without visuals; call `rebuild`.
  /// @throws std::runtime_error if what it draws with is not installed; the message names the package.
  explicit CameraScene(const World& world);
  ~CameraScene();

  /// Colours that replace those of the world's `<scene>`: red, green, blue, 0 to 1. Call it before `rebuild`.
  void setColors(const std::optional<Vector3>& background, const std::optional<Vector3>& ambient);

  /// Adds a light to those of the world, for good.
  void addLight(const VisibleLight& light);

  /// Sets whose markers are in pictures; at first those for sensors. Call it before `update`.
  void setMarkerViewers(MarkerViewers viewers);

  /// Adds visuals and lights, and reads mesh and texture files. Call it first, and after models were added or removed
  /// (`System::worldChanged`).
  /// @param diagnostics Warnings about files that can't be read.
  void rebuild(Diagnostics& diagnostics);

  /// Moves everything to its current pose. Call it before drawing, once per step.
  void update();

  /// @param pixels Red, green, blue, 0 to 255 (sRGB), row by row from the top; 3 width height values.
  /// @throws std::runtime_error if the image can't be drawn; likewise below.
  void drawColors(const PictureView& view, std::span<std::uint8_t> pixels);

  /// @param depths Distance along x at the centre of each pixel [m]; infinite where nothing is visible. Row by row from
  /// the top; width height values.
  void drawDepths(const PictureView& view, std::span<float> depths);

  /// Lets particles of the world's emitters scatter the light of a depth camera, as in Fortress (docs/sensors.md).
  /// @param camera A name: which pixels are hit depends on it, the run's seed and the time.
  /// @param depths As from `drawDepths`.
  void scatterDepths(const PictureView& view, std::string_view camera, std::span<float> depths);

  /// @return All visuals, at the last `rebuild` or `update`.
  const std::vector<SeenVisual>& visuals() const;

  /// @param numbers The foremost visual at the centre of each pixel: 1 + its index in `visuals`; 0 where nothing is
  /// visible. Lights and transparency have no effect. Row by row from the top; width height values.
  void drawNumbers(const PictureView& view, std::span<std::uint32_t> numbers);

  /// @param temperatures At the centre of each pixel [K]: those that the system `thermal` gives to visuals, else that
  /// of the air, warmer where a visual is brighter. Transparency has no effect. Row by row from the top; width height
  /// values.
  void drawTemperatures(const PictureView& view, std::span<float> temperatures);

  /// @param visual Index in `visuals`.
  /// @return A box around the projection of all of it that is farther than the near clip distance, hidden or not
  /// [pixels]; empty if there is nothing. It may extend beyond the image.
  Eigen::AlignedBox2d imageBounds(std::size_t visual, const PictureView& view) const;

  /// @param visuals Indices in `visuals`; at least one.
  /// @return A box around them in the world frame: of one visual along its own axes, of several along the principal
  /// axes of their vertices.
  TurnedBox turnedBox(std::span<const std::size_t> visuals) const;

  /// Writes a PNG file, replacing an existing one.
  /// @param pixels As from `drawColors`.
  /// @throws std::runtime_error if it can't be written.
  static void writePicture(const std::filesystem::path& file, std::uint32_t width, std::uint32_t height,
                           std::span<const std::uint8_t> pixels);

  /// @return A box around the visuals of a model and its nested models, or of all models, at their poses of the last
  /// `update`; planes and heightmaps count only if there is nothing else. Empty if nothing is visible.
  Eigen::AlignedBox3d bounds(const std::optional<Model>& model = std::nullopt) const;

  /// @return The names of the world's actors.
  std::vector<std::string> actors() const;
  /// @return A box around an actor at its pose of the last `update`; empty if nothing with that name is visible.
  Eigen::AlignedBox3d actorBounds(const std::string& name) const;

 private:
  struct Content;
  std::unique_ptr<Content> content_;
};

}  // namespace pongsim
