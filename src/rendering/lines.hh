#pragma once

#include <cstddef>
#include <vector>

#include "pongsim/sensing/camera_scene.hh"
#include "pongsim/types.hh"
#include "rendering/gl.hh"
#include "rendering/program.hh"

namespace pongsim::rendering {

/// Aids drawn beside the world: grid and axes. Must not outlive its context.
class Lines {
 public:
  explicit Lines(const Gl& gl);
  ~Lines();
  Lines(const Lines&) = delete;
  Lines& operator=(const Lines&) = delete;

  /// Draws what the view asks for.
  void draw(const PictureView& view, const Eigen::Matrix4d& clipFromPlace);

 private:
  struct End {
    Eigen::Vector3f place;
    Eigen::Vector3f color;
  };
  void add(const Vector3& from, const Vector3& to, const Eigen::Vector3f& color);
  void addGrid();

  const Gl& gl_;
  Program program_;
  GLuint vertexArray_ = 0;
  GLuint buffer_ = 0;
  Vector3 eye_ = Vector3::Zero();
  std::vector<End> ends_;
};

}  // namespace pongsim::rendering
