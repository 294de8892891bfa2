// Measures lidars and cameras: the scan of Fortress's tutorial compared with bare Embree, many beams among many moving
// bodies, camera images, and sensors without subscribers.

#include <benchmark/benchmark.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <memory>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "benchmark/bare_embree.hh"
#include "benchmark/medians.hh"
#include "pongsim/math.hh"
#include "pongsim/message.hh"
#include "pongsim/sensing/camera_scene.hh"
#include "pongsim/simulation.hh"
#include "sdf/loader.hh"
#include "support/fortress_worlds.hh"

namespace pongsim::benchmark {
namespace {

constexpr double kMostRatio = 1.5, kLeastFactor = 5, kMostShare = 0.02;
constexpr double kLeastFilmFactor = 5, kLeastRgbdFactor = 1.5, kMostOfTwo = 1.8;
// beams of the tutorial's lidar
constexpr int kBeams = 640;
constexpr double kWidth = 1.396263, kFarthest = 10;
constexpr int kBoxes = 200, kStepsAScan = 100;

std::string textOf(const std::filesystem::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::string replaced(std::string text, const std::string& from, const std::string& to, std::size_t start = 0) {
  const std::size_t at = text.find(from, start);
  if (at == std::string::npos) throw std::runtime_error("no '" + from + "' in the world");
  return text.replace(at, from.size(), to);
}

/// The tutorial's world with nothing moving, and a scan in each step.
std::string tutorial() {
  const auto worlds = test::fortressWorlds();
  if (!worlds) return {};
  std::string text = textOf(*worlds / "tutorials/sensor_tutorial.sdf");
  text = replaced(text, "<update_rate>10</update_rate>", "", text.find("<topic>lidar</topic>"));
  // replace the pose by that at rest
  text = replaced(text, "<pose relative_to='world'>0 0 1 0 0 0</pose>", "");
  return replaced(text, "ignition-gazebo-physics-system", "ignition-gazebo-user-commands-system");
}

std::unique_ptr<Simulation> load(const std::string& text) {
  Diagnostics diagnostics;
  auto simulation = Simulation::fromText(text, "world.sdf", {}, diagnostics);
  if (!simulation) throw std::runtime_error(format(diagnostics.all().front()));
  return simulation;
}

/// A running world, with or without a subscriber to its lidar.
struct Run {
  explicit Run(const std::string& text, const std::string& topic = "", const char* type = "ignition.msgs.LaserScan")
      : simulation(load(text)) {
    if (!topic.empty()) read(topic, type);
  }
  void read(const std::string& topic, const char* type) {
    readers.push_back(simulation->transport().node().subscribe(topic, type, [this](const Message&) { ++received; }));
  }
  std::unique_ptr<Simulation> simulation;
  std::size_t received = 0;
  std::vector<Subscription> readers;
};

void step(::benchmark::State& state, const std::string& text, const std::string& topic) {
  Run run(text, topic);
  run.simulation->step(100);
  for (auto _ : state) run.simulation->step();
  if (!run.readers.empty() && run.received == 0) throw std::runtime_error("nobody speaks on " + topic);
}

void castBare(::benchmark::State& state, const std::string& text) {
  Diagnostics diagnostics;
  const sdf::Root root = sdf::loadText(text, "world.sdf", diagnostics);
  const BareEmbree embree(root.worlds.front());
  // the lidar's position on the chassis
  const Vector3 origin(1.3, 0, 0.9);
  std::vector<Vector3> directions;
  for (int i = 0; i < kBeams; ++i) {
    const double angle = -kWidth + 2 * kWidth * i / (kBeams - 1);
    directions.emplace_back(std::cos(angle), std::sin(angle), 0);
  }
  std::vector<float> ranges(kBeams);
  for (auto _ : state) {
    embree.cast(origin, directions, kFarthest, ranges);
    ::benchmark::DoNotOptimize(ranges.data());
  }
  state.counters["triangles"] = static_cast<double>(embree.size());
}

/// Boxes that fly about in a room, and a lidar of 16 rows of 1,800 beams at 10 Hz among them.
std::string movingBoxes() {
  std::mt19937 random(1);
  const auto between = [&random](double least, double most) {
    return std::to_string(std::uniform_real_distribution(least, most)(random)) + ' ';
  };
  std::string text = R"(<sdf version="1.9"><world name="w"><gravity>0 0 0</gravity>
    <plugin filename="ignition-gazebo-physics-system" name="ignition::gazebo::systems::Physics"/>
    <plugin filename="ignition-gazebo-sensors-system" name="ignition::gazebo::systems::Sensors"/>
    <model name="mast"><static>true</static><link name="l"><sensor name="s" type="gpu_lidar"><topic>lidar</topic>
      <update_rate>10</update_rate><lidar><scan>
        <horizontal><samples>1800</samples><min_angle>-3.14159</min_angle><max_angle>3.13810</max_angle></horizontal>
        <vertical><samples>16</samples><min_angle>-0.26</min_angle><max_angle>0.26</max_angle></vertical>
      </scan><range><min>0.1</min><max>100</max></range></lidar></sensor></link></model>)";
  for (int i = 0; i < kBoxes; ++i) {
    const std::string size = "<geometry><box><size>1 1 1</size></box></geometry>";
    text += "<model name='b" + std::to_string(i) + "'><pose>" + between(-40, 40) + between(-40, 40) + between(-8, 8) +
            "0 0 0</pose><link name='l'><inertial><mass>1</mass></inertial><collision name='c'>" + size +
            "</collision><visual name='v'>" + size + "</visual></link></model>";
  }
  return text + "</world></sdf>";
}

/// Measures the simulated time between two scans.
void fly(::benchmark::State& state, const std::string& text, const std::string& topic) {
  Run run(text, topic);
  std::mt19937 random(2);
  std::uniform_real_distribution<double> velocity(-1, 1);
  const auto any = [&] { return Vector3(velocity(random), velocity(random), velocity(random)); };
  for (Model model : run.simulation->world().models()) {
    if (!model.isStatic()) model.setVelocity(any(), any());
  }
  run.simulation->step(10);
  for (auto _ : state) run.simulation->step(kStepsAScan);
  if (!run.readers.empty() && run.received == 0) throw std::runtime_error("nobody speaks on " + topic);
}

std::string camera(const std::string& topic, const std::string& type, const std::string& size) {
  return "<sensor name='" + topic + "' type='" + type + "'><pose>1.02 0 0.2 0 0.05 0.1</pose><topic>" + topic +
         "</topic><update_rate>30</update_rate><camera><horizontal_fov>1.2</horizontal_fov><image>" + size +
         "</image><clip><near>0.02</near><far>100</far></clip></camera></sensor>";
}

/// The court, seen by two cameras of 320 by 240 pixels and an RGB-D camera of 640 by 480, at 30 Hz: three images per
/// hundred steps of each that is read.
std::string filmedCourt() {
  const std::string text = textOf(test::projectFolder() / "worlds/pong_lidar.sdf");
  const std::string cameras = camera("one", "camera", "<width>320</width><height>240</height>") +
                              camera("two", "camera", "<width>320</width><height>240</height>") +
                              camera("rgbd", "rgbd_camera", "<width>640</width><height>480</height>");
  return replaced(text, "<sensor name=\"imu\"", cameras + "<sensor name=\"imu\"");
}

/// @param topics Of images, which are read.
void film(::benchmark::State& state, const std::string& text, const std::vector<std::string>& topics) {
  Run run(text);
  for (const std::string& topic : topics) run.read(topic, "ignition.msgs.Image");
  run.simulation->step(kStepsAScan);
  run.received = 0;
  for (auto _ : state) run.simulation->step(kStepsAScan);
  if (run.received < topics.size()) throw std::runtime_error("nobody speaks on " + topics.back());
}

/// @return What the robot of the court sees, with this many pixels in a row.
PictureView courtView(std::uint32_t width) {
  PictureView view;
  view.X_WorldEye = {{1.52, 0, 0.6}, fromRollPitchYaw(0, 0.05, 0.1)};
  view.width = width;
  view.height = width * 3 / 4;
  view.cx = view.width / 2.0;
  view.cy = view.height / 2.0;
  view.fx = view.fy = view.cx / std::tan(0.6);
  view.near = 0.02;
  return view;
}

/// The picture alone, as cameras draw it.
void rasterize(::benchmark::State& state, std::uint32_t width) {
  const auto simulation = load(textOf(test::projectFolder() / "worlds/pong_lidar.sdf"));
  CameraScene scene(simulation->world());
  Diagnostics diagnostics;
  scene.rebuild(diagnostics);
  PictureView view = courtView(width);
  std::vector<std::uint8_t> pixels(std::size_t{3} * view.width * view.height);
  scene.drawColors(view, pixels);
  for (auto _ : state) {
    simulation->step();
    scene.update();
    scene.drawColors(view, pixels);
  }
}

/// The same with bare Embree, with nothing moving.
void trace(::benchmark::State& state, std::uint32_t width) {
  Diagnostics diagnostics;
  const sdf::Root root =
      sdf::loadText(textOf(test::projectFolder() / "worlds/pong_lidar.sdf"), "world.sdf", diagnostics);
  const BareEmbree embree(root.worlds.front());
  const PictureView view = courtView(width);
  const Vector3 light = Vector3(0.5, -0.1, 0.9).normalized();
  std::vector<std::uint8_t> pixels(std::size_t{3} * view.width * view.height);
  for (auto _ : state) embree.draw(view, light, pixels);
}

/// The court, with lidars and cameras in turn on the robot.
/// @param moves If false, a step consists of the systems alone, whose cost would vanish in the variation of the
/// physics.
std::string court(int count, bool moves) {
  std::string text = textOf(test::projectFolder() / "worlds/pong_world.sdf");
  std::string sensors;
  for (int i = 0; i < count; ++i) {
    if (i % 2 == 1) {
      sensors += "<sensor name='s" + std::to_string(i) +
                 "' type='camera'><update_rate>30</update_rate><camera><image><width>320</width><height>240</height>"
                 "</image></camera></sensor>";
      continue;
    }
    sensors += "<sensor name='s" + std::to_string(i) +
               "' type='gpu_lidar'><update_rate>10</update_rate><lidar><scan><horizontal><samples>640</samples>"
               "<min_angle>-1</min_angle><max_angle>1</max_angle></horizontal></scan>"
               "<range><min>0.1</min><max>20</max></range></lidar></sensor>";
  }
  text = replaced(text, "<link name=\"chassis\">", "<link name=\"chassis\">" + sensors);
  if (!moves) text = replaced(text, "ignition-gazebo-physics-system", "ignition-gazebo-user-commands-system");
  const std::string system =
      "<plugin filename='ignition-gazebo-sensors-system' name='ignition::gazebo::systems::Sensors'/>";
  return count == 0 ? text : replaced(text, "<light name=\"sun\"", system + "<light name=\"sun\"");
}

void printResults(const Medians& medians) {
  const double bare = medians.of("tutorial/bare_embree");
  const double scan = medians.of("tutorial/heard") - medians.of("tutorial/unheard");
  if (bare > 0 && medians.of("tutorial/heard") > 0 && medians.of("tutorial/unheard") > 0) {
    std::printf("\n%d beams of the tutorial: bare Embree %.1f us, a scan and its message %.1f us: %.2f times%s\n",
                kBeams, bare, scan, scan / bare, scan > kMostRatio * bare ? "  TOO MUCH" : "");
  }
  const double flown = medians.of("moving_boxes/heard"), unheard = medians.of("moving_boxes/unheard");
  if (flown > 0 && unheard > 0) {
    const double factor = kStepsAScan * 1e3 / flown;
    std::printf(
        "16 x 1,800 beams among %d moving boxes at 10 Hz: %.1f times real time%s, of which scans take %.0f %%\n",
        kBoxes, factor, factor < kLeastFactor ? "  TOO LITTLE" : "", 100 * (1 - unheard / flown));
  }
  const auto printFactor = [&medians](const char* what, const std::string& name, double least) {
    const double factor = kStepsAScan * 1e3 / medians.of(name);
    if (!std::isfinite(factor)) return;
    std::printf("%s at 30 Hz: %.1f times real time, if one core does all%s\n", what, factor,
                factor < least ? "  TOO LITTLE" : "");
  };
  printFactor("320 x 240 pixels", "court/filmed", kLeastFilmFactor);
  printFactor("640 x 480 pixels with depths", "court/filmed_rgbd", kLeastRgbdFactor);
  const double one = medians.of("court/filmed"), two = medians.of("court/filmed_twice");
  if (const double none = medians.of("court/unfilmed"); one > 0 && two > 0 && none > 0) {
    const double ratio = (two - none) / (one - none);
    std::printf("a picture of 320 x 240 pixels: %.2f ms; two cameras cost %.2f times one%s\n", (one - none) / 3e3,
                ratio, ratio > kMostOfTwo ? "  TOO MUCH" : "");
  }
  for (const char* size : {"320", "640"}) {
    const double drawn = medians.of("picture/" + std::string(size) + "/rasterized");
    const double traced = medians.of("picture/" + std::string(size) + "/traced");
    if (drawn <= 0 || traced <= 0) continue;
    std::printf("a picture of %s pixels in a row alone: %.2f ms, traced with bare Embree: %.2f ms\n", size, drawn / 1e3,
                traced / 1e3);
  }
  const double without = medians.of("court/no_sensors"), with = medians.of("court/ten_sensors");
  const double step = medians.of("court/physics");
  if (without > 0 && with > 0 && step > 0) {
    std::printf("ten lidars and cameras that nobody reads: %.3f us of a step of %.1f us, %.1f %%%s\n", with - without,
                step, 100 * (with - without) / step, with - without > kMostShare * step ? "  TOO MUCH" : "");
  }
}

int run(int argc, char** argv) {
  const auto add = [](const std::string& name, auto function, auto... arguments) {
    ::benchmark::RegisterBenchmark(name.c_str(), function, arguments...)->Unit(::benchmark::kMicrosecond);
  };
  if (const std::string text = tutorial(); !text.empty()) {
    add("tutorial/bare_embree", castBare, text);
    add("tutorial/unheard", step, text, std::string());
    add("tutorial/heard", step, text, std::string("/lidar"));
  } else {
    std::printf("no worlds of Fortress here: the tutorial is left out\n");
  }
  const std::string boxes = movingBoxes();
  add("moving_boxes/unheard", fly, boxes, std::string());
  add("moving_boxes/heard", fly, boxes, std::string("/lidar"));
  // rendering uses other threads, so the time of the whole process counts
  using Topics = std::vector<std::string>;
  for (const auto& [name, topics] : {std::pair("court/unfilmed", Topics{}), std::pair("court/filmed", Topics{"/one"}),
                                     std::pair("court/filmed_twice", Topics{"/one", "/two"}),
                                     std::pair("court/filmed_rgbd", Topics{"/rgbd/image", "/rgbd/depth_image"})}) {
    ::benchmark::RegisterBenchmark(name, film, filmedCourt(), topics)
        ->Unit(::benchmark::kMicrosecond)
        ->MeasureProcessCPUTime();
  }
  for (const std::uint32_t width : {320U, 640U}) {
    const std::string name = "picture/" + std::to_string(width);
    ::benchmark::RegisterBenchmark((name + "/rasterized").c_str(), rasterize, width)
        ->Unit(::benchmark::kMicrosecond)
        ->MeasureProcessCPUTime();
    add(name + "/traced", trace, width);
  }
  add("court/physics", step, court(0, true), std::string());
  add("court/no_sensors", step, court(0, false), std::string());
  add("court/ten_sensors", step, court(10, false), std::string());
  Medians medians;
  if (!medians.run(argc, argv)) return 2;
  printResults(medians);
  return 0;
}

}  // namespace
}  // namespace pongsim::benchmark

int main(int argc, char** argv) { return pongsim::benchmark::run(argc, argv); }
