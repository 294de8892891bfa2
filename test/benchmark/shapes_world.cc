#include "benchmark/shapes_world.hh"

#include <array>
#include <sstream>

namespace pongsim::benchmark {

namespace {

struct Kind {
  const char* name;
  /// [m]
  double y;
  /// [kg]; the moments of inertia are the same number [kg m^2].
  int mass;
  const char* geometry;
};

constexpr std::array kKinds = {
    Kind{"box", 0, 1, "<box><size>1 1 1</size></box>"},
    Kind{"cylinder", -1.5, 2, "<cylinder><radius>0.5</radius><length>1</length></cylinder>"},
    Kind{"sphere", 1.5, 3, "<sphere><radius>0.5</radius></sphere>"},
};

}  // namespace

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

std::string worldOfShapes(int count, bool falls) {
  std::ostringstream sdf;
  sdf << "<sdf version='1.6'><world name='shapes'><physics name='1ms' type='ignored'><max_step_size>0.001"
         "</max_step_size></physics><plugin filename='ignition-gazebo-physics-system' "
         "name='ignition::gazebo::systems::Physics'/><model name='ground_plane'><static>true</static>"
         "<link name='link'><collision name='collision'><geometry><plane><normal>0 0 1</normal></plane></geometry>"
         "</collision></link></model>";
  for (int i = 0; i < count / 3; ++i) {
    for (const Kind& kind : kKinds) {
      const double x = 1.5 * (i - count / 6);
      sdf << "<model name='" << kind.name << "_" << i << "'><pose>" << x << " " << kind.y << " "
          << (falls ? "2 0.3 0.2 0" : "0.5 0 0 0") << "</pose><link name='link'><inertial><mass>" << kind.mass
          << "</mass><inertia><ixx>" << kind.mass << "</ixx><iyy>" << kind.mass << "</iyy><izz>" << kind.mass
          << "</izz></inertia></inertial><collision name='collision'><geometry>" << kind.geometry
          << "</geometry></collision></link></model>";
    }
  }
  sdf << "</world></sdf>";
  return sdf.str();
}

}  // namespace pongsim::benchmark
