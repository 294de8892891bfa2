#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "pongsim/diagnostic.hh"
#include "pongsim/export.hh"
#include "pongsim/handles.hh"
#include "pongsim/types.hh"

namespace pongsim {

/// What a pinhole camera sees and how it is drawn.
///
/// The point (x, y, z) of the camera's frame, x ahead, y to the left, z up, falls on u = cx - (fx y + skew z) / x,
/// v = cy - fy z / x, in pixels from the left and from the top edge of the picture, so that the middle of the first
/// pixel is at (0.5, 0.5).
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
  /// What is nearer or farther along x is not drawn [m]; `far` may be infinite.
  double near = 0.1;
  double far = 100;
  /// A visual is drawn where one of these bits is in its `<visibility_flags>`.
  std::uint32_t visibilityMask = 0xFFFFFFFF;
  /// Samples a pixel, that edges are smoothed with: four, or one where less are asked for.
  std::uint32_t antiAliasing = 4;
  /// What is drawn beside the world: a grid on the ground with a metre from line to line, the world's axes.
  bool showsGrid = false;
  bool showsAxes = false;
};

/// The visuals and lights of a world, as cameras see them: drawn by OpenGL, without a graphics card or a display.
///
/// The same bits come of the same world and view on the same machine, for any number of threads. It belongs to one
/// thread at a time.
class PONGSIM_API CameraScene {
 public:
  /// Of a world in which it sees nothing yet.
  /// @throws std::runtime_error where OSMesa, which it draws with, is not installed, saying which package to install.
  explicit CameraScene(const World& world);
  ~CameraScene();

  /// Colours in place of those that the world's `<scene>` gives, each of shares of red, green, blue. To be called
  /// before `rebuild`.
  void setColors(const std::optional<Vector3>& background, const std::optional<Vector3>& ambient);

  /// Takes in visuals and lights, and reads the files of meshes and textures. To be called at first, and where models
  /// have come or gone (`System::worldChanged`).
  /// @param diagnostics Warnings about files that can't be read.
  void rebuild(Diagnostics& diagnostics);

  /// Lets everything be where it is now. To be called before pictures are drawn, once a step.
  void update();

  /// @param pixels Red, green, blue, 0 to 255 (sRGB), row by row from the top: three times width times height.
  /// @throws std::runtime_error where the picture can't be drawn; likewise below.
  void drawColors(const PictureView& view, std::span<std::uint8_t> pixels);

  /// @param depths Along x to what is seen in the middle of each pixel [m]; infinite where nothing is. Row by row from
  /// the top: width times height.
  void drawDepths(const PictureView& view, std::span<float> depths);

  /// Writes a PNG file, in place of one that is there.
  /// @param pixels As those of `drawColors`.
  /// @throws std::runtime_error where it can't be written.
  static void writePicture(const std::filesystem::path& file, std::uint32_t width, std::uint32_t height,
                           std::span<const std::uint8_t> pixels);

  /// @return A box around the visuals of a model, of models in it too, or of all models, where they are since `update`;
  /// planes and heightmaps count where there is nothing else. Empty where nothing is to be seen.
  Eigen::AlignedBox3d bounds(const std::optional<Model>& model = std::nullopt) const;

  /// @return The names of the world's actors.
  std::vector<std::string> actors() const;
  /// @return A box around an actor where it is since `update`; empty where nothing is to be seen of that name.
  Eigen::AlignedBox3d actorBounds(const std::string& name) const;

 private:
  struct Content;
  std::unique_ptr<Content> content_;
};

}  // namespace pongsim
