#pragma once

#include <cstdint>

#include "ros2/types/action_types.hh"
#include "ros2/types/simulation_interfaces.hh"

namespace pongsim::ros2::simulation_interfaces::action {

struct SimulateSteps {
  static constexpr const char* kName = "simulation_interfaces/action/SimulateSteps";
  struct Goal {
    static constexpr const char* kName = "simulation_interfaces/action/SimulateSteps_Goal";
    std::uint64_t steps = 0;
    static void visit(auto& self, auto&& field) { field("steps", self.steps); }
    bool operator==(const Goal&) const = default;
  };
  struct Result {
    static constexpr const char* kName = "simulation_interfaces/action/SimulateSteps_Result";
    simulation_interfaces::Result result;
    static void visit(auto& self, auto&& field) { field("result", self.result); }
    bool operator==(const Result&) const = default;
  };
  struct Feedback {
    static constexpr const char* kName = "simulation_interfaces/action/SimulateSteps_Feedback";
    std::uint64_t completed_steps = 0;
    std::uint64_t remaining_steps = 0;
    static void visit(auto& self, auto&& field) {
      field("completed_steps", self.completed_steps);
      field("remaining_steps", self.remaining_steps);
    }
    bool operator==(const Feedback&) const = default;
  };
};

}  // namespace pongsim::ros2::simulation_interfaces::action
