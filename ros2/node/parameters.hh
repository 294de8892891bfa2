#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ros2/node/node.hh"
#include "ros2/node/service.hh"
#include "ros2/types/rcl_interfaces.hh"

namespace pongsim::ros2 {

// Values of parameters, with their types.
rcl_interfaces::ParameterValue parameterOf(bool value);
rcl_interfaces::ParameterValue parameterOf(std::int64_t value);
rcl_interfaces::ParameterValue parameterOf(double value);
rcl_interfaces::ParameterValue parameterOf(const std::string& value);

/// The parameters of a node: the six services that every node of ROS has, and the topic /parameter_events. What is
/// refused is refused in the words of rclcpp. For one thread, that of the node's mailbox.
class Parameters {
 public:
  using Value = rcl_interfaces::ParameterValue;
  /// Name, description, range and so on; the type is that of the value.
  using Descriptor = rcl_interfaces::ParameterDescriptor;
  /// Lets a value of the right type, within its range, take effect.
  /// @return Why not, or nothing.
  using Setter = std::function<std::optional<std::string>(const Value&)>;

  /// @param now What the events are stamped with.
  Parameters(RosNode& node, std::function<builtin_interfaces::Time()> now);
  Parameters(const Parameters&) = delete;
  Parameters& operator=(const Parameters&) = delete;

  /// Adds a parameter.
  /// @param setter Empty: it is read-only.
  /// @throws std::invalid_argument for an empty name or one that is there, and for a value without a type.
  void declare(Descriptor descriptor, const Value& value, Setter setter = {});

  /// Tells of a value that was changed by others than these services. One that is as it was is not told.
  /// @throws std::invalid_argument where there is no such parameter, or it is of another type.
  void update(const std::string& name, const Value& value);

  // What the services do.

  /// @return One result for each; those that can be set are.
  std::vector<rcl_interfaces::SetParametersResult> set(const std::vector<rcl_interfaces::Parameter>& asked);
  /// Sets all, or none where one of them can't be.
  rcl_interfaces::SetParametersResult setAtomically(const std::vector<rcl_interfaces::Parameter>& asked);
  /// @return Empty where one of them is not there, as rclcpp answers; likewise below.
  std::vector<Value> get(const std::vector<std::string>& names) const;
  std::vector<std::uint8_t> types(const std::vector<std::string>& names) const;
  std::vector<Descriptor> describe(const std::vector<std::string>& names) const;
  /// @param prefixes Empty: all are looked at; else those of that name, or below it ("a" has "a.b").
  /// @param depth So many parts of a name may come behind the prefix; 0: any number.
  rcl_interfaces::ListParametersResult list(const std::vector<std::string>& prefixes, std::uint64_t depth) const;

 private:
  struct Entry {
    Descriptor descriptor;
    Value value;
    Setter setter;
  };
  std::optional<std::string> refusal(const rcl_interfaces::Parameter& asked) const;
  rcl_interfaces::SetParametersResult setAll(const std::vector<rcl_interfaces::Parameter>& asked);
  /// Nothing where one of them is not there.
  template <class Result, class Of>
  std::vector<Result> ofEach(const std::vector<std::string>& names, const Of& of) const;
  void tell(rcl_interfaces::ParameterEvent event);

  RosNode& node_;
  std::function<builtin_interfaces::Time()> now_;
  std::map<std::string, Entry> entries_;
  std::unique_ptr<RosPublisher> events_;
  std::vector<std::unique_ptr<RosServer>> servers_;
};

}  // namespace pongsim::ros2
