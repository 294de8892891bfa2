#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "pongsim/node.hh"
#include "pongsim/simulation.hh"
#include "ros2/control/hardware_interfaces.hh"
#include "ros2/control/joint_driver.hh"
#include "ros2/controllers/controller_manager.hh"
#include "support/ros2/robot_world.hh"
#include "support/temp_folder.hh"
#include "support/test_domain.hh"
#include "support/wait_until.hh"

namespace pongsim::ros2 {

/// A model whose joints controllers command, step by step, and a node that talks to them. All joints with an axis have
/// the command and state interfaces position, velocity and effort.
class ControlledRobot {
 public:
  /// @param world Its systems are not loaded.
  /// @param parameters Content of the manager's parameter file.
  /// @param remap A rule for the controllers' topics, unless it is empty.
  ControlledRobot(std::unique_ptr<Simulation> world, const std::string& model, const std::string& parameters,
                  double rate = 1000, const std::string& remap = "")
      : simulation_(std::move(world)), model_(simulation_->world().model(model).value()) {
    std::vector<ControlledJoint> joints;
    for (const Joint& joint : model_.joints()) {
      if (joint.axisCount() != 1) continue;
      ControlledJoint& added = joints.emplace_back();
      added.name = joint.name();
      added.takesPosition = added.takesVelocity = added.takesEffort = true;
    }
    const std::size_t count = joints.size();
    driver_.emplace(model_, std::move(joints), JointDriver::Settings{.updateRate = rate});
    const std::vector<std::string> all = {"position", "velocity", "effort"};
    for (std::size_t i = 0; i < count; ++i) hardware_.addJoint(*driver_, i, all, all);
    ControllerManager::Options options;
    options.name = "controller_manager";
    options.rate = rate;
    options.remaps.add(remap);
    EXPECT_EQ(options.files.read(folder_.write("controllers.yaml", parameters)), "");
    manager_.emplace(beside_, hardware_, model_, node_, log_, std::move(options));
  }

  Simulation& simulation() { return *simulation_; }
  Model& model() { return model_; }
  HardwareInterfaces& hardware() { return hardware_; }
  ControllerManager& manager() { return *manager_; }
  RosNode& peer() { return peer_; }
  Time now() const { return now_; }
  const std::filesystem::path& folder() const { return folder_.path(); }

  /// Loads, configures and activates a controller.
  void start(const std::string& name) {
    EXPECT_EQ(manager_->load(name).error, "");
    EXPECT_EQ(manager_->configure(name).error, "");
    EXPECT_EQ(manager_->switchTo({name}, {}, true).error, "");
  }

  void step(std::uint64_t count = 1) {
    for (std::uint64_t i = 0; i < count; ++i) {
      driver_->drive(simulation_->stepSize());
      simulation_->step();
      now_ += simulation_->stepSize();
      manager_->update(now_);
    }
  }

  /// Publishes a message, and waits until it has arrived.
  template <Structure Message>
  void tell(const std::string& topic, const Message& message) {
    const auto publisher = peer_.advertise<Message>(topic);
    // a best-effort reader hears what it has met the writer of
    ASSERT_TRUE(test::waitUntil([&] {
      const auto writers = participant_.graph().endpointsOn(topicOnWire(topic), Graph::Role::kWriter);
      return publisher->hasReaders() && !writers.empty();
    })) << topic;
    const auto arrives = [&] {
      for (int i = 0; i < 500; ++i) {
        if (manager_->dispatch() > 0) return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
      }
      return false;
    };
    ASSERT_TRUE(test::waitUntil([&] {
      publisher->publish(message);
      return arrives();
    })) << topic;
  }

  /// Collects the messages of a topic, which arrive on another thread.
  template <Structure Message>
  struct Heard {
    std::mutex mutex;
    std::vector<Message> messages;
    std::unique_ptr<RosSubscription> subscription;

    std::vector<Message> get() {
      const std::lock_guard lock(mutex);
      return messages;
    }
  };
  template <Structure Message>
  std::unique_ptr<Heard<Message>> listen(const std::string& topic) {
    auto heard = std::make_unique<Heard<Message>>();
    heard->subscription = peer_.subscribe<Message>(topic, [&to = *heard](const Message& message) {
      const std::lock_guard lock(to.mutex);
      to.messages.push_back(message);
    });
    EXPECT_TRUE(test::waitUntil([&] { return heard->subscription->reader().writers() > 0; })) << topic;
    return heard;
  }

  /// Makes steps until a message arrives that is not older than `age`: some are lost where steps are faster than the
  /// reader.
  /// @return That message.
  template <Structure Message>
  Message next(Heard<Message>& heard, Time age = std::chrono::milliseconds(30)) {
    Message last;
    EXPECT_TRUE(test::waitUntil([&] {
      step(10);
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
      const auto all = heard.get();
      if (all.empty()) return false;
      last = all.back();
      const auto& stamp = last.header.stamp;
      return std::chrono::seconds(stamp.sec) + Time(stamp.nanosec) >= now_ - age;
    }));
    return last;
  }

  std::vector<std::byte> save() {
    StateArchive archive;
    archive(now_);
    archive(*driver_);
    archive(*manager_);
    states_ = simulation_->saveState();
    return archive.take();
  }
  void restore(const std::vector<std::byte>& saved) {
    StateArchive archive(saved);
    archive(now_);
    archive(*driver_);
    archive(*manager_);
    EXPECT_EQ(simulation_->restoreState(states_).error, "");
  }

 private:
  test::TempFolder folder_;
  Logger log_{"test"};
  std::unique_ptr<Simulation> simulation_;
  Model model_;
  Node node_ = simulation_->transport().node();
  HardwareInterfaces hardware_;
  std::optional<JointDriver> driver_;
  Participant peersParticipant_{{.domain = test::testDomain()}};
  RosNode peer_{peersParticipant_, {.name = "peer"}};
  Participant participant_{{.domain = test::testDomain()}};
  RosNode beside_{participant_, {.name = "pongsim"}};
  std::optional<ControllerManager> manager_;
  Time now_{0};
  std::vector<std::byte> states_;
};

}  // namespace pongsim::ros2
