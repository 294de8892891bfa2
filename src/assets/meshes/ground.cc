#include "assets/meshes/ground.hh"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>

#include "assets/images/gray_image.hh"

namespace pongsim::assets {

namespace {

using description::TriangleMesh;

/// The terrain of an image as Fortress makes it: black at z = 0, the brightest pixel at the size's z, the top of the
/// image towards +y. A pixel's width is the size divided by the number of pixels.
TriangleMesh groundOf(const GrayImage& image, const Vector3& size, const Vector3& position) {
  assert(!image.pixels.empty());
  const double brightest = std::max<double>(1, *std::ranges::max_element(image.pixels));
  const double stepX = size.x() / static_cast<double>(image.width);
  const double stepY = size.y() / static_cast<double>(image.height);
  const double middleX = static_cast<double>(image.width - 1) / 2, middleY = static_cast<double>(image.height - 1) / 2;
  TriangleMesh mesh;
  for (std::size_t row = 0; row < image.height; ++row) {
    for (std::size_t column = 0; column < image.width; ++column) {
      mesh.vertices.push_back(position + Vector3((static_cast<double>(column) - middleX) * stepX,
                                                 (middleY - static_cast<double>(row)) * stepY,
                                                 image.at(column, row) / brightest * size.z()));
    }
  }
  for (std::size_t row = 0; row + 1 < image.height; ++row) {
    for (std::size_t column = 0; column + 1 < image.width; ++column) {
      const auto a = static_cast<std::uint32_t>(row * image.width + column);
      const auto below = static_cast<std::uint32_t>(a + image.width);
      mesh.triangles.push_back({a, below, below + 1});
      mesh.triangles.push_back({a, below + 1, a + 1});
    }
  }
  return mesh;
}

}  // namespace

std::variant<TriangleMesh, Problem> readGround(const std::filesystem::path& file, const Vector3& size,
                                               const Vector3& position) {
  const auto image = readGrayImage(file);
  if (const auto* problem = std::get_if<Problem>(&image)) return *problem;
  return groundOf(std::get<0>(image), size, position);
}

}  // namespace pongsim::assets
