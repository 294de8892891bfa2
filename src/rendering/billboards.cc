#include "rendering/billboards.hh"

#include <algorithm>
#include <cstddef>

#include "rendering/shaders.hh"

namespace pongsim::rendering {

namespace {

constexpr GLsizei kCorners = 6;

constexpr const char* kBillboardVertex = R"(#version 450 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec2 coordinates;
layout(location = 2) in vec4 tint;
layout(location = 1) uniform mat4 clipFromPlace;
out vec2 texel;
out vec4 shade;
void main() {
  texel = coordinates;
  shade = tint;
  gl_Position = clipFromPlace * vec4(position, 1);
}
)";

constexpr const char* kBillboardFragment = R"(#version 450 core
layout(binding = 0) uniform sampler2D picture;
in vec2 texel;
in vec4 shade;
out vec4 color;
void main() { color = texture(picture, texel) * shade; }
)";

const void* billboardOffset(std::size_t bytes) { return reinterpret_cast<const void*>(bytes); }

}  // namespace

Billboards::Billboards(const Gl& gl) : gl_(gl), program_(gl, kBillboardVertex, kBillboardFragment) {
  gl_.genVertexArrays(1, &vertexArray_);
  gl_.bindVertexArray(vertexArray_);
  gl_.genBuffers(1, &buffer_);
  gl_.bindBuffer(GL_ARRAY_BUFFER, buffer_);
  static_assert(sizeof(Corner) % sizeof(float) == 0);
  gl_.vertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(Corner), nullptr);
  gl_.vertexAttribPointer(1, 2, GL_FLOAT, GL_FALSE, sizeof(Corner), billboardOffset(offsetof(Corner, texel)));
  gl_.vertexAttribPointer(2, 4, GL_FLOAT, GL_FALSE, sizeof(Corner), billboardOffset(offsetof(Corner, color)));
  for (const GLuint attribute : {0U, 1U, 2U}) gl_.enableVertexAttribArray(attribute);
}

Billboards::~Billboards() {
  gl_.deleteBuffers(1, &buffer_);
  gl_.deleteVertexArrays(1, &vertexArray_);
}

void Billboards::add(const Billboard& billboard, const Vector3& toCentre, const Matrix3& eye) {
  constexpr std::pair<int, int> kPlaces[kCorners] = {{0, 0}, {0, 1}, {1, 0}, {1, 0}, {0, 1}, {1, 1}};
  for (const auto& [right, down] : kPlaces) {
    const Vector3 place = toCentre - eye.col(1) * (billboard.halfWidth * (2 * right - 1)) -
                          eye.col(2) * (billboard.halfHeight * (2 * down - 1));
    corners_.push_back({place.cast<float>(), {static_cast<float>(right), static_cast<float>(down)}, billboard.color});
  }
}

void Billboards::draw(std::span<const Billboard> billboards, const PictureView& view,
                      const Eigen::Matrix4d& clipFromPlace, Store& store) {
  const Matrix3 eye = view.X_WorldEye.rotation.toRotationMatrix();
  order_.clear();
  corners_.clear();
  for (const Billboard& billboard : billboards) {
    const double ahead = eye.col(0).dot(billboard.place - view.X_WorldEye.position);
    if (ahead > view.near) order_.emplace_back(-ahead, &billboard);
  }
  if (order_.empty()) return;
  std::ranges::stable_sort(order_, {}, &std::pair<double, const Billboard*>::first);
  for (const auto& [distance, billboard] : order_) add(*billboard, billboard->place - view.X_WorldEye.position, eye);

  program_.use();
  gl_.uniformMatrix4fv(shaders::kClipFromPlace, 1, GL_FALSE, Eigen::Matrix4f(clipFromPlace.cast<float>()).data());
  gl_.bindVertexArray(vertexArray_);
  gl_.bindBuffer(GL_ARRAY_BUFFER, buffer_);
  gl_.bufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(corners_.size() * sizeof(Corner)), corners_.data(),
                 GL_STREAM_DRAW);
  // at once as many as have the same image
  for (std::size_t first = 0; first < order_.size();) {
    const auto& picture = order_[first].second->picture;
    std::size_t last = first + 1;
    while (last < order_.size() && order_[last].second->picture == picture) ++last;
    store.use(0, picture, true);
    gl_.bindVertexArray(vertexArray_);
    gl_.drawArrays(GL_TRIANGLES, static_cast<GLint>(first) * kCorners, static_cast<GLsizei>(last - first) * kCorners);
    first = last;
  }
}

}  // namespace pongsim::rendering
