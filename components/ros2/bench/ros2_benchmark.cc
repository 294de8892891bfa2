// Measures messages to and from ROS, compared with bare Fast DDS, and their cost in the simulation.
//   pongsim_ros2_bench                       runs everything
//   pongsim_ros2_bench ways                  measures the latency of messages; steps: the cost of steps
//   pongsim_ros2_bench write KIND WAY        the other process: writes messages of a kind, stamped
//   pongsim_ros2_bench read KIND WAY         receives them, and prints the median age [us]
//   pongsim_ros2_bench listen                runs five readers of the world's sensors, until it is killed

#include <ignition/msgs/image.pb.h>
#include <ignition/msgs/laserscan.pb.h>
#include <ignition/msgs/twist.pb.h>
#include <time.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "pongsim/simulation.hh"
#include "ros2/bench/bare_pair.hh"
#include "ros2/bridge/bridge.hh"
#include "ros2/types/cdr.hh"
#include "ros2/types/geometry_msgs.hh"
#include "ros2/types/sensor_msgs.hh"
#include "support/message_ages.hh"
#include "support/process.hh"
#include "support/test_domain.hh"

namespace pongsim::ros2 {
namespace {

using Clock = std::chrono::steady_clock;
using test::callAtRate;
using test::median;
using test::MessageAges;
using test::Process;
using test::secondsNow;
using test::waitFor;
using Transports = BarePeer::Transports;

struct Kind {
  const char* name;
  const char* topic;
  const char* type;
  double rate;
  int count;
};
constexpr Kind kKinds[] = {{"Twist", "/measured_twist", "geometry_msgs/msg/Twist", 500, 1500},
                           {"LaserScan", "/measured_scan", "sensor_msgs/msg/LaserScan", 100, 500},
                           {"Image", "/measured_image", "sensor_msgs/msg/Image", 30, 150}};
enum { kTwist, kScan, kImage };
constexpr int kRounds = 5;
constexpr int kBeams = 640;
constexpr unsigned kWidth = 640, kHeight = 480;

/// @return Age of a payload [us]: a Twist has its time in its first number, other types in the stamp of their header.
double age(int kind, std::span<const std::byte> payload) {
  if (kind == kTwist) {
    double at = 0;
    std::memcpy(&at, &payload[kEncapsulation], sizeof at);
    return (secondsNow() - at) * 1e6;
  }
  builtin_interfaces::Time at;
  std::memcpy(&at.sec, &payload[kEncapsulation], 4);
  std::memcpy(&at.nanosec, &payload[kEncapsulation + 4], 4);
  return (secondsNow() - at.sec - at.nanosec * 1e-9) * 1e6;
}

builtin_interfaces::Time stamp() {
  const double at = secondsNow();
  return {static_cast<std::int32_t>(at), static_cast<std::uint32_t>((at - static_cast<std::int32_t>(at)) * 1e9)};
}

sensor_msgs::LaserScan rosScan() {
  sensor_msgs::LaserScan scan;
  scan.header.frame_id = "rover/chassis/lidar";
  scan.ranges.assign(kBeams, 1.5F);
  scan.intensities.assign(kBeams, 0);
  return scan;
}

sensor_msgs::Image rosImage() {
  sensor_msgs::Image image;
  image.header.frame_id = "rover/chassis/camera";
  image.width = kWidth;
  image.height = kHeight;
  image.step = 3 * kWidth;
  image.encoding = "rgb8";
  image.data.assign(std::size_t{3} * kWidth * kHeight, 'x');
  return image;
}

/// Writes messages of a kind with bare Fast DDS, directly into its payload.
void writeBare(BarePeer& peer, int number) {
  const Kind& kind = kKinds[number];
  peer.openWriter(topicOnWire(kind.topic), ddsTypeName(kind.type));
  waitFor([&] { return peer.matched() > 0; });
  geometry_msgs::Twist twist;
  sensor_msgs::LaserScan scan = rosScan();
  sensor_msgs::Image image = rosImage();
  std::vector<std::byte> payload(number == kTwist ? cdrSize(twist) : number == kScan ? cdrSize(scan) : cdrSize(image));
  callAtRate(kind.count, kind.rate, [&] {
    if (number == kTwist) {
      twist.linear.x = secondsNow();
      writeCdr(twist, payload);
    } else if (number == kScan) {
      scan.header.stamp = stamp();
      writeCdr(scan, payload);
    } else {
      image.header.stamp = stamp();
      writeCdr(image, payload);
    }
    peer.write(payload);
  });
}

Transports transportsNamed(const std::string& name) { return name == "udp" ? Transports::kUdp : Transports::kDefault; }

int writeProcess(int domain, int kind, Transports transports) {
  BarePeer peer(domain, transports);
  writeBare(peer, kind);
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  return 0;
}

int readProcess(int domain, int number, Transports transports) {
  const Kind& kind = kKinds[number];
  BarePeer peer(domain, transports);
  MessageAges ages;
  peer.read(topicOnWire(kind.topic), ddsTypeName(kind.type),
            [&](std::span<const std::byte> payload) { ages.add(age(number, payload)); });
  waitFor([&] { return peer.matched() > 0; });
  std::puts("ready");
  std::fflush(stdout);
  const std::vector<double> all = ages.wait(kind.count);
  std::printf("%zu %f\n", all.size(), median(all));
  return 0;
}

std::string own() { return "/proc/self/exe"; }

/// @return The median age reported by a reading process.
double toldBy(Process& reader) {
  if (reader.wait() != 0) std::fprintf(stderr, "a reader failed: %s\n", reader.error().c_str());
  std::size_t count = 0;
  double result = 0;
  const std::string output = reader.output();
  std::sscanf(output.c_str() + output.find('\n') + 1, "%zu %lf", &count, &result);
  return result;
}

double bareToReader(int domain, int kind, const std::string& way) {
  Process reader({own(), "read", std::to_string(kind), way});
  BarePeer writer(domain, transportsNamed(way));
  writeBare(writer, kind);
  return toldBy(reader);
}

double bareFromWriter(int domain, int kind, const std::string& way) {
  MessageAges ages;
  BarePeer reader(domain, transportsNamed(way));
  reader.read(topicOnWire(kKinds[kind].topic), ddsTypeName(kKinds[kind].type),
              [&](std::span<const std::byte> payload) { ages.add(age(kind, payload)); });
  Process writer({own(), "write", std::to_string(kind), way});
  return median(ages.wait(kKinds[kind].count));
}

/// A transport of the simulation with the bridge, without a world.
struct Bridged {
  explicit Bridged(int domain)
      : transport({.network = false}),
        participant({.domain = domain}),
        ros(participant, {}),
        bridge(transport.node(), ros, Settings()) {}
  Transport transport;
  Participant participant;
  RosNode ros;
  Bridge bridge;
};

double twistIn(int domain) {
  Bridged bridged(domain);
  MessageAges ages;
  const Subscription heard = bridged.transport.node().subscribeAtOnce(
      kKinds[kTwist].topic, "ignition.msgs.Twist", [&](const Message& message, const Bulk*) {
        ages.add((secondsNow() - static_cast<const ignition::msgs::Twist&>(message).linear().x()) * 1e6);
      });
  bridged.bridge.update();
  Process writer({own(), "write", std::to_string(kTwist), "udp"});
  return median(ages.wait(kKinds[kTwist].count));
}

double scanOut(int domain) {
  Bridged bridged(domain);
  ignition::msgs::LaserScan scan;
  scan.set_frame("rover::chassis::lidar");
  scan.set_count(kBeams);
  for (int i = 0; i < kBeams; ++i) {
    scan.add_ranges(1.5);
    scan.add_intensities(0);
  }
  Publisher publisher = bridged.transport.node().advertise<ignition::msgs::LaserScan>(kKinds[kScan].topic);
  bridged.bridge.update();
  Process reader({own(), "read", std::to_string(kScan), "udp"});
  waitFor([&] {
    bridged.bridge.update();
    return publisher.hasSubscribers();
  });
  reader.waitForOutput("ready");
  callAtRate(kKinds[kScan].count, kKinds[kScan].rate, [&] {
    const builtin_interfaces::Time at = stamp();
    scan.mutable_header()->mutable_stamp()->set_sec(at.sec);
    scan.mutable_header()->mutable_stamp()->set_nsec(static_cast<int>(at.nanosec));
    publisher.publish(scan);
  });
  return toldBy(reader);
}

/// @param copies How often an image's bytes were copied on the way to the wire.
double imageOut(int domain, double& copies) {
  Bridged bridged(domain);
  const std::string pixels(std::size_t{3} * kWidth * kHeight, 'x');
  ignition::msgs::Image image;
  image.set_width(kWidth);
  image.set_height(kHeight);
  image.set_pixel_format_type(ignition::msgs::RGB_INT8);
  int written = 0;
  const Bulk bulk{.size = pixels.size(), .write = [&](std::span<std::byte> to) {
                    ++written;
                    std::memcpy(to.data(), pixels.data(), to.size());
                  }};
  Publisher publisher = bridged.transport.node().advertise<ignition::msgs::Image>(kKinds[kImage].topic);
  bridged.bridge.update();
  Process reader({own(), "read", std::to_string(kImage), "udp"});
  waitFor([&] {
    bridged.bridge.update();
    return publisher.hasSubscribers();
  });
  reader.waitForOutput("ready");
  callAtRate(kKinds[kImage].count, kKinds[kImage].rate, [&] {
    const builtin_interfaces::Time at = stamp();
    image.mutable_header()->mutable_stamp()->set_sec(at.sec);
    image.mutable_header()->mutable_stamp()->set_nsec(static_cast<int>(at.nanosec));
    publisher.publish(image, bulk);
  });
  copies = static_cast<double>(written) / kKinds[kImage].count;
  return toldBy(reader);
}

constexpr const char* kWorld = R"(<?xml version="1.0"?>
<sdf version="1.9"><world name="bench">
  <physics name="p" type="ignored"><max_step_size>0.001</max_step_size><real_time_factor>0</real_time_factor></physics>
  <plugin filename="ignition-gazebo-physics-system" name="ignition::gazebo::systems::Physics"/>
  <plugin filename="ignition-gazebo-sensors-system" name="ignition::gazebo::systems::Sensors"/>
  <plugin filename="ignition-gazebo-imu-system" name="ignition::gazebo::systems::Imu"/>
  <light type="directional" name="sun"><pose>0 0 10 0 0 0</pose><direction>-0.5 0.1 -0.9</direction></light>
  <model name="wall"><static>true</static><pose>5 0 1 0 0 0</pose><link name="l">
    <visual name="v"><geometry><box><size>0.2 20 2</size></box></geometry></visual></link></model>
  <model name="rover"><pose>0 0 1 0 0 0</pose><static>true</static><link name="l">
    <sensor name="lidar" type="gpu_lidar"><topic>lidar</topic><update_rate>10</update_rate><lidar>
      <scan><horizontal><samples>640</samples><min_angle>-1.4</min_angle><max_angle>1.4</max_angle></horizontal></scan>
      <range><min>0.1</min><max>10</max></range></lidar></sensor>
    <sensor name="camera" type="camera"><topic>camera</topic><update_rate>30</update_rate><camera>
      <image><width>640</width><height>480</height><format>R8G8B8</format></image></camera></sensor>
    <sensor name="imu" type="imu"><topic>imu</topic><update_rate>100</update_rate></sensor>
  </link></model>
</world></sdf>)";

double cpuSeconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec) * 1e-9;
}

