#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "ros2/controllers/parameter_files.hh"

namespace pongsim::ros2 {

/// The parameters of a controller, as it asks for them with their defaults. What is wrong with them is collected.
class ControllerParameters {
 public:
  ControllerParameters() = default;
  explicit ControllerParameters(ParameterValues given) : given_(std::move(given)) {}

  double number(const std::string& name, double fallback);
  /// A number that must be above zero.
  double numberAboveZero(const std::string& name, double fallback);
  std::int64_t whole(const std::string& name, std::int64_t fallback);
  bool flag(const std::string& name, bool fallback);
  std::string text(const std::string& name, const std::string& fallback);
  std::vector<double> numbers(const std::string& name, std::vector<double> fallback);
  std::vector<std::string> texts(const std::string& name, std::vector<std::string> fallback = {});
  /// A list of that many numbers.
  std::vector<double> numbers(const std::string& name, std::vector<double> fallback, std::size_t count);

  bool has(const std::string& name) const { return given_.contains(name); }
  /// Marks a parameter that is known, and has no effect here.
  void ignore(const std::string& name) { known_.insert(name); }
  /// Adds an error: "'wheel_radius' must be above zero".
  void complain(std::string error) { errors_.push_back(std::move(error)); }

  /// @return All that were asked for, with their values.
  const ParameterValues& asked() const { return asked_; }
  /// @return What is wrong with them; the controller can't be configured then.
  const std::vector<std::string>& errors() const { return errors_; }
  /// @return Those that were given and never asked for.
  std::vector<std::string> unknown() const;

 private:
  const rcl_interfaces::ParameterValue* find(const std::string& name);
  void refuseType(const std::string& name, const char* type);

  ParameterValues given_;
  ParameterValues asked_;
  std::set<std::string> known_;
  std::vector<std::string> errors_;
};

}  // namespace pongsim::ros2
