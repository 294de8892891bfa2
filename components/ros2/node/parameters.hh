#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "ros2/node/node.hh"
#include "ros2/node/service.hh"
#include "ros2/types/rcl_interfaces.hh"

namespace pongsim::ros2 {

/// What follows a node's name in that of the service by which its parameters are read.
inline constexpr std::string_view kGetParameters = "/get_parameters";
/// @return These services of all nodes among the endpoints: "/robot/get_parameters".
std::set<std::string> parameterServices(const std::vector<Graph::Endpoint>& endpoints);

// Parameter values, with their types.
rcl_interfaces::ParameterValue parameterOf(bool value);
rcl_interfaces::ParameterValue parameterOf(std::int64_t value);
rcl_interfaces::ParameterValue parameterOf(double value);
rcl_interfaces::ParameterValue parameterOf(const std::string& value);

/// The parameters of a node: the six services of every ROS node, and the topic /parameter_events. Refusals use rclcpp's
/// wording. For one thread, that of the node's mailbox.
class Parameters {
 public:
  using Value = rcl_interfaces::ParameterValue;
  /// Name, description, range and so on; the type is that of the value.
  using Descriptor = rcl_interfaces::ParameterDescriptor;
  /// Applies a value of the right type and within its range.
  /// @return Why it is refused, or nothing.
  using Setter = std::function<std::optional<std::string>(const Value&)>;

  /// @param now Time stamp of the events.
  Parameters(RosNode& node, std::function<builtin_interfaces::Time()> now);
  Parameters(const Parameters&) = delete;
  Parameters& operator=(const Parameters&) = delete;

  /// Adds a parameter.
  /// @param setter Empty: read-only.
  /// @throws std::invalid_argument for an empty or existing name, and for a value without a type.
  void declare(Descriptor descriptor, const Value& value, Setter setter = {});

  /// From now on, setting a parameter that does not exist adds it, as for nodes that allow undeclared parameters. Those
  /// may change their type.
  void allowUndeclared() { allowsUndeclared_ = true; }

  /// Publishes a value that changed by other means than these services. Unchanged values are not published.
  /// @throws std::invalid_argument if there is no such parameter, or it has another type.
  void update(const std::string& name, const Value& value);

  // Implementations of the services.

  /// @return One result for each; those that are valid are set.
  std::vector<rcl_interfaces::SetParametersResult> set(const std::vector<rcl_interfaces::Parameter>& requested);
  /// Sets all, or none if one of them is refused.
  rcl_interfaces::SetParametersResult setAtomically(const std::vector<rcl_interfaces::Parameter>& requested);
  /// @return Empty if one of them does not exist, as in rclcpp; the same below.
  std::vector<Value> get(const std::vector<std::string>& names) const;
  std::vector<std::uint8_t> types(const std::vector<std::string>& names) const;
  std::vector<Descriptor> describe(const std::vector<std::string>& names) const;
  /// @param prefixes Empty: all parameters; else those with this name or below it ("a" includes "a.b").
  /// @param depth Maximum number of name parts after the prefix; 0: any number.
  rcl_interfaces::ListParametersResult list(const std::vector<std::string>& prefixes, std::uint64_t depth) const;

 private:
  struct Declared {
    Descriptor descriptor;
    Value value;
    Setter setter;
  };
  std::optional<std::string> refusal(const rcl_interfaces::Parameter& requested) const;
  rcl_interfaces::SetParametersResult setAll(const std::vector<rcl_interfaces::Parameter>& requested);
  /// Nothing if one of them does not exist.
  template <class Result, class Of>
  std::vector<Result> ofEach(const std::vector<std::string>& names, const Of& of) const;
  void publish(rcl_interfaces::ParameterEvent event);

  RosNode& node_;
  std::function<builtin_interfaces::Time()> now_;
  std::map<std::string, Declared> declared_;
  bool allowsUndeclared_ = false;
  std::unique_ptr<RosPublisher> events_;
  std::vector<std::unique_ptr<RosServer>> servers_;
};

}  // namespace pongsim::ros2