std::unique_ptr<Simulation> load(bool withRos) {
  SimulationOptions options;
  if (withRos) {
    Element plugin;
    plugin.name = "plugin";
    plugin.attributes = {{"filename", "pongsim-ros2-system", {}}, {"name", "pongsim::systems::Ros2", {}}};
    options.systems.push_back(plugin);
  }
  Diagnostics diagnostics;
  auto simulation = Simulation::fromText(kWorld, "bench.sdf", options, diagnostics);
  for (const Diagnostic& each : diagnostics.all()) std::fprintf(stderr, "%s\n", format(each).c_str());
  if (!simulation) std::exit(1);
  return simulation;
}

/// Switches from a test's domain to an empty one.
constexpr int kOtherDomain = 100;
std::atomic<bool> isOver = false;

int listenProcess(int domain) {
  // stopped cleanly, so that it is removed from the graph at once
  std::signal(SIGTERM, [](int) { isOver = true; });
  BarePeer peer(domain, Transports::kUdp);
  std::atomic<int> heard[3] = {};
  const std::pair<const char*, const char*> ways[] = {
      {"/lidar", "sensor_msgs/msg/LaserScan"}, {"/camera", "sensor_msgs/msg/Image"}, {"/imu", "sensor_msgs/msg/Imu"}};
  for (std::size_t i = 0; i < 3; ++i) {
    peer.read(topicOnWire(ways[i].first), ddsTypeName(ways[i].second),
              [&heard, i](std::span<const std::byte>) { ++heard[i]; });
  }
  waitFor([&] { return isOver || (heard[0] > 0 && heard[1] > 0 && heard[2] > 0); });
  std::puts("ready");
  std::fflush(stdout);
  waitFor([] { return isOver.load(); });
  return 0;
}

