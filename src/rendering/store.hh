#pragma once

#include <map>
#include <memory>
#include <utility>

#include "assets/images/picture_file.hh"
#include "rendering/gl.hh"
#include "rendering/surface.hh"

namespace pongsim::rendering {

/// Surfaces and images in OpenGL. Must not outlive its context.
class Store {
 public:
  explicit Store(const Gl& gl) : gl_(gl) {}
  ~Store();
  Store(const Store&) = delete;
  Store& operator=(const Store&) = delete;

  /// Draws a surface, uploading it the first time.
  /// @param mode What its corners are: of triangles, or of lines or points.
  void draw(const std::shared_ptr<const Surface>& surface, GLenum mode = GL_TRIANGLES);

  /// Binds an image to a texture unit for the shaders, uploading it the first time.
  /// @param picture Null: white.
  /// @param isColor Whether its values are colours (sRGB) rather than plain values.
  void use(GLuint unit, const std::shared_ptr<const assets::Picture>& picture, bool isColor);

  /// Deletes everything that nobody else holds any more.
  void tidy();

 private:
  struct Buffers {
    GLuint vertexArray = 0;
    GLuint vertices = 0;
    GLuint corners = 0;
    GLsizei count = 0;
  };
  Buffers takeIn(const Surface& surface);
  GLuint takeIn(const assets::Picture& picture, bool isColor);
  void drop(const Buffers& buffers);

  const Gl& gl_;
  std::map<std::shared_ptr<const Surface>, Buffers> surfaces_;
  /// The flag tells whether they are colours.
  std::map<std::pair<std::shared_ptr<const assets::Picture>, bool>, GLuint> pictures_;
  GLuint white_ = 0;
};

}  // namespace pongsim::rendering
