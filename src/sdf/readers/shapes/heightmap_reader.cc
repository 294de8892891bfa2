#include "sdf/readers/shapes/heightmap_reader.hh"

#include <memory>
#include <utility>
#include <variant>

#include "assets/meshes/ground.hh"
#include "sdf/includes/asset_file.hh"
#include "sdf/text/values.hh"

namespace pongsim::sdf {

namespace {

/// Reads the textures and how they are blended.
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
                              "the heightmap of " + owner + " must have a size above zero");
    return heightmap;
  }
  const AssetFile asset = findAsset(element, "heightmap", owner, isCollision, context);
  heightmap.uri = asset.uri;
  heightmap.file = asset.path;
  if (asset.path.empty() || !isCollision) return heightmap;

  auto ground = assets::readGround(asset.path, heightmap.size, heightmap.position);
  if (const auto* problem = std::get_if<assets::Problem>(&ground)) {
    asset.warn(*problem, context);
  } else {
    heightmap.triangles = std::make_shared<const description::TriangleMesh>(std::move(std::get<0>(ground)));
  }
  return heightmap;
}

}  // namespace pongsim::sdf