constexpr std::uint64_t kQuietSteps = 5000;
/// A slice has three images, ten IMU readings and one scan.
constexpr std::uint64_t kSliceSteps = 100;
constexpr int kSlices = 100;

double costOf(Simulation& simulation, std::uint64_t steps) {
  const double before = cpuSeconds();
  simulation.step(steps);
  return cpuSeconds() - before;
}

/// A world whose sensors have subscribers: ROS nodes, or subscribers in the simulation that receive everything.
struct MeasuredWorld {
  explicit MeasuredWorld(bool isHeardInside) : simulation(load(true)) {
    if (isHeardInside) {
      Node node = simulation->transport().node();
      kept.push_back(node.subscribeAtOnce("/lidar", "ignition.msgs.LaserScan", [](const Message&, const Bulk*) {}));
      kept.push_back(node.subscribeAtOnce("/imu", "ignition.msgs.IMU", [](const Message&, const Bulk*) {}));
      kept.push_back(node.subscribeAtOnce("/camera", "ignition.msgs.Image", [this](const Message&, const Bulk* bulk) {
        picture.resize(bulk->size);
        bulk->write(picture);
      }));
    }
    simulation->step(500);
  }
  std::unique_ptr<Simulation> simulation;
  std::vector<std::byte> picture;
  std::vector<Subscription> kept;
};

