// Runs worlds, and prints for each a hash of its state and of all messages of its systems, so that tests can compare
// processes: world_hashes THREADS STEPS WORLD...
//
// Each topic that a system subscribes to gets two messages: one at the start, in which every number is 0.5, and one
// halfway with -0.5. So every drive moves in all its directions.

#include <google/protobuf/message.h>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <deque>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "pongsim/log.hh"
#include "pongsim/message.hh"
#include "pongsim/node.hh"
#include "pongsim/simulation.hh"
#include "support/working_folder.hh"

namespace pongsim::test {
namespace {

using google::protobuf::FieldDescriptor;
using google::protobuf::Reflection;

// length of the lists in commands: at least the number of rotors or joints
constexpr int kListLength = 8;

void fill(google::protobuf::Message& message, double number);

void fillField(google::protobuf::Message& message, const FieldDescriptor& field, double number) {
  const Reflection& reflection = *message.GetReflection();
  const auto set = [&](auto setOne, auto addOne, auto value) {
    if (!field.is_repeated()) return (reflection.*setOne)(&message, &field, value);
    for (int i = 0; i < kListLength; ++i) (reflection.*addOne)(&message, &field, value);
  };
  switch (field.cpp_type()) {
    case FieldDescriptor::CPPTYPE_DOUBLE:
      return set(&Reflection::SetDouble, &Reflection::AddDouble, number);
    case FieldDescriptor::CPPTYPE_FLOAT:
      return set(&Reflection::SetFloat, &Reflection::AddFloat, static_cast<float>(number));
    case FieldDescriptor::CPPTYPE_INT32:
      return set(&Reflection::SetInt32, &Reflection::AddInt32, 1);
    case FieldDescriptor::CPPTYPE_BOOL:
      return set(&Reflection::SetBool, &Reflection::AddBool, true);
    case FieldDescriptor::CPPTYPE_MESSAGE:
      // headers differ between processes
      if (!field.is_repeated() && field.name() != "header") fill(*reflection.MutableMessage(&message, &field), number);
      return;
    default:
      return;
  }
}

void fill(google::protobuf::Message& message, double number) {
  const google::protobuf::Descriptor& type = *message.GetDescriptor();
  for (int i = 0; i < type.field_count(); ++i) fillField(message, *type.field(i), number);
}

/// FNV-1a with 64 bits.
class Digest {
 public:
  void add(std::span<const std::byte> bytes) {
    for (const std::byte byte : bytes) value_ = (value_ ^ static_cast<std::uint8_t>(byte)) * 0x100000001b3ULL;
  }
  unsigned long long value() const { return value_; }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325ULL;
};

/// @return Whether everything published there is reproducible. Images depend on Mesa and the processor; statistics,
/// scene messages of a paused world and sensors' performance metrics follow wall time.
bool repeats(const OwnTopic& topic) {
  const bool isTiming = topic.type == "ignition.msgs.PerformanceSensorMetrics";
  const bool isPicture = topic.type == "ignition.msgs.Image" || topic.type == "ignition.msgs.PointCloudPacked";
  const bool isOfScene = topic.name.starts_with("/world/") && topic.name.find("/model/") == std::string::npos;
  return !isTiming && !isPicture && !isOfScene;
}

class DrivenWorld {
 public:
  explicit DrivenWorld(Simulation& simulation) : simulation_(simulation), node_(simulation.transport().node()) {
    for (const OwnTopic& topic : node_.ownTopics()) {
      if (topic.publishers > 0 && repeats(topic)) listen(topic);
      if (topic.subscriptions > 0 && topic.publishers == 0 && newMessage(topic.type)) heard_.push_back(topic);
    }
  }

  void tell(double number) {
    for (const OwnTopic& topic : heard_) {
      const MessagePointer message = newMessage(topic.type);
      fill(*message, number);
      node_.advertise(topic.name, topic.type).publish(*message);
    }
  }

  std::string hashes() const {
    char text[64];
    std::snprintf(text, sizeof text, "%016llx %016llx", static_cast<unsigned long long>(simulation_.stateHash()),
                  published_.value());
    return text;
  }

 private:
  void listen(const OwnTopic& topic) {
    const auto heard = [this](std::size_t size, const std::function<void(std::span<std::byte>)>& write) {
      bytes_.resize(size);
      write(bytes_);
      published_.add(bytes_);
    };
    subscriptions_.push_back(node_.subscribeBytesAtOnce(topic.name, topic.type, heard));
  }

  Simulation& simulation_;
  Node node_;
  std::vector<OwnTopic> heard_;
  std::vector<std::byte> bytes_;
  Digest published_;
  std::deque<Subscription> subscriptions_;
};

void printHashes(const std::filesystem::path& file, int threads, std::uint64_t steps) {
  Diagnostics diagnostics;
  SimulationOptions options;
  options.threads = threads;
  for (const auto& simulation : Simulation::allFromFile(file, options, diagnostics)) {
    DrivenWorld world(*simulation);
    world.tell(0.5);
    simulation->step(steps / 2);
    world.tell(-0.5);
    simulation->step(steps - steps / 2);
    std::printf("%s %s %s\n", file.filename().c_str(), std::string(simulation->world().name()).c_str(),
                world.hashes().c_str());
    std::fflush(stdout);
  }
}

}  // namespace
}  // namespace pongsim::test

int main(int count, char** arguments) {
  if (count < 4) {
    std::fprintf(stderr, "world_hashes THREADS STEPS WORLD...\n");
    return 2;
  }
  pongsim::setLogLevel(pongsim::LogLevel::kNone);
  std::vector<std::filesystem::path> worlds;
  for (int i = 3; i < count; ++i) worlds.push_back(std::filesystem::absolute(arguments[i]));
  // some write into the current folder
  const pongsim::test::WorkingFolder folder;
  for (const std::filesystem::path& world : worlds) {
    pongsim::test::printHashes(world, std::atoi(arguments[1]), std::strtoull(arguments[2], nullptr, 10));
  }
  return 0;
}
