#include "rendering/store.hh"

#include <cstddef>

namespace pongsim::rendering {

namespace {

/// @return The offset of a member in a buffer, in OpenGL's form.
const void* offset(std::size_t bytes) { return reinterpret_cast<const void*>(bytes); }

}  // namespace

Store::~Store() {
  for (const auto& [surface, buffers] : surfaces_) drop(buffers);
  for (const auto& [picture, texture] : pictures_) gl_.deleteTextures(1, &texture);
  gl_.deleteTextures(1, &white_);
}

void Store::draw(const std::shared_ptr<const Surface>& surface, GLenum mode) {
  const auto [entry, isNew] = surfaces_.try_emplace(surface);
  if (isNew) entry->second = takeIn(*surface);
  gl_.bindVertexArray(entry->second.vertexArray);
  gl_.drawElements(mode, entry->second.count, GL_UNSIGNED_INT, nullptr);
}

void Store::use(GLuint unit, const std::shared_ptr<const assets::Picture>& picture, bool isColor) {
  gl_.activeTexture(GL_TEXTURE0 + unit);
  if (picture == nullptr) {
    if (white_ == 0) white_ = takeIn({1, 1, {255, 255, 255, 255}}, false);
    gl_.bindTexture(GL_TEXTURE_2D, white_);
    return;
  }
  const auto [entry, isNew] = pictures_.try_emplace({picture, isColor}, 0);
  if (isNew) entry->second = takeIn(*picture, isColor);
  gl_.bindTexture(GL_TEXTURE_2D, entry->second);
}

void Store::tidy() {
  std::erase_if(surfaces_, [this](const auto& entry) {
    if (entry.first.use_count() > 1) return false;
    drop(entry.second);
    return true;
  });
  std::erase_if(pictures_, [this](const auto& entry) {
    // the image can be here twice: as a colour and as plain values
    const auto& picture = entry.first.first;
    const long own = static_cast<long>(pictures_.count({picture, true}) + pictures_.count({picture, false}));
    if (picture.use_count() > own) return false;
    gl_.deleteTextures(1, &entry.second);
    return true;
  });
}

Store::Buffers Store::takeIn(const Surface& surface) {
  Buffers buffers;
  buffers.count = static_cast<GLsizei>(surface.corners.size());
  gl_.genVertexArrays(1, &buffers.vertexArray);
  gl_.bindVertexArray(buffers.vertexArray);
  gl_.genBuffers(1, &buffers.vertices);
  gl_.bindBuffer(GL_ARRAY_BUFFER, buffers.vertices);
  gl_.bufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(surface.vertices.size() * sizeof(Vertex)),
                 surface.vertices.data(), GL_STATIC_DRAW);
  gl_.genBuffers(1, &buffers.corners);
  gl_.bindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers.corners);
  gl_.bufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(surface.corners.size() * sizeof(std::uint32_t)),
                 surface.corners.data(), GL_STATIC_DRAW);
  static_assert(sizeof(Vertex) == 8 * sizeof(float));
  gl_.vertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(Vertex), offset(offsetof(Vertex, position)));
  gl_.vertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, sizeof(Vertex), offset(offsetof(Vertex, normal)));
  gl_.vertexAttribPointer(2, 2, GL_FLOAT, GL_FALSE, sizeof(Vertex), offset(offsetof(Vertex, coordinates)));
  for (const GLuint attribute : {0U, 1U, 2U}) gl_.enableVertexAttribArray(attribute);
  return buffers;
}

GLuint Store::takeIn(const assets::Picture& picture, bool isColor) {
  GLuint texture = 0;
  gl_.genTextures(1, &texture);
  gl_.bindTexture(GL_TEXTURE_2D, texture);
  gl_.texImage2D(GL_TEXTURE_2D, 0, isColor ? GL_SRGB8_ALPHA8 : GL_RGBA8, static_cast<GLsizei>(picture.width),
                 static_cast<GLsizei>(picture.height), 0, GL_RGBA, GL_UNSIGNED_BYTE, picture.pixels.data());
  gl_.generateMipmap(GL_TEXTURE_2D);
  gl_.texParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  gl_.texParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  return texture;
}

void Store::drop(const Buffers& buffers) {
  gl_.deleteVertexArrays(1, &buffers.vertexArray);
  gl_.deleteBuffers(1, &buffers.vertices);
  gl_.deleteBuffers(1, &buffers.corners);
}

}  // namespace pongsim::rendering
