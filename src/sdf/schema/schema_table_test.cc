// The table's column "use" says whether an element or attribute is part of the description. For each one, this loads
// two files that differ only in its value: their descriptions must differ too, or be the same if its use is "passed".

#include "sdf/schema/schema_table.hh"

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "support/sdf/format_walk.hh"
#include "support/sdf/load_support.hh"
#include "support/sdf/same_description.hh"
#include "support/temp_folder.hh"

namespace pongsim::sdf::test {
namespace {

using Values = std::pair<std::string, std::string>;

/// Two valid values for texts that must be one of some words, or name another part.
const std::map<std::string_view, Values> kSpecial = {
    {"axis.xyz@expressed_in", {"", "f"}},
    {"camera.box_type", {"2d", "3d"}},
    {"camera.image.format", {"L8", "L16"}},
    {"camera.lens.custom_function.fun", {"sin", "id"}},
    {"camera.lens.type", {"custom", "equidistant"}},
    {"camera.segmentation_type", {"semantic", "panoptic"}},
    {"force_torque.frame", {"parent", "child"}},
    {"force_torque.measure_direction", {"parent_to_child", "child_to_parent"}},
    {"imu.orientation_reference_frame.custom_rpy@parent_frame", {"world", ""}},
    {"imu.orientation_reference_frame.localization", {"NED", "ENU"}},
    {"joint.axis.xyz@expressed_in", {"", "f"}},
    {"joint.axis2.xyz@expressed_in", {"", "f"}},
    {"joint.axis.mimic@axis", {"axis", "axis2"}},
    {"joint.axis.mimic@joint", {"leader", "other"}},
    {"joint.axis2.mimic@axis", {"axis", "axis2"}},
    {"joint.axis2.mimic@joint", {"leader", "other"}},
    {"joint.child", {"a", "b"}},
    {"joint.gearbox_reference_body", {"b", "world"}},
    {"joint.parent", {"a", "world"}},
    {"joint@type", {"revolute", "prismatic"}},
    {"light@type", {"spot", "point"}},
    {"lidar.noise.type", {"none", "gaussian"}},
    {"ray.noise.type", {"none", "gaussian"}},
    {"camera.noise.type", {"none", "gaussian"}},
    {"material.pbr.metal.metalness", {"0.25", "0.75"}},
    {"material.pbr.metal.normal_map@type", {"object", "tangent"}},
    {"material.pbr.metal.roughness", {"0.25", "0.75"}},
    {"material.pbr.specular.glossiness", {"0.25", "0.75"}},
    {"material.pbr.specular.normal_map@type", {"object", "tangent"}},
    {"material.shader@type", {"pixel", "vertex"}},
    {"mesh@optimization", {"convex_hull", "convex_decomposition"}},
    {"model@canonical_link", {"a", "b"}},
    {"model@placement_frame", {"", "f"}},
    {"noise@type", {"none", "gaussian"}},
    {"frame@attached_to", {"a", "b"}},
    {"particle_emitter@type", {"box", "point"}},
    {"polyline.point", {"0 3", "0 4"}},
    {"pose@relative_to", {"", "f"}},
    {"pose@rotation_format", {"euler_rpy", "quat_xyzw"}},
    {"inertial.pose@rotation_format", {"euler_rpy", "quat_xyzw"}},
    {"scene.fog.type", {"linear", "constant"}},
    {"sensor@type", {"imu", "camera"}},
    {"sonar.geometry", {"sphere", "cone"}},
};

Root described(const std::string& text) {
  Diagnostics ignored;
  Root root = loadText(text, "t.sdf", ignored, assets::finderIn({}));
  forgetSensorElements(root);
  return root;
}

/// @param folder Contains the files "one" and "two".
Values valuesFor(const Place& place, const std::string& folder) {
  const Schema::Part& part = place.part();
  const auto special = kSpecial.find(part.row.path);
  Values values = special != kSpecial.end() ? special->second : valuesOfType(part.row.type);
  if (part.name == "uri" && part.row.type == "string") values = {folder + "/one", folder + "/two"};
  // in the world, links of the model 'm' have its name as prefix
  const std::size_t depth = place.chain.size() - (place.attribute != nullptr ? 1 : 2);
  const bool isInWorld = depth > 0 && place.chain[depth - 1]->name == "world";
  const std::string_view row = part.row.path;
  if (isInWorld && (row == "frame@attached_to" || row == "joint.child" || row == "joint.parent" ||
                    row == "joint.gearbox_reference_body")) {
    for (std::string* value : {&values.first, &values.second}) {
      if (*value != "world") value->insert(0, "m::");
    }
  }
  return values;
}

/// @return Whether the place is in a link of an actor and is not read there. The table has the same rows for these
/// links as for those of models, but of theirs only visuals are read, without frames, and the links' poses, which only
/// show in visuals.
bool isPassedInAnActor(const Place& place) {
  for (std::size_t i = 0; i + 1 < place.chain.size(); ++i) {
    if (place.chain[i]->name != "actor" || place.chain[i + 1]->name != "link") continue;
    if (place.part().row.path == std::string_view("pose@relative_to") || i + 2 == place.chain.size()) return true;
    return place.chain[i + 2]->name != "visual";
  }
  return false;
}

TEST(SchemaTable, SaysWhatTheDescriptionHolds) {
  const pongsim::test::TempFolder folder;
  folder.write("one", "");
  folder.write("two", "");
  int count = 0;
  FormatWalk([&](const Place& place) {
    const std::string_view row = place.part().row.path;
    if (row == "sdf@version") return;
    // at the root there is no frame to refer to
    const bool isAtRoot = place.chain.size() < 4 && place.chain.at(1)->name != "world";
    if (isAtRoot && row == "pose@relative_to") return;
    ++count;
    const auto [one, other] = valuesFor(place, folder.path().string());
    const std::string a = documentWith(place, one), b = documentWith(place, other);
    const bool isPassed = place.use == Use::kPassed || isPassedInAnActor(place);
    EXPECT_EQ(isSame(described(a), described(b)), isPassed) << row << "\n" << a << "\n" << b;
  });
  EXPECT_GT(count, 1000);
}

}  // namespace
}  // namespace pongsim::sdf::test
