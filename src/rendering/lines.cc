#include "rendering/lines.hh"

#include <cstddef>

#include "rendering/shaders.hh"

namespace pongsim::rendering {

namespace {

/// Size of the grid, and its height above the ground, which must not hide it [m].
constexpr int kHalfGrid = 20;
constexpr double kGridHeight = 0.002;
constexpr double kAxisLength = 1;

}  // namespace

Lines::Lines(const Gl& gl) : gl_(gl), program_(gl, shaders::kLineVertex, shaders::kLineFragment) {
  gl_.genVertexArrays(1, &vertexArray_);
  gl_.bindVertexArray(vertexArray_);
  gl_.genBuffers(1, &buffer_);
  gl_.bindBuffer(GL_ARRAY_BUFFER, buffer_);
  static_assert(sizeof(End) == 6 * sizeof(float));
  gl_.vertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(End), nullptr);
  gl_.vertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, sizeof(End), reinterpret_cast<const void*>(offsetof(End, color)));
  gl_.enableVertexAttribArray(0);
  gl_.enableVertexAttribArray(1);
}

Lines::~Lines() {
  gl_.deleteBuffers(1, &buffer_);
  gl_.deleteVertexArrays(1, &vertexArray_);
}

void Lines::add(const Vector3& from, const Vector3& to, const Eigen::Vector3f& color) {
  for (const Vector3& end : {from, to}) ends_.push_back({Eigen::Vector3f((end - eye_).cast<float>()), color});
}

void Lines::addGrid() {
  const Eigen::Vector3f color = Eigen::Vector3f::Constant(0.12F);
  for (int i = -kHalfGrid; i <= kHalfGrid; ++i) {
    const double at = i;
    add({at, -kHalfGrid, kGridHeight}, {at, kHalfGrid, kGridHeight}, color);
    add({-kHalfGrid, at, kGridHeight}, {kHalfGrid, at, kGridHeight}, color);
  }
}

void Lines::draw(const PictureView& view, const Eigen::Matrix4d& clipFromPlace) {
  ends_.clear();
  eye_ = view.X_WorldEye.position;
  if (view.showsGrid) addGrid();
  if (view.showsAxes) {
    for (int axis = 0; axis < 3; ++axis) {
      Vector3 end(0, 0, 2 * kGridHeight);
      end[axis] += kAxisLength;
      add({0, 0, 2 * kGridHeight}, end, Eigen::Vector3f::Unit(axis));
    }
  }
  if (ends_.empty()) return;
  program_.use();
  gl_.uniformMatrix4fv(shaders::kClipFromPlace, 1, GL_FALSE, Eigen::Matrix4f(clipFromPlace.cast<float>()).data());
  gl_.bindVertexArray(vertexArray_);
  gl_.bindBuffer(GL_ARRAY_BUFFER, buffer_);
  gl_.bufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(ends_.size() * sizeof(End)), ends_.data(), GL_STREAM_DRAW);
  gl_.drawArrays(GL_LINES, 0, static_cast<GLsizei>(ends_.size()));
}

}  // namespace pongsim::rendering