struct ReadersCost {
  /// Cost of a step in the simulation's thread without readers and with them [us].
  double without = 0;
  double with = 0;
  /// With readers, the median of pairs of adjacent slices.
  double share = 0;
};

/// @return The processor time that five nodes subscribed to lidar, camera and IMU add to the simulation's thread. Two
/// worlds, one of them with the readers, take turns in slices; a slice begins when everything that the other has sent
/// has arrived.
ReadersCost costOfReaders() {
  const MeasuredWorld read(false);
  std::vector<std::unique_ptr<Process>> readers;
  for (int j = 0; j < 5; ++j) readers.push_back(std::make_unique<Process>(std::vector<std::string>{own(), "listen"}));
  // until each of the five has received something from each of the three
  waitFor([&] {
    read.simulation->step(20);
    return std::ranges::all_of(readers, [](const auto& each) { return each->output().starts_with("ready"); });
  });
  setenv("ROS_DOMAIN_ID", std::to_string(test::testDomain() + kOtherDomain).c_str(), 1);
  const MeasuredWorld unread(true);
  std::vector<double> without, with, shares;
  for (int i = 0; i < kSlices; ++i) {
    without.push_back(costOf(*unread.simulation, kSliceSteps) / kSliceSteps * 1e6);
    with.push_back(costOf(*read.simulation, kSliceSteps) / kSliceSteps * 1e6);
    shares.push_back(with.back() / without.back() - 1);
    std::this_thread::sleep_for(std::chrono::milliseconds(30));
  }
  for (const auto& reader : readers) reader->kill(SIGTERM);
  return {median(without), median(with), median(shares)};
}

