#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "ros2/node/service.hh"
#include "support/process.hh"
#include "support/temp_folder.hh"
#include "support/test_domain.hh"

namespace pongsim::ros2 {

/// A simulation that `pongsim run` runs as a ROS node, and a node in another process that calls its services.
class ServedWorld {
 public:
  /// @param content Of the world "w", in addition to the physics.
  /// @param options For `pongsim run`.
  explicit ServedWorld(const std::string& content, const std::vector<std::string>& options = {},
                       const std::string& parameters = "") {
    file_ = folder_.write("world.sdf",
                          "<sdf version='1.9'><world name='w'>"
                          "<physics type='ignored'><max_step_size>0.001</max_step_size>"
                          "<real_time_factor>1</real_time_factor></physics>"
                          "<plugin filename='ignition-gazebo-physics-system' "
                          "name='ignition::gazebo::systems::Physics'/>"
                          "<plugin filename='pongsim-ros2-system' name='pongsim::systems::Ros2'>" +
                              parameters + "</plugin>" + content + "</world></sdf>");
    std::vector<std::string> arguments{PONGSIM_PROGRAM, "run", file_};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const std::string resources = folder_.path() / "models";
    process_.emplace(arguments, test::Process::Options{{{"ROS_DOMAIN_ID", std::to_string(domain_)},
                                                        {"ROS_DISTRO", "humble"},
                                                        {"PONGSIM_RESOURCE_PATH", resources}},
                                                       folder_.path()});
  }

  const std::filesystem::path& file() const { return file_; }
  const test::TempFolder& folder() const { return folder_; }
  RosNode& node() { return node_; }
  test::Process& process() { return *process_; }

  /// @param service "~/get_entities" for the simulation's node; or an absolute name.
  template <ServiceType Service>
  typename Service::Response call(const std::string& service, const typename Service::Request& request = {}) {
    RosClient<Service> client(node_, service.starts_with("~") ? "/pongsim" + service.substr(1) : service);
    const auto response = client.call(request, test::kDeadline);
    if (!response) ADD_FAILURE() << service << " did not answer; " << process_->error();
    return response.value_or(typename Service::Response());
  }

 private:
  const int domain_ = test::testDomain();
  test::TempFolder folder_;
  std::filesystem::path file_;
  std::optional<test::Process> process_;
  Participant participant_{{.domain = domain_}};
  RosNode node_{participant_, {.name = "peer"}};
};

}  // namespace pongsim::ros2
