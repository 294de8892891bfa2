#include "ros2/node/parameters.hh"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "ros2/node/names.hh"

namespace pongsim::ros2 {

using Type = rcl_interfaces::ParameterType;
using rcl_interfaces::Parameter;
using rcl_interfaces::SetParametersResult;

namespace {

constexpr char kSeparator = '.';
// Equal to rmw_qos_profile_parameter_events.
constexpr Qos kEventsQos{.depth = 1000};

std::string typeName(std::uint8_t type) {
  constexpr const char* kNames[] = {"not set",    "bool",       "integer",       "double",       "string",
                                    "byte_array", "bool_array", "integer_array", "double_array", "string_array"};
  return type < std::size(kNames) ? kNames[type] : "unknown type";
}

/// Compares like rclcpp: with a relative tolerance of a hundred epsilons.
bool areEqual(double a, double b) {
  return std::abs(a - b) <= std::numeric_limits<double>::epsilon() * std::abs(a + b) * 100;
}

bool isWithin(double value, const rcl_interfaces::FloatingPointRange& range) {
  if (!std::isfinite(value)) return false;
  if (areEqual(value, range.from_value) || areEqual(value, range.to_value)) return true;
  if (value < range.from_value || value > range.to_value) return false;
  if (range.step == 0) return true;
  return areEqual(value, range.from_value + std::round((value - range.from_value) / range.step) * range.step);
}

bool isWithin(std::int64_t value, const rcl_interfaces::IntegerRange& range) {
  if (value == range.from_value || value == range.to_value) return true;
  if (value < range.from_value || value > range.to_value) return false;
  if (range.step == 0) return true;
  // unsigned, because the difference may exceed an integer
  return (static_cast<std::uint64_t>(value) - static_cast<std::uint64_t>(range.from_value)) % range.step == 0;
}

std::optional<std::string> rangeError(const Parameters::Descriptor& descriptor, const Parameters::Value& value) {
  const char* range = nullptr;
  if (value.type == Type::kParameterInteger && !descriptor.integer_range.empty() &&
      !isWithin(value.integer_value, descriptor.integer_range.front())) {
    range = "integer";
  }
  if (value.type == Type::kParameterDouble && !descriptor.floating_point_range.empty() &&
      !isWithin(value.double_value, descriptor.floating_point_range.front())) {
    range = "floating point";
  }
  if (range == nullptr) return std::nullopt;
  return "Parameter {" + descriptor.name + "} doesn't comply with " + range + " range.";
}

bool isBelow(const std::string& name, const std::string& prefix) {
  return name.size() > prefix.size() && name.starts_with(prefix) && name[prefix.size()] == kSeparator;
}

/// @return Whether the rest of a name has no more than `depth` parts.
bool isWithinDepth(std::string_view name, std::uint64_t depth) {
  return depth == rcl_interfaces::srv::ListParameters::Request::kDepthRecursive ||
         static_cast<std::uint64_t>(std::ranges::count(name, kSeparator)) < depth;
}

}  // namespace

std::set<std::string> parameterServices(const std::vector<Graph::Endpoint>& endpoints) {
  std::set<std::string> services;
  for (const Graph::Endpoint& endpoint : endpoints) {
    const auto service = serviceFromWire(endpoint.contract.topic);
    if (endpoint.role == Graph::Role::kReader && service && service->ends_with(kGetParameters)) {
      services.insert(*service);
    }
  }
  return services;
}

rcl_interfaces::ParameterValue parameterOf(bool value) {
  rcl_interfaces::ParameterValue parameter;
  parameter.type = Type::kParameterBool;
  parameter.bool_value = value;
  return parameter;
}

rcl_interfaces::ParameterValue parameterOf(std::int64_t value) {
  rcl_interfaces::ParameterValue parameter;
  parameter.type = Type::kParameterInteger;
  parameter.integer_value = value;
  return parameter;
}

rcl_interfaces::ParameterValue parameterOf(double value) {
  rcl_interfaces::ParameterValue parameter;
  parameter.type = Type::kParameterDouble;
  parameter.double_value = value;
  return parameter;
}

rcl_interfaces::ParameterValue parameterOf(const std::string& value) {
  rcl_interfaces::ParameterValue parameter;
  parameter.type = Type::kParameterString;
  parameter.string_value = value;
  return parameter;
}

Parameters::Parameters(RosNode& node, std::function<builtin_interfaces::Time()> now)
    : node_(node), now_(std::move(now)) {
  const RosNode::Quiet quiet(node);
  events_ = node.advertise<rcl_interfaces::ParameterEvent>("/parameter_events", kEventsQos);
  namespace srv = rcl_interfaces::srv;
  servers_.push_back(serveAtOnce<srv::DescribeParameters>(
      node, "~/describe_parameters", [this](const srv::DescribeParameters::Request& request) {
        return srv::DescribeParameters::Response{describe(request.names)};
      }));
  servers_.push_back(serveAtOnce<srv::GetParameterTypes>(
      node, "~/get_parameter_types", [this](const srv::GetParameterTypes::Request& request) {
        return srv::GetParameterTypes::Response{types(request.names)};
      }));
  servers_.push_back(serveAtOnce<srv::GetParameters>(
      node, "~/get_parameters",
      [this](const srv::GetParameters::Request& request) { return srv::GetParameters::Response{get(request.names)}; }));
  servers_.push_back(
      serveAtOnce<srv::ListParameters>(node, "~/list_parameters", [this](const srv::ListParameters::Request& request) {
        return srv::ListParameters::Response{list(request.prefixes, request.depth)};
      }));
  servers_.push_back(
      serveAtOnce<srv::SetParameters>(node, "~/set_parameters", [this](const srv::SetParameters::Request& request) {
        return srv::SetParameters::Response{set(request.parameters)};
      }));
  servers_.push_back(serveAtOnce<srv::SetParametersAtomically>(
      node, "~/set_parameters_atomically", [this](const srv::SetParametersAtomically::Request& request) {
        return srv::SetParametersAtomically::Response{setAtomically(request.parameters)};
      }));
}

void Parameters::declare(Descriptor descriptor, const Value& value, Setter setter) {
  const std::string name = descriptor.name;
  if (name.empty()) throw std::invalid_argument("parameter name must not be empty");
  if (value.type == Type::kParameterNotSet) throw std::invalid_argument("parameter '" + name + "' has no type");
  if (declared_.contains(name)) throw std::invalid_argument("parameter '" + name + "' has already been declared");
  descriptor.type = value.type;
  descriptor.read_only = !setter;
  if (const auto error = rangeError(descriptor, value)) throw std::invalid_argument(*error);
  declared_[name] = {std::move(descriptor), value, std::move(setter)};
  rcl_interfaces::ParameterEvent event;
  event.new_parameters.push_back({name, value});
  publish(std::move(event));
}

void Parameters::update(const std::string& name, const Value& value) {
  const auto found = declared_.find(name);
  if (found == declared_.end() || found->second.value.type != value.type) {
    throw std::invalid_argument("there is no parameter '" + name + "' of type " + typeName(value.type));
  }
  if (found->second.value == value) return;
  found->second.value = value;
  rcl_interfaces::ParameterEvent event;
  event.changed_parameters.push_back({name, value});
  publish(std::move(event));
}

std::vector<SetParametersResult> Parameters::set(const std::vector<Parameter>& requested) {
  std::vector<SetParametersResult> results;
  for (const Parameter& each : requested) results.push_back(setAll({each}));
  return results;
}

SetParametersResult Parameters::setAtomically(const std::vector<Parameter>& requested) {
  const bool areAllThere =
      std::ranges::all_of(requested, [this](const Parameter& each) { return declared_.contains(each.name); });
  if (!areAllThere && !allowsUndeclared_) return {false, "One or more parameters were not declared before setting"};
  return setAll(requested);
}

/// @return Why it can't have that value, in rclcpp's words. Its setter may refuse it as well.
std::optional<std::string> Parameters::refusal(const Parameter& requested) const {
  const auto found = declared_.find(requested.name);
  if (found == declared_.end()) {
    if (allowsUndeclared_ && !requested.name.empty()) return std::nullopt;
    return "parameter '" + requested.name + "' cannot be set because it was not declared";
  }
  const Descriptor& descriptor = found->second.descriptor;
  if (descriptor.read_only) return "parameter '" + requested.name + "' cannot be set because it is read-only";
  if (requested.value.type != descriptor.type && !descriptor.dynamic_typing) {
    return "Wrong parameter type, parameter {" + requested.name + "} is of type {" + typeName(descriptor.type) +
           "}, setting it to {" + typeName(requested.value.type) + "} is not allowed.";
  }
  return rangeError(descriptor, requested.value);
}

SetParametersResult Parameters::setAll(const std::vector<Parameter>& requested) {
  for (const Parameter& each : requested) {
    if (const auto error = refusal(each)) return {false, *error};
  }
  std::vector<std::pair<Declared*, Value>> before;
  rcl_interfaces::ParameterEvent event;
  for (const Parameter& each : requested) {
    if (!declared_.contains(each.name)) {
      Descriptor descriptor;
      descriptor.name = each.name;
      descriptor.dynamic_typing = true;
      declared_[each.name] = {std::move(descriptor), {}, [](const Value&) { return std::nullopt; }};
      event.new_parameters.push_back(each);
    } else {
      event.changed_parameters.push_back(each);
    }
    Declared& declared = declared_[each.name];
    if (const auto error = declared.setter(each.value)) {
      for (auto done = before.rbegin(); done != before.rend(); ++done) {
        done->first->setter(done->second);
        done->first->value = done->second;
      }
      return {false, *error};
    }
    before.emplace_back(&declared, std::exchange(declared.value, each.value));
    declared.descriptor.type = each.value.type;
  }
  publish(std::move(event));
  return {true, {}};
}

template <class Result, class Of>
std::vector<Result> Parameters::ofEach(const std::vector<std::string>& names, const Of& of) const {
  std::vector<Result> results;
  for (const std::string& name : names) {
    const auto found = declared_.find(name);
    if (found == declared_.end()) return {};
    results.push_back(of(found->second));
  }
  return results;
}

std::vector<Parameters::Value> Parameters::get(const std::vector<std::string>& names) const {
  return ofEach<Value>(names, [](const Declared& declared) { return declared.value; });
}

std::vector<std::uint8_t> Parameters::types(const std::vector<std::string>& names) const {
  return ofEach<std::uint8_t>(names, [](const Declared& declared) { return declared.value.type; });
}

std::vector<Parameters::Descriptor> Parameters::describe(const std::vector<std::string>& names) const {
  return ofEach<Descriptor>(names, [](const Declared& declared) { return declared.descriptor; });
}

rcl_interfaces::ListParametersResult Parameters::list(const std::vector<std::string>& prefixes,
                                                      std::uint64_t depth) const {
  rcl_interfaces::ListParametersResult result;
  for (const auto& [name, declared] : declared_) {
    const bool isSelected =
        prefixes.empty() ? isWithinDepth(name, depth) : std::ranges::any_of(prefixes, [&](const std::string& prefix) {
          return name == prefix ||
                 (isBelow(name, prefix) && isWithinDepth(std::string_view(name).substr(prefix.size() + 1), depth));
        });
    if (!isSelected) continue;
    result.names.push_back(name);
    const std::size_t last = name.rfind(kSeparator);
    if (last == std::string::npos) continue;
    const std::string prefix = name.substr(0, last);
    if (std::ranges::find(result.prefixes, prefix) == result.prefixes.end()) result.prefixes.push_back(prefix);
  }
  return result;
}

void Parameters::publish(rcl_interfaces::ParameterEvent event) {
  if (!events_->hasReaders()) return;
  event.stamp = now_();
  event.node = node_.fullName();
  events_->publish(event);
}

}  // namespace pongsim::ros2
