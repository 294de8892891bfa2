#include "sdf/readers/shapes/gazebo_material.hh"

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>

namespace pongsim::sdf {

namespace {

using description::Color;

struct NamedMaterial {
  /// Behind "Gazebo/".
  std::string_view name;
  Color ambient;
  Color diffuse;
  Color specular{0, 0, 0, 1};
  Color emissive{0, 0, 0, 1};
  bool isLit = true;
};

// of gazebo.material, in alphabetical order
constexpr NamedMaterial kMaterials[] = {
    {"Black", {0, 0, 0, 1}, {0, 0, 0, 1}, {0.1F, 0.1F, 0.1F, 1}},
    {"BlackTransparent", {0, 0, 0, 1}, {0, 0, 0, 0.5F}},
    {"Blue", {0, 0, 1, 1}, {0, 0, 1, 1}, {0.1F, 0.1F, 0.1F, 1}},
    {"BlueGlow", {0, 0, 1, 1}, {0, 0, 1, 1}, {0.1F, 0.1F, 0.1F, 1}, {0, 0, 1, 1}},
    {"BlueLaser", {0, 0, 1, 1}, {0, 0, 1, 0.4F}},
    {"BlueTransparent", {0, 0, 1, 1}, {0, 0, 1, 0.5F}},
    {"BlueTransparentOverlay", {0, 0, 1, 1}, {0, 0, 1, 0.5F}, {0, 0, 0, 1}, {0, 0, 0, 1}, false},
    {"Bricks", {1, 1, 1, 1}, {1, 1, 1, 1}, {0.2F, 0.2F, 0.2F, 1}},
    {"BuildingFrame", {1, 1, 1, 1}, {1, 1, 1, 1}, {0.2F, 0.2F, 0.2F, 1}},
    {"CeilingTiled", {0.5F, 0.5F, 0.5F, 1}, {1, 1, 1, 1}},
    {"CoM", {0.5F, 0.5F, 0.5F, 1}, {1, 1, 1, 1}},
    {"DarkGray", {0.175F, 0.175F, 0.175F, 1}, {0.175F, 0.175F, 0.175F, 1}, {0.175F, 0.175F, 0.175F, 1}},
    {"DarkGrey", {0.175F, 0.175F, 0.175F, 1}, {0.175F, 0.175F, 0.175F, 1}, {0.175F, 0.175F, 0.175F, 1}},
    {"DarkMagentaTransparent", {0.6F, 0, 0.6F, 1}, {0.6F, 0, 0.6F, 0.5F}},
    {"DarkOrangeTransparentOverlay",
     {0.6F, 0.305F, 0.028F, 1},
     {0.6F, 0.305F, 0.028F, 0.8F},
     {0, 0, 0, 1},
     {0, 0, 0, 1},
     false},
    {"DarkYellow", {0.7F, 0.7F, 0, 1}, {0.7F, 0.7F, 0, 1}},
    {"Editor", {1, 1, 1, 1}, {1, 1, 1, 1}, {0.1F, 0.1F, 0.1F, 1}},
    {"EditorPlane", {0.3F, 0.3F, 0.3F, 1}, {0.7F, 0.7F, 0.7F, 1}, {0.01F, 0.01F, 0.01F, 1}},
    {"FlatBlack", {0.1F, 0.1F, 0.1F, 1}, {0.1F, 0.1F, 0.1F, 1}, {0.01F, 0.01F, 0.01F, 1}},
    {"Footway", {0.1F, 0.1F, 0.1F, 1}, {0.8F, 0.8F, 0.8F, 1}, {0.01F, 0.01F, 0.01F, 1}},
    {"Gold", {0.4F, 0.24869F, 0.020759F, 1}, {0.8F, 0.64869F, 0.120759F, 1}, {0.4F, 0.4F, 0.4F, 1}},
    {"Grass", {0.5F, 0.5F, 0.5F, 1}, {1, 1, 1, 1}},
    {"Gray", {0.3F, 0.3F, 0.3F, 1}, {0.7F, 0.7F, 0.7F, 1}, {0.01F, 0.01F, 0.01F, 1}},
    {"Green", {0, 1, 0, 1}, {0, 1, 0, 1}, {0.1F, 0.1F, 0.1F, 1}},
    {"GreenGlow", {0, 1, 0, 1}, {0, 1, 0, 1}, {0.1F, 0.1F, 0.1F, 1}, {0, 1, 0, 1}},
    {"GreenTransparent", {0, 1, 0, 1}, {0, 1, 0, 0.5F}},
    {"GreenTransparentOverlay", {0, 1, 0, 1}, {0, 1, 0, 0.5F}, {0, 0, 0, 1}, {0, 0, 0, 1}, false},
    {"Grey", {0.3F, 0.3F, 0.3F, 1}, {0.7F, 0.7F, 0.7F, 1}, {0.01F, 0.01F, 0.01F, 1}},
    {"GreyTransparent", {0.5F, 0.5F, 0.5F, 1}, {0.5F, 0.5F, 0.5F, 0.5F}},
    {"Indigo", {0.33F, 0, 0.5F, 1}, {0.33F, 0, 0.5F, 1}, {0.1F, 0.1F, 0.1F, 1}},
    {"JointAnchor", {1, 1, 1, 1}, {1, 1, 1, 1}, {1, 1, 1, 1}, {1, 1, 1, 1}, false},
    {"Lane_1", {0.1F, 0.1F, 0.1F, 1}, {0.8F, 0.8F, 0.8F, 1}, {0.01F, 0.01F, 0.01F, 1}},
    {"Lanes_2", {0.1F, 0.1F, 0.1F, 1}, {0.8F, 0.8F, 0.8F, 1}, {0.01F, 0.01F, 0.01F, 1}},
    {"Lanes_4", {0.1F, 0.1F, 0.1F, 1}, {0.8F, 0.8F, 0.8F, 1}, {0.01F, 0.01F, 0.01F, 1}},
    {"Lanes_6", {0.1F, 0.1F, 0.1F, 1}, {0.8F, 0.8F, 0.8F, 1}, {0.01F, 0.01F, 0.01F, 1}},
    {"LightBlueLaser", {0.5F, 0.5F, 1, 1}, {0.5F, 0.5F, 1, 0.4F}},
    {"LightOff", {1, 0, 0, 1}, {1, 0, 0, 1}, {0, 0, 0, 1}, {1, 0, 0, 1}},
    {"LightOn", {0, 1, 0, 1}, {0, 1, 0, 1}, {0, 0, 0, 1}, {0, 1, 0, 1}},
    {"Motorway", {0.1F, 0.1F, 0.1F, 1}, {0.8F, 0.8F, 0.8F, 1}, {0.01F, 0.01F, 0.01F, 1}},
    {"Orange", {1, 0.5088F, 0.0468F, 1}, {1, 0.5088F, 0.0468F, 1}, {0.5F, 0.5F, 0.5F, 1}},
    {"OrangeTransparent", {1, 0.44F, 0, 1}, {1, 0.44F, 0, 0.4F}},
    {"OrangeTransparentOverlay",
     {1, 0.5088F, 0.0468F, 1},
     {1, 0.5088F, 0.0468F, 0.8F},
     {0, 0, 0, 1},
     {0, 0, 0, 1},
     false},
    {"PaintedWall", {1, 1, 1, 1}, {1, 1, 1, 1}},
    {"Pedestrian", {0.1F, 0.1F, 0.1F, 1}, {0.8F, 0.8F, 0.8F, 1}, {0.01F, 0.01F, 0.01F, 1}},
    {"Pioneer2Body", {0.481193F, 0.000123F, 0.000123F, 1}, {0.681193F, 0.000923F, 0.000923F, 1}, {0.5F, 0.5F, 0.5F, 1}},
    {"PioneerBody", {0.5F, 0, 0, 1}, {1, 0, 0, 1}, {0.5F, 0, 0, 1}},
    {"Primary", {0.1F, 0.1F, 0.1F, 1}, {0.8F, 0.8F, 0.8F, 1}, {0.01F, 0.01F, 0.01F, 1}},
    {"Purple", {1, 0, 1, 1}, {1, 0, 1, 1}, {0.1F, 0.1F, 0.1F, 1}},
    {"PurpleGlow", {1, 0, 1, 1}, {1, 0, 1, 1}, {0.1F, 0.1F, 0.1F, 1}, {1, 0, 1, 1}},
    {"Red", {1, 0, 0, 1}, {1, 0, 0, 1}, {0.1F, 0.1F, 0.1F, 1}},
    {"RedBright", {0.87F, 0.26F, 0.07F, 1}, {0.87F, 0.26F, 0.07F, 1}, {0.87F, 0.26F, 0.07F, 1}},
    {"RedGlow", {1, 0, 0, 1}, {1, 0, 0, 1}, {0, 0, 0, 1}, {1, 0, 0, 1}},
    {"RedTransparent", {1, 0, 0, 1}, {1, 0, 0, 0.5F}, {0, 0, 0, 1}, {0, 0, 0, 1}, false},
    {"RedTransparentOverlay", {1, 0, 0, 1}, {1, 0, 0, 0.5F}, {0, 0, 0, 1}, {0, 0, 0, 1}, false},
    {"Residential", {0.1F, 0.1F, 0.1F, 1}, {0.8F, 0.8F, 0.8F, 1}, {0.01F, 0.01F, 0.01F, 1}},
    {"Road", {0.1F, 0.1F, 0.1F, 1}, {0.8F, 0.8F, 0.8F, 1}, {0.01F, 0.01F, 0.01F, 1}},
    {"Runway", {0.5F, 0.5F, 0.5F, 1}, {1, 1, 1, 1}},
    {"Secondary", {0.1F, 0.1F, 0.1F, 1}, {0.8F, 0.8F, 0.8F, 1}, {0.01F, 0.01F, 0.01F, 1}},
    {"SkyBlue", {0.13F, 0.44F, 0.7F, 1}, {0, 0, 1, 1}, {0.1F, 0.1F, 0.1F, 1}},
    {"Steps", {0.1F, 0.1F, 0.1F, 1}, {0.8F, 0.8F, 0.8F, 1}, {0.01F, 0.01F, 0.01F, 1}},
    {"Tertiary", {0.1F, 0.1F, 0.1F, 1}, {0.8F, 0.8F, 0.8F, 1}, {0.01F, 0.01F, 0.01F, 1}},
    {"Trunk", {0.1F, 0.1F, 0.1F, 1}, {0.8F, 0.8F, 0.8F, 1}, {0.01F, 0.01F, 0.01F, 1}},
    {"Turquoise", {0, 1, 1, 1}, {0, 1, 1, 1}, {0.1F, 0.1F, 0.1F, 1}},
    {"TurquoiseGlow", {0, 1, 1, 1}, {0, 1, 1, 1}, {0.1F, 0.1F, 0.1F, 1}, {0, 1, 1, 1}},
    {"TurquoiseGlowOutline", {0, 1, 1, 1}, {0, 1, 1, 1}, {0.1F, 0.1F, 0.1F, 1}, {0, 1, 1, 1}},
    {"White", {1, 1, 1, 1}, {1, 1, 1, 1}, {0.1F, 0.1F, 0.1F, 1}},
    {"WhiteGlow", {1, 1, 1, 1}, {1, 1, 1, 1}, {0.1F, 0.1F, 0.1F, 1}, {1, 1, 1, 1}},
    {"Wood", {1, 1, 1, 1}, {1, 1, 1, 1}, {0.2F, 0.2F, 0.2F, 1}},
    {"WoodFloor", {0.5F, 0.5F, 0.5F, 1}, {1, 1, 1, 1}},
    {"WoodPallet", {0.5F, 0.5F, 0.5F, 1}, {1, 1, 1, 1}},
    {"Yellow", {1, 1, 0, 1}, {1, 1, 0, 1}},
    {"YellowGlow", {1, 1, 0, 1}, {1, 1, 0, 1}, {0, 0, 0, 1}, {1, 1, 0, 1}},
    {"YellowTransparent", {1, 1, 0, 1}, {1, 1, 0, 0.5F}},
    {"ZincYellow", {0.9725F, 0.9529F, 0.2078F, 1}, {0.9725F, 0.9529F, 0.2078F, 1}, {0.9725F, 0.9529F, 0.2078F, 1}},
};
static_assert(std::ranges::is_sorted(kMaterials, {}, &NamedMaterial::name));

/// The materials in the form in which others have them.
std::array<description::Material, std::size(kMaterials)> allMaterials() {
  std::array<description::Material, std::size(kMaterials)> all;
  std::ranges::transform(kMaterials, all.begin(), [](const NamedMaterial& named) {
    description::Material material;
    material.ambient = named.ambient;
    material.diffuse = named.diffuse;
    material.specular = named.specular;
    material.emissive = named.emissive;
    material.isLit = named.isLit;
    return material;
  });
  return all;
}

}  // namespace

const description::Material* gazeboMaterial(std::string_view name) {
  constexpr std::string_view kPrefix = "Gazebo/";
  if (!name.starts_with(kPrefix)) return nullptr;
  static const auto kAll = allMaterials();
  const auto* found = std::ranges::lower_bound(kMaterials, name.substr(kPrefix.size()), {}, &NamedMaterial::name);
  if (found == std::end(kMaterials) || found->name != name.substr(kPrefix.size())) return nullptr;
  return &kAll[static_cast<std::size_t>(found - std::begin(kMaterials))];
}

}  // namespace pongsim::sdf
