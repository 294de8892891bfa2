// Measures the cost of recording in the simulation's thread, compared with the same run without, the size of the files,
// and the cost per message of recording topics, unchanged and as ROS messages.
#include <ignition/msgs/image.pb.h>
#include <ignition/msgs/laserscan.pb.h>
#include <ignition/msgs/odometry.pb.h>
#include <ignition/msgs/twist.pb.h>
#include <time.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "log/mcap/encoded_writer.hh"
#include "log/mcap/mcap_writer.hh"
#include "pongsim/log.hh"
#include "pongsim/simulation.hh"
#include "support/temp_folder.hh"

namespace {

using namespace pongsim;

constexpr int kRobots = 10, kSteps = 2000, kRuns = 7;

std::string robot(int number) {
  const auto link = [](const std::string& name, const std::string& pose, const std::string& shape) {
    return "<link name='" + name + "'><pose>" + pose +
           "</pose><inertial><mass>1</mass><inertia><ixx>0.1</ixx><iyy>0.1</iyy>"
           "<izz>0.1</izz></inertia></inertial><collision name='c'><geometry>" +
           shape + "</geometry></collision><visual name='v'><geometry>" + shape + "</geometry></visual></link>";
  };
  const std::string wheel = "<cylinder><radius>0.2</radius><length>0.1</length></cylinder>";
  const auto joint = [](const std::string& name, const char* type) {
    return "<joint name='" + name + "_joint' type='" + type + "'><parent>chassis</parent><child>" + name +
           "</child><axis><xyz expressed_in='__model__'>0 1 0</xyz></axis></joint>";
  };
  const std::string name = "robot" + std::to_string(number);
  return "<model name='" + name + "'><pose>0 " + std::to_string(3 * number) + " 0.2 0 0 0</pose>" +
         link("chassis", "0 0 0.1 0 0 0", "<box><size>1 0.5 0.2</size></box>") +
         link("left", "0.3 0.35 0 1.5708 0 0", wheel) + link("right", "0.3 -0.35 0 1.5708 0 0", wheel) +
         link("caster", "-0.4 0 -0.1 0 0 0", "<sphere><radius>0.1</radius></sphere>") + joint("left", "revolute") +
         joint("right", "revolute") + joint("caster", "ball") +
         "<plugin filename='ignition-gazebo-diff-drive-system' name='ignition::gazebo::systems::DiffDrive'>"
         "<left_joint>left_joint</left_joint><right_joint>right_joint</right_joint><wheel_separation>0.7</"
         "wheel_separation>"
         "<wheel_radius>0.2</wheel_radius><topic>/cmd_vel</topic></plugin></model>";
}

std::string world(const std::string& record) {
  std::string text =
      "<sdf version='1.9'><world name='w'><plugin filename='ignition-gazebo-physics-system' "
      "name='ignition::gazebo::systems::Physics'/>" +
      record +
      "<model name='ground'><static>true</static><link name='l'><collision "
      "name='c'><geometry><plane/></geometry></collision>"
      "</link></model>";
  for (int i = 0; i < kRobots; ++i) text += robot(i);
  return text + "</world></sdf>";
}

/// @return Time of this thread alone [s].
double threadTime() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// @return Cost of a step in the simulation's thread [us].
double run(const std::filesystem::path& file) {
  Diagnostics diagnostics;
  const std::unique_ptr<Simulation> simulation = Simulation::fromFile(file, {}, diagnostics);
  for (const Diagnostic& each : diagnostics.all()) std::fprintf(stderr, "%s\n", format(each).c_str());
  Publisher drive = simulation->transport().node().advertise<ignition::msgs::Twist>("/cmd_vel");
  ignition::msgs::Twist twist;
  twist.mutable_linear()->set_x(0.5);
  twist.mutable_angular()->set_z(0.2);
  drive.publish(twist);
  simulation->step(500);
  const double start = threadTime();
  simulation->step(kSteps);
  return (threadTime() - start) / kSteps * 1e6;
}

double median(std::vector<double> values) {
  std::ranges::sort(values);
  return values[values.size() / 2];
}

std::vector<std::unique_ptr<Message>> someMessages() {
  auto odometry = std::make_unique<ignition::msgs::Odometry>();
  odometry->mutable_pose()->mutable_position()->set_x(1);
  auto scan = std::make_unique<ignition::msgs::LaserScan>();
  scan->set_count(640);
  for (int i = 0; i < 640; ++i) {
    scan->add_ranges(1 + 0.001 * i);
    scan->add_intensities(0);
  }
  auto image = std::make_unique<ignition::msgs::Image>();
  image->set_width(640);
  image->set_height(480);
  image->set_step(3 * 640);
  image->set_pixel_format_type(ignition::msgs::RGB_INT8);
  image->set_data(std::string(std::size_t{3} * 640 * 480, 'x'));
  std::vector<std::unique_ptr<Message>> messages;
  messages.push_back(std::move(odometry));
  messages.push_back(std::move(scan));
  messages.push_back(std::move(image));
  return messages;
}

/// @return Cost of a message in the thread that passes it to the writer [us].
double writing(log::Writer& writer, const Message& message) {
  constexpr int kMessages = 300;
  const std::string bytes = message.SerializeAsString(), type = message.GetTypeName();
  const double start = threadTime();
  for (int i = 0; i < kMessages; ++i) writer.write({i, "/topic", type, bytes});
  const double time = threadTime() - start;
  writer.close();
  return time / kMessages * 1e6;
}

void measureWriting(const std::filesystem::path& file) {
  std::printf("a message, of the thread that records it to MCAP, medians of %d runs:\n", kRuns);
  for (const std::unique_ptr<Message>& message : someMessages()) {
    std::vector<double> plain, ros;
    for (int i = 0; i < kRuns; ++i) {
      log::McapWriter writer(file, {.overwrites = true},
                             [](std::string_view, std::string_view type) { return log::protobufDefinition(type); });
      plain.push_back(writing(writer, *message));
      Diagnostics diagnostics;
      std::unique_ptr<MessageEncoder> encoder = makeMessageEncoder("ros2", {}, diagnostics);
      for (const Diagnostic& each : diagnostics.all()) std::fprintf(stderr, "%s\n", format(each).c_str());
      if (!encoder) continue;
      log::EncodedWriter encoded(file, {.overwrites = true}, std::move(encoder), [](const std::string&) {});
      ros.push_back(writing(encoded, *message));
    }
    std::printf("  %-24s %8.1f us\n", message->GetTypeName().c_str(), median(plain));
    if (!ros.empty()) std::printf("    as one of ROS          %8.1f us\n", median(ros));
  }
}

}  // namespace

int main() {
  setLogLevel(LogLevel::kNone);
  const test::TempFolder folder;
  const std::filesystem::path recording = folder.path() / "rec";
  const std::filesystem::path plain = folder.write("plain.sdf", world(""));
  const std::filesystem::path recorded = folder.write(
      "recorded.sdf", world("<plugin filename='ignition-gazebo-log-system' name='ignition::gazebo::systems::LogRecord'>"
                            "<record_path>" +
                            recording.string() + "</record_path></plugin>"));
  std::vector<double> without, with;
  for (int i = 0; i < kRuns; ++i) {
    without.push_back(run(plain));
    with.push_back(run(recorded));
  }
  const double bytes = static_cast<double>(std::filesystem::file_size(recording / "state.tlog")) / (kSteps + 500);
  std::printf("a step of %d robots, of the simulation's thread, medians of %d runs:\n", kRobots, kRuns);
  std::printf("  without a recording  %7.2f us\n", median(without));
  std::printf("  recorded             %7.2f us: %.3f times\n", median(with), median(with) / median(without));
  std::printf("  its file             %7.0f bytes a step\n", bytes);
  measureWriting(folder.path() / "a.mcap");
  return 0;
}
