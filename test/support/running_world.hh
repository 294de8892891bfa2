#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <list>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "pongsim/message.hh"
#include "pongsim/simulation.hh"

namespace pongsim::test {

/// @return Content of a world for tests of systems that move a joint, without gravity: model "m", whose joint "hinge"
/// turns a link of 0.1 kg m^2 about z; the joint "hold" is fixed.
/// @param system As in filename and class: "joint-controller", "JointController".
inline std::string hingeWith(const std::string& system, const std::string& className, const std::string& parameters) {
  return R"(<gravity>0 0 0</gravity><model name="m">
    <link name="base"><inertial><mass>1</mass></inertial></link>
    <link name="arm"><inertial><mass>1</mass><inertia><ixx>0.1</ixx><iyy>0.1</iyy><izz>0.1</izz></inertia></inertial></link>
    <joint name="hold" type="fixed"><parent>world</parent><child>base</child></joint>
    <joint name="hinge" type="revolute"><parent>base</parent><child>arm</child><axis><xyz>0 0 1</xyz></axis></joint>
    <plugin filename="ignition-gazebo-)" +
         system + "-system\" name=\"ignition::gazebo::systems::" + className + "\">" + parameters + "</plugin></model>";
}

/// A world that a test steps and listens to. Errors and warnings about it fail the test.
class RunningWorld {
 public:
  /// @param content Content of the `<world>`, in addition to the physics. Its name is "w".
  explicit RunningWorld(const std::string& content) {
    Diagnostics diagnostics;
    simulation_ = Simulation::fromText(textOf(content), "world.sdf", {}, diagnostics);
    for (const Diagnostic& diagnostic : diagnostics.all()) ADD_FAILURE() << format(diagnostic);
  }
  /// A world of Fortress, which may have content that is not simulated.
  explicit RunningWorld(const std::filesystem::path& file) {
    Diagnostics diagnostics;
    simulation_ = Simulation::fromFile(file, {}, diagnostics);
    for (const Diagnostic& diagnostic : diagnostics.all()) {
      if (diagnostic.severity == Severity::kError) ADD_FAILURE() << format(diagnostic);
    }
  }

  static std::string textOf(const std::string& content) {
    return "<sdf version='1.9'><world name='w'><plugin filename='ignition-gazebo-physics-system' "
           "name='ignition::gazebo::systems::Physics'/>" +
           content + "</world></sdf>";
  }

  /// @return The messages about a world with this content.
  static std::vector<std::string> complaintsAbout(const std::string& content) {
    Diagnostics diagnostics;
    Simulation::fromText(textOf(content), "world.sdf", {}, diagnostics);
    std::vector<std::string> messages;
    for (const Diagnostic& diagnostic : diagnostics.all()) messages.push_back(diagnostic.message);
    return messages;
  }

  Simulation& simulation() { return *simulation_; }
  Model model(const std::string& name) { return simulation_->world().model(name).value(); }

  /// Puts all messages on the topic into `messages`, which must outlive it.
  template <class M>
  void listen(const std::string& topic, std::vector<M>& messages) {
    subscriptions_.push_back(simulation_->transport().node().subscribe<M>(
        topic, [&messages](const M& message) { messages.push_back(message); }));
  }

  /// Publishes a message. The topic's publisher is kept for later messages.
  template <class M>
  void tell(const std::string& topic, const M& message) {
    publishers_.push_back(simulation_->transport().node().advertise<M>(topic));
    publishers_.back().publish(message);
  }

  /// Like `tell`, with a message of this type in protobuf's text format.
  void tellText(const std::string& topic, const std::string& type, const std::string& text) {
    publishers_.push_back(simulation_->transport().node().advertise(topic, type));
    const MessagePointer message = newMessage(type);
    EXPECT_EQ(parseMessage(text, *message), std::nullopt) << text;
    publishers_.back().publish(*message);
  }

  /// Like `tell`, with an ignition.msgs.Double.
  void tellNumber(const std::string& topic, double value) {
    tellText(topic, "ignition.msgs.Double", "data: " + std::to_string(value));
  }

  /// Publishes commands with a huge, infinite or NaN number, each followed by some steps. Fails unless a warning says
  /// that they are refused.
  /// @param text Text of the message with '#' for the number: "linear {x: #}".
  /// @param largest The limit that the warning must give.
  void tellAbsurdities(const std::string& topic, const std::string& type, const std::string& text,
                       const std::string& largest = "1e+06") {
    testing::internal::CaptureStderr();
    for (const char* number : {"1e308", "-1e308", "2e9", "inf", "-inf", "nan"}) {
      std::string filled = text;
      filled.replace(filled.find('#'), 1, number);
      tellText(topic, type, filled);
      step(3);
    }
    const std::string said = testing::internal::GetCapturedStderr();
    // only one warning, because the others came within a second
    EXPECT_NE(said.find("topic '" + topic + "': a message from this process is refused: "), std::string::npos) << said;
    EXPECT_NE(said.find(" is 1e+308; numbers must be finite, from -" + largest + " to " + largest + "; dropped\n"),
              std::string::npos)
        << said;
    EXPECT_EQ(said.find("switched off"), std::string::npos) << said;
  }

  /// Makes steps, and delivers the messages of the last one.
  void step(std::uint64_t count) {
    simulation_->step(count);
    simulation_->transport().dispatch();
  }

 private:
  std::unique_ptr<Simulation> simulation_;
  std::list<Subscription> subscriptions_;
  std::list<Publisher> publishers_;
};

}  // namespace pongsim::test
