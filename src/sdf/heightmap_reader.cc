#include "sdf/heightmap_reader.hh"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <utility>
#include <variant>

#include "assets/gray_image.hh"
#include "sdf/asset_file.hh"
#include "sdf/values.hh"

namespace pongsim::sdf {

namespace {

/// The ground of an image as Fortress makes it: black at z = 0, the brightest pixel at the size's z, the image's top
/// towards y. A pixel is as wide as the size divided by the number of pixels.
description::TriangleMesh groundOf(const assets::GrayImage& image, const Vector3& size, const Vector3& position) {
  const double brightest = std::max<double>(1, *std::ranges::max_element(image.pixels));
  const double stepX = size.x() / static_cast<double>(image.width);
  const double stepY = size.y() / static_cast<double>(image.height);
  const double middleX = static_cast<double>(image.width - 1) / 2, middleY = static_cast<double>(image.height - 1) / 2;
  description::TriangleMesh mesh;
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

/// Reads how the ground looks.
void readLooks(const Element& element, description::Heightmap& heightmap, Context& context) {
  heightmap.sampling = readUnsigned(element, "sampling", heightmap.sampling, context);
  heightmap.usesPaging = readFlag(element, "use_terrain_paging", heightmap.usesPaging, context);
  for (const Element* child : element.childrenNamed("texture")) {
    description::HeightmapTexture& texture = heightmap.textures.emplace_back();
    texture.size = readPositive(*child, "size", texture.size, context);
    texture.diffuse = readTexture(*child, "diffuse", context);
    texture.normal = readTexture(*child, "normal", context);
  }
  for (const Element* child : element.childrenNamed("blend")) {
    description::HeightmapBlend& blend = heightmap.blends.emplace_back();
    blend.minHeight = readNumber(*child, "min_height", blend.minHeight, context);
    blend.fadeDistance = readNumber(*child, "fade_dist", blend.fadeDistance, context);
  }
}

}  // namespace

description::Heightmap readHeightmap(const Element& element, const std::string& owner, bool isCollision,
                                     Context& context) {
  description::Heightmap heightmap;
  heightmap.size = readVector(element, "size", heightmap.size, context);
  heightmap.position = readVector(element, "pos", heightmap.position, context);
  readLooks(element, heightmap, context);
  if (!(heightmap.size.minCoeff() > 0)) {
    context.diagnostics.error(element.child("size")->position,
                              "the heightmap of " + owner + " has a size that is not above zero");
    return heightmap;
  }
  const AssetFile asset = findAsset(element, "heightmap", owner, isCollision, context);
  heightmap.uri = asset.uri;
  heightmap.file = asset.path;
  if (asset.path.empty() || !isCollision) return heightmap;

  const auto image = assets::readGrayImage(asset.path);
  if (const auto* problem = std::get_if<assets::Problem>(&image)) {
    asset.warn(*problem, context);
  } else {
    heightmap.triangles = std::make_shared<const description::TriangleMesh>(
        groundOf(std::get<0>(image), heightmap.size, heightmap.position));
  }
  return heightmap;
}

}  // namespace pongsim::sdf
