#include "combinations/kinds.hh"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "support/fortress_worlds.hh"

namespace pongsim::test {

namespace {

namespace fs = std::filesystem;

std::string plugin(const std::string& system, const std::string& className) {
  return "<plugin filename='ignition-gazebo-" + system + "-system' name='ignition::gazebo::systems::" + className +
         "'/>";
}

constexpr const char* kInertial =
    "<inertial><mass>1</mass><inertia><ixx>0.1</ixx><iyy>0.1</iyy><izz>0.1</izz></inertia></inertial>";

std::string link(const std::string& name, const std::string& content = "") {
  return "<link name='" + name + "'>" + kInertial + content + "</link>";
}

/// A shape to collide with and to be seen.
std::string solid(const std::string& geometry) {
  return "<collision name='c'><geometry>" + geometry + "</geometry></collision><visual name='v'><geometry>" + geometry +
         "</geometry></visual>";
}

std::string box() { return solid("<box><size>0.5 0.5 0.5</size></box>"); }

std::string model(const std::string& name, const std::string& content) {
  return "<model name='" + name + "'>" + content + "</model>";
}

const std::string& ground() {
  static const std::string text = model(
      "ground", "<static>true</static><link name='link'>" + solid("<plane><normal>0 0 1</normal></plane>") + "</link>");
  return text;
}

void addModels(std::vector<Kind>& kinds) {
  kinds.push_back(kindOf("plain_model", ground() + model("box", "<pose>0 0 0.3 0 0 0</pose>" + link("link", box()))));
  kinds.push_back(kindOf("static_model", model("rock", "<static>true</static><link name='link'>" + box() + "</link>")));
  kinds.push_back(kindOf(
      "nested_model",
      ground() +
          model("outer", "<pose>0 0 1 0 0 0</pose>" + link("link", box()) +
                             model("inner", "<pose>0 0 1 0 0 0</pose>" + link("link", box())) +
                             "<joint name='hinge' type='revolute'><parent>link</parent><child>inner::link</child>"
                             "<axis><xyz>0 1 0</xyz></axis></joint>")));
  kinds.push_back(kindOf("frame_model", model("box", "<frame name='corner'/>" + link("link", box()))));
  kinds.back().models.front().inWorld += "<frame name='place' attached_to='box'/>";
  kinds.push_back(
      kindOf("light_on_a_link", "<light name='sun' type='directional'/>" +
                                    model("lamp", link("link", box() + "<light name='bulb' type='point'/>"))));
  kinds.push_back(
      kindOf("actor",
             "<actor name='walker'><link name='body'><visual name='v'><geometry><sphere><radius>0.2</radius></sphere>"
             "</geometry></visual></link><script><loop>true</loop><trajectory id='0' type='walk'>"
             "<waypoint><time>0</time><pose>0 0 1 0 0 0</pose></waypoint>"
             "<waypoint><time>0.1</time><pose>1 0 1 0 0 0</pose></waypoint></trajectory></script></actor>" +
                 plugin("scene-broadcaster", "SceneBroadcaster") + model("box", link("link", box()))));
}

/// A robot in URDF, which is included in the world and inserted as it is.
Kind robotKind() {
  const fs::path file = projectFolder() / "test/combinations/robot.urdf";
  std::ifstream stream(file);
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  Kind kind = kindOf("urdf_robot", plugin("imu", "Imu"));
  kind.models.push_back({"robot", "<include><uri>" + file.string() + "</uri></include>", text});
  kind.commands.push_back({"/shoulder", "ignition.msgs.Double", "data: 0.5"});
  kind.publishesInEachStep = true;
  return kind;
}

void addJoints(std::vector<Kind>& kinds) {
  const std::string axis =
      "<axis><xyz>0 1 0</xyz><limit><lower>-1</lower><upper>1</upper></limit>"
      "<dynamics><damping>0.1</damping><friction>0.1</friction></dynamics></axis>";
  const std::string axes = axis + "<axis2><xyz>1 0 0</xyz></axis2>";
  const std::vector<std::pair<std::string, std::string>> types = {
      {"fixed", ""},       {"ball", ""},
      {"revolute", axis},  {"continuous", "<axis><xyz>0 1 0</xyz></axis>"},
      {"prismatic", axis}, {"universal", axes},
      {"revolute2", axes}, {"screw", axis + "<thread_pitch>-0.5</thread_pitch>"},
  };
  const std::string links = link("base") + "<link name='arm'><pose>0 0 1 0 0 0</pose>" + kInertial + "</link>";
  for (const auto& [type, content] : types) {
    const std::string children = "<parent>base</parent><child>arm</child>" + content;
    kinds.push_back(
        kindOf(type + "_joint", model("m", links + "<joint name='j' type='" + type + "'>" + children + "</joint>" +
                                               plugin("joint-state-publisher", "JointStatePublisher"))));
  }
  kinds.push_back(
      kindOf("joint_to_the_world", model("m", links +
                                                  "<joint name='hold' type='fixed'><parent>world</parent>"
                                                  "<child>base</child></joint><joint name='j' type='revolute'>"
                                                  "<parent>base</parent><child>arm</child>" +
                                                  axis + "</joint>")));
  const std::string gears = "<axis><xyz>0 1 0</xyz></axis><axis2><xyz>0 1 0</xyz></axis2>";
  const std::string second = "<link name='hand'><pose>0 0 2 0 0 0</pose>" + std::string(kInertial) +
                             "</link><joint name='j' type='revolute'><parent>base</parent><child>arm</child>" + axis +
                             "</joint>";
  kinds.push_back(kindOf(
      "gearbox_joint",
      model("m", links + second + "<joint name='k' type='revolute'><parent>base</parent><child>hand</child>" + axis +
                     "</joint><joint name='gears' type='gearbox'><parent>arm</parent><child>hand</child>"
                     "<gearbox_ratio>2</gearbox_ratio><gearbox_reference_body>base</gearbox_reference_body>" +
                     gears + "</joint>")));
  kinds.push_back(kindOf("mimic_joint",
                         model("m", links + second +
                                        "<joint name='k' type='revolute'><parent>arm</parent><child>hand</child><axis>"
                                        "<xyz>0 1 0</xyz><mimic joint='j'><multiplier>2</multiplier><offset>0</offset>"
                                        "<reference>0</reference></mimic></axis></joint>")));
}

/// A mast with a sensor that publishes in each step, before a wall.
/// @param customType The `gz:type` of a custom sensor.
Kind sensorKind(const std::string& type, const std::string& system, const std::string& settings,
                const std::string& customType = {}) {
  const std::string sensor =
      "<sensor name='sensor' type='" + type + (customType.empty() ? "" : "' gz:type='" + customType) +
      "'><always_on>1</always_on><update_rate>1000</update_rate><topic>readings</topic>" + settings + "</sensor>";
  const std::string hold = "<joint name='hold' type='fixed'><parent>world</parent><child>link</child>";
  const bool isOnJoint = type == "force_torque";
  Kind kind =
      kindOf(customType.empty() ? type : customType.substr(0, customType.find('/')),
             system +
                 "<spherical_coordinates><surface_model>EARTH_WGS84</surface_model><latitude_deg>10</latitude_deg>"
                 "<longitude_deg>20</longitude_deg><elevation>5</elevation></spherical_coordinates>" +
                 model("mast", link("link", isOnJoint ? box() : box() + sensor) + hold + (isOnJoint ? sensor : "") +
                                   "</joint>") +
                 model("wall", "<static>true</static><pose>2 0 0 0 0 0</pose><link name='link'>" + box() + "</link>"));
  kind.publishesInEachStep = true;
  return kind;
}

void addSensors(std::vector<Kind>& kinds) {
  const std::string cameras = plugin("sensors", "Sensors");
  const std::string camera =
      "<camera><horizontal_fov>1</horizontal_fov><image><width>8</width><height>6</height></image>"
      "<clip><near>0.1</near><far>10</far></clip></camera>";
  const std::string beams =
      "<lidar><scan><horizontal><samples>9</samples><min_angle>-1</min_angle><max_angle>1</max_angle></horizontal></"
      "scan>"
      "<range><min>0.3</min><max>10</max></range></lidar>";
  for (const char* type : {"boundingbox", "boundingbox_camera", "camera", "depth", "depth_camera", "rgbd",
                           "rgbd_camera", "segmentation", "segmentation_camera", "thermal", "thermal_camera"}) {
    kinds.push_back(sensorKind(type, cameras, camera));
  }
  std::string wide = camera;
  wide.insert(wide.find("</camera>"), "<lens><env_texture_size>8</env_texture_size></lens>");
  for (const char* type : {"wide_angle_camera", "wideanglecamera"}) kinds.push_back(sensorKind(type, cameras, wide));
  for (const char* type : {"gpu_lidar", "gpu_ray", "lidar", "ray"}) kinds.push_back(sensorKind(type, cameras, beams));
  kinds.push_back(sensorKind("air_pressure", plugin("air-pressure", "AirPressure"), ""));
  kinds.push_back(sensorKind("air_speed", plugin("air-speed", "AirSpeed"), ""));
  kinds.push_back(sensorKind("altimeter", plugin("altimeter", "Altimeter"), ""));
  kinds.push_back(sensorKind("imu", plugin("imu", "Imu"), ""));
  kinds.push_back(sensorKind("magnetometer", plugin("magnetometer", "Magnetometer"), ""));
  kinds.push_back(sensorKind("navsat", plugin("navsat", "NavSat"), ""));
  kinds.push_back(sensorKind("force_torque", plugin("forcetorque", "ForceTorque"), ""));
  kinds.push_back(sensorKind("logical_camera", plugin("logical-camera", "LogicalCamera"),
                             "<logical_camera><near>0.1</near><far>5</far><aspect_ratio>1.5</aspect_ratio>"
                             "<horizontal_fov>1</horizontal_fov></logical_camera>"));
  kinds.push_back(sensorKind(
      "custom", plugin("dvl", "DopplerVelocityLogSystem"),
      "<gz:dvl><resolution>0.1</resolution><arrangement><beam><tilt>0.5</tilt></beam><beam><tilt>0.5</tilt><rotation>2"
      "</rotation></beam><beam><tilt>0.5</tilt><rotation>4</rotation></beam></arrangement>"
      "<tracking><bottom_mode/></tracking></gz:dvl>",
      "dvl"));
  const fs::path table = projectFolder() / "plugins/sensors/environmental-sensor/water.csv";
  kinds.push_back(sensorKind("custom",
                             plugin("environmental-sensor", "EnvironmentalSystem") +
                                 "<plugin filename='gz-sim-environment-preload-system' "
                                 "name='gz::sim::systems::EnvironmentPreload'><data>" +
                                 table.string() +
                                 "</data><dimensions><time>time</time><ignore_time>true</ignore_time></dimensions>"
                                 "</plugin>",
                             "", "environmental_sensor/temperature"));
  // only while it is where the table has values
  kinds.back().publishesInEachStep = false;
}

}  // namespace

std::vector<Kind> allKinds() {
  std::vector<Kind> kinds;
  addModels(kinds);
  kinds.push_back(robotKind());
  addJoints(kinds);
  addSensors(kinds);
  std::vector<fs::path> examples;
  for (const auto& file : fs::recursive_directory_iterator(projectFolder() / "plugins")) {
    if (file.path().extension() == ".sdf") examples.push_back(file.path());
  }
  std::ranges::sort(examples);
  for (const fs::path& file : examples) {
    kinds.push_back(kindFrom(file));
    kinds.back().name += "_system";
  }
  return kinds;
}

}  // namespace pongsim::test
