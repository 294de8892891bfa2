#include "benchmark/shapes_world.hh"

namespace pongsim::benchmark {

std::string shapeModel(int number) {
  const char* const geometries[] = {"<box><size>1 1 1</size></box>", "<sphere><radius>0.5</radius></sphere>",
                                    "<cylinder><radius>0.5</radius><length>1</length></cylinder>"};
  const std::string geometry = std::string("<geometry>") + geometries[number % 3] + "</geometry>";
  return "    <model name=\"shape_" + std::to_string(number) + "\">\n      <pose>" + std::to_string(number % 50 * 2) +
         " " + std::to_string(number / 50 * 2) + " 0.5 0 0 0</pose>\n      <link name=\"link\">\n        <inertial>\n" +
         "          <inertia>\n            <ixx>0.16666</ixx>\n            <ixy>0</ixy>\n" +
         "            <ixz>0</ixz>\n            <iyy>0.16666</iyy>\n            <iyz>0</iyz>\n" +
         "            <izz>0.16666</izz>\n          </inertia>\n          <mass>1.0</mass>\n" +
         "        </inertial>\n        <collision name=\"collision\">" + geometry +
         "</collision>\n        <visual name=\"visual\">" + geometry +
         "\n          <material>\n            <ambient>1 0 0 1</ambient>\n            <diffuse>1 0 0 1</diffuse>\n" +
         "            <specular>1 0 0 1</specular>\n          </material>\n        </visual>\n      </link>\n" +
         "    </model>\n";
}

std::string shapesWorld(int count) {
  std::string text = "<?xml version=\"1.0\"?>\n<sdf version=\"1.6\">\n  <world name=\"shapes\">\n";
  for (int i = 0; i < count; ++i) text += shapeModel(i);
  return text + "  </world>\n</sdf>\n";
}

}  // namespace pongsim::benchmark
