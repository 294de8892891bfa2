#include "ros2/control/controller_file.hh"

#include <yaml-cpp/yaml.h>

#include <cmath>

namespace pongsim::ros2 {

namespace {

constexpr int kDeepest = 20;

template <class Value>
void take(const YAML::Node& parameters, const char* name, std::optional<Value>& value) {
  const YAML::Node found = parameters[name];
  if (found) value = found.as<Value>();
}

/// Node names are nested in their namespaces.
void readNodes(const YAML::Node& yaml, ControllerFile& file, int depth) {
  if (!yaml.IsMap() || depth > kDeepest) return;
  for (const auto& entry : yaml) {
    if (!entry.second.IsMap()) continue;
    const YAML::Node parameters = entry.second["ros__parameters"];
    if (!parameters || !parameters.IsMap()) {
      readNodes(entry.second, file, depth + 1);
      continue;
    }
    // controllers have a rate of the same name
    const bool isManager = entry.first.as<std::string>().find("manager") != std::string::npos;
    if (isManager) take(parameters, "update_rate", file.updateRate);
    take(parameters, "position_proportional_gain", file.positionGain);
    take(parameters, "hold_joints", file.holdsJoints);
  }
}

}  // namespace

ControllerFile readControllerFile(const std::filesystem::path& path) {
  ControllerFile file;
  std::error_code ignored;
  if (std::filesystem::exists(path, ignored) && !std::filesystem::is_regular_file(path, ignored)) {
    file.error = "it is not a regular file";
    return file;
  }
  try {
    readNodes(YAML::LoadFile(path.string()), file, 0);
  } catch (const YAML::BadFile&) {
    file.error = "there is no such file";
  } catch (const YAML::Exception& error) {
    const bool hasPlace = error.mark.line >= 0;
    file.error = (hasPlace ? "line " + std::to_string(error.mark.line + 1) + ", column " +
                                 std::to_string(error.mark.column + 1) + ": "
                           : "") +
                 error.msg;
  }
  const auto isSound = [](const std::optional<double>& value) {
    return !value || (std::isfinite(*value) && *value > 0);
  };
  if (!isSound(file.updateRate) || !isSound(file.positionGain)) {
    file.error = "update_rate and position_proportional_gain must be above zero";
    file.updateRate = file.positionGain = std::nullopt;
  }
  return file;
}

}  // namespace pongsim::ros2
