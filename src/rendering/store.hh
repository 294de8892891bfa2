#pragma once

#include <map>
#include <memory>
#include <utility>

#include "assets/picture_file.hh"
#include "rendering/gl.hh"
#include "rendering/surface.hh"

namespace pongsim::rendering {

/// Surfaces and pictures as OpenGL has them. It lives while its context does.
class Store {
 public:
  explicit Store(const Gl& gl) : gl_(gl) {}
  ~Store();
  Store(const Store&) = delete;
  Store& operator=(const Store&) = delete;

  /// Draws a surface, which it takes in at the first time.
  void draw(const std::shared_ptr<const Surface>& surface);

  /// Lets a picture be the one that shaders find in a texture unit. It is taken in at the first time.
  /// @param picture Null: white.
  /// @param isColor Its values are colours (sRGB), not shares that are meant as they are.
  void use(GLuint unit, const std::shared_ptr<const assets::Picture>& picture, bool isColor);

  /// Forgets all that nobody else holds any more.
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
  /// And whether they are colours.
  std::map<std::pair<std::shared_ptr<const assets::Picture>, bool>, GLuint> pictures_;
  GLuint white_ = 0;
};

}  // namespace pongsim::rendering