/// @return Cost of the system per step without subscribers [us].
double costUnheard() {
  const auto plain = load(false), withRos = load(true);
  plain->step(500);
  withRos->step(500);
  std::vector<double> difference;
  for (int i = 0; i < 3 * kRounds; ++i) {
    const double base = costOf(*plain, kQuietSteps);
    difference.push_back((costOf(*withRos, kQuietSteps) - base) / kQuietSteps * 1e6);
  }
  return median(difference);
}

void tell(const char* what, const std::function<double()>& ours, const std::function<double()>& udp,
          const std::function<double()>& shared, double most) {
  std::vector<double> a, b, c;
  for (int i = 0; i < kRounds; ++i) {
    a.push_back(ours());
    b.push_back(udp());
    c.push_back(shared());
  }
  std::printf(
      "%-22s %7.0f us, bare Fast DDS by UDP %7.0f us: ratio %.2f (at most %.2f); by shared memory %7.0f us: %.2f\n",
      what, median(a), median(b), median(a) / median(b), most, median(c), median(a) / median(c));
  std::fflush(stdout);
}

void measureWays(int domain) {
  double copies = 0;
  tell(
      "Twist in", [=] { return twistIn(domain); }, [=] { return bareFromWriter(domain, kTwist, "udp"); },
      [=] { return bareFromWriter(domain, kTwist, "default"); }, 1.3);
  tell(
      "LaserScan out", [=] { return scanOut(domain); }, [=] { return bareToReader(domain, kScan, "udp"); },
      [=] { return bareToReader(domain, kScan, "default"); }, 1.3);
  tell(
      "VGA image out, 30 Hz", [&] { return imageOut(domain, copies); },
      [=] { return bareToReader(domain, kImage, "udp"); }, [=] { return bareToReader(domain, kImage, "default"); },
      1.2);
  std::printf("copies of a picture on its way to the wire: %.2f\n", copies);
  std::fflush(stdout);
}

void measureSteps() {
  std::printf("no readers: %.3f us a step (at most 1)\n", costUnheard());
  std::fflush(stdout);
  const ReadersCost cost = costOfReaders();
  std::printf(
      "five nodes that read lidar, camera and IMU: %+.1f %% of the thread's time (at most 5): %.1f us a step, "
      "%.1f without them\n",
      100 * cost.share, cost.with, cost.without);
}

}  // namespace
}  // namespace pongsim::ros2

int main(int argc, char** argv) {
  using namespace pongsim::ros2;
  const std::string what = argc > 1 ? argv[1] : "";
  if (what.empty() || what == "ways" || what == "steps") {
    const int domain = pongsim::test::testDomain();
    setenv("ROS_DOMAIN_ID", std::to_string(domain).c_str(), 1);
    if (what != "steps") measureWays(domain);
    if (what != "ways") measureSteps();
    return 0;
  }
  const int domain = std::atoi(std::getenv("ROS_DOMAIN_ID"));
  if (what == "listen") return listenProcess(domain);
  if (argc < 4) return 2;
  const auto run = what == "write" ? writeProcess : readProcess;
  return run(domain, std::atoi(argv[2]), transportsNamed(argv[3]));
}
