#include "ros2/controllers/controller_parameters.hh"

#include <utility>

#include "ros2/node/parameters.hh"

namespace pongsim::ros2 {

const rcl_interfaces::ParameterValue* ControllerParameters::find(const std::string& name) {
  known_.insert(name);
  const auto found = given_.find(name);
  return found == given_.end() ? nullptr : &found->second;
}

void ControllerParameters::refuseType(const std::string& name, const char* type) {
  complain("'" + name + "' must be " + type);
}

double ControllerParameters::number(const std::string& name, double fallback) {
  double value = fallback;
  if (const auto* given = find(name)) {
    if (given->type == rcl_interfaces::ParameterType::kParameterDouble) {
      value = given->double_value;
    } else if (given->type == rcl_interfaces::ParameterType::kParameterInteger) {
      value = static_cast<double>(given->integer_value);
    } else {
      refuseType(name, "a number");
    }
  }
  asked_[name] = parameterOf(value);
  return value;
}

double ControllerParameters::numberAboveZero(const std::string& name, double fallback) {
  const double value = number(name, fallback);
  if (!(value > 0)) complain("'" + name + "' must be above zero");
  return value;
}

std::int64_t ControllerParameters::whole(const std::string& name, std::int64_t fallback) {
  std::int64_t value = fallback;
  if (const auto* given = find(name)) {
    if (given->type == rcl_interfaces::ParameterType::kParameterInteger) {
      value = given->integer_value;
    } else {
      refuseType(name, "a whole number");
    }
  }
  asked_[name] = parameterOf(value);
  return value;
}

bool ControllerParameters::flag(const std::string& name, bool fallback) {
  bool value = fallback;
  if (const auto* given = find(name)) {
    if (given->type == rcl_interfaces::ParameterType::kParameterBool) {
      value = given->bool_value;
    } else {
      refuseType(name, "true or false");
    }
  }
  asked_[name] = parameterOf(value);
  return value;
}

std::string ControllerParameters::text(const std::string& name, const std::string& fallback) {
  std::string value = fallback;
  if (const auto* given = find(name)) {
    if (given->type == rcl_interfaces::ParameterType::kParameterString) {
      value = given->string_value;
    } else {
      refuseType(name, "a text");
    }
  }
  asked_[name] = parameterOf(value);
  return value;
}

std::vector<double> ControllerParameters::numbers(const std::string& name, std::vector<double> fallback) {
  std::vector<double> value = std::move(fallback);
  if (const auto* given = find(name)) {
    if (given->type == rcl_interfaces::ParameterType::kParameterDoubleArray) {
      value = given->double_array_value;
    } else if (given->type == rcl_interfaces::ParameterType::kParameterIntegerArray) {
      value.assign(given->integer_array_value.begin(), given->integer_array_value.end());
    } else {
      refuseType(name, "a list of numbers");
    }
  }
  auto& asked = asked_[name];
  asked.type = rcl_interfaces::ParameterType::kParameterDoubleArray;
  asked.double_array_value = value;
  return value;
}

std::vector<double> ControllerParameters::numbers(const std::string& name, std::vector<double> fallback,
                                                  std::size_t count) {
  std::vector<double> value = numbers(name, std::move(fallback));
  if (value.size() != count) {
    complain("'" + name + "' must have " + std::to_string(count) + " numbers");
    value.resize(count);
  }
  return value;
}

std::vector<std::string> ControllerParameters::texts(const std::string& name, std::vector<std::string> fallback) {
  std::vector<std::string> value = std::move(fallback);
  if (const auto* given = find(name)) {
    // an empty list has no type
    if (given->type == rcl_interfaces::ParameterType::kParameterStringArray) {
      value = given->string_array_value;
    } else if (given->type == rcl_interfaces::ParameterType::kParameterIntegerArray &&
               given->integer_array_value.empty()) {
      value.clear();
    } else {
      refuseType(name, "a list of texts");
    }
  }
  auto& asked = asked_[name];
  asked.type = rcl_interfaces::ParameterType::kParameterStringArray;
  asked.string_array_value = value;
  return value;
}

std::vector<std::string> ControllerParameters::unknown() const {
  std::vector<std::string> names;
  for (const auto& [name, value] : given_) {
    if (!known_.contains(name)) names.push_back(name);
  }
  return names;
}

}  // namespace pongsim::ros2
