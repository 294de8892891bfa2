#pragma once

#include <span>
#include <utility>
#include <vector>

#include "pongsim/sensing/camera_scene.hh"
#include "rendering/gl.hh"
#include "rendering/program.hh"
#include "rendering/scene.hh"
#include "rendering/store.hh"

namespace pongsim::rendering {

/// Draws particles in their own colours, without lights, blended from the farthest to the nearest. Must not outlive its
/// context.
class Billboards {
 public:
  explicit Billboards(const Gl& gl);
  ~Billboards();
  Billboards(const Billboards&) = delete;
  Billboards& operator=(const Billboards&) = delete;

  void draw(std::span<const Billboard> billboards, const PictureView& view, const Eigen::Matrix4d& clipFromPlace,
            Store& store);

 private:
  struct Corner {
    Eigen::Vector3f place;
    Eigen::Vector2f texel;
    Eigen::Vector4f color;
  };
  /// @param eye The axes of the camera in the world frame.
  void add(const Billboard& billboard, const Vector3& toCentre, const Matrix3& eye);

  const Gl& gl_;
  Program program_;
  GLuint vertexArray_ = 0;
  GLuint buffer_ = 0;
  /// Distances along the camera's axis; kept for their memory, like the corners.
  std::vector<std::pair<double, const Billboard*>> order_;
  std::vector<Corner> corners_;
};

}  // namespace pongsim::rendering
