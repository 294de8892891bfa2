#include "golden/recording.hh"

#include <gtest/gtest.h>
#include <ignition/msgs/battery_state.pb.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <memory>
#include <optional>
#include <sstream>
#include <utility>

#include "pongsim/message.hh"
#include "support/fortress_worlds.hh"

namespace pongsim::test {

namespace {

std::vector<std::string> columnsOf(const std::string& line) {
  std::vector<std::string> columns;
  std::istringstream stream(line);
  for (std::string column; std::getline(stream, column, ',');) columns.push_back(column);
  return columns;
}

/// "examples_lift_drag.csv" for "examples/lift_drag.sdf".
std::string recordingOf(std::string world) {
  std::replace(world.begin(), world.end(), '/', '_');
  return world.substr(0, world.rfind('.')) + ".csv";
}

/// Splits "outer::inner::link" into the model "outer::inner" and the name "link".
std::pair<std::string, std::string> split(const std::string& name) {
  const std::size_t colons = name.rfind("::");
  return {name.substr(0, colons), name.substr(colons + 2)};
}

std::optional<Model> modelOf(World world, const std::string& name) {
  const std::size_t colons = name.find("::");
  std::optional<Model> model = world.model(name.substr(0, colons));
  for (std::size_t at = colons; model && at != std::string::npos;) {
    const std::size_t end = name.find("::", at + 2);
    const std::string part = name.substr(at + 2, end == std::string::npos ? end : end - at - 2);
    const std::vector<Model> inner = model->models();
    const auto found = std::ranges::find(inner, part, [](const Model& each) { return std::string(each.name()); });
    model = found == inner.end() ? std::nullopt : std::optional(*found);
    at = end;
  }
  return model;
}

std::optional<Pose> poseOf(World world, const RecordedRow& row) {
  if (row.what == "model") {
    const auto model = modelOf(world, row.name);
    return model ? std::optional(model->pose()) : std::nullopt;
  }
  const auto [modelName, linkName] = split(row.name);
  const auto model = modelOf(world, modelName);
  const auto link = model ? model->link(linkName) : std::nullopt;
  return link ? std::optional(link->pose()) : std::nullopt;
}

}  // namespace

std::vector<RecordedRow> readRecording(const std::filesystem::path& file) {
  std::ifstream stream(file);
  std::string line;
  std::getline(stream, line);
  std::vector<RecordedRow> rows;
  while (std::getline(stream, line)) {
    const std::vector<std::string> columns = columnsOf(line);
    RecordedRow row{fromSeconds(std::stod(columns.at(0))), columns.at(1), columns.at(2), {}};
    for (std::size_t i = 3; i < columns.size() && !columns[i].empty(); ++i) row.values.push_back(std::stod(columns[i]));
    rows.push_back(std::move(row));
  }
  return rows;
}

bool Replay::isHere() { return fortressWorlds() && goldenData(); }

Replay::Replay(const std::string& world, std::vector<RecordedCommand> commands, std::vector<RecordedBattery> batteries)
    : commands_(std::move(commands)), batteries_(std::move(batteries)) {
  rows_ = readRecording(*goldenData() / "systems" / recordingOf(world));
  EXPECT_FALSE(rows_.empty()) << "no recording of " << world;
  Diagnostics diagnostics;
  simulation_ = Simulation::fromFile(*fortressWorlds() / world, {}, diagnostics);
  for (const Diagnostic& diagnostic : diagnostics.all()) {
    if (diagnostic.severity == Severity::kError) ADD_FAILURE() << format(diagnostic);
  }
  if (!simulation_) throw std::runtime_error(world + " can't be loaded");
  for (const RecordedCommand& command : commands_) {
    if (!publishers_.contains(command.topic)) {
      publishers_.emplace(command.topic, simulation_->transport().node().advertise(command.topic, command.type));
    }
  }
  for (const RecordedBattery& battery : batteries_) {
    subscriptions_.push_back(simulation_->transport().node().subscribe<ignition::msgs::BatteryState>(
        "/model/" + battery.model + "/battery/" + battery.name + "/state",
        [this, name = battery.name](const auto& state) { charges_[name] = state.percentage(); }));
  }
}

void Replay::run(const std::function<void(const RecordedRow&)>& atEach) {
  std::size_t next = 0;
  for (const RecordedRow& row : rows_) {
    // until the nearest step, because recorded times are rounded to milliseconds
    while (simulation_->time() + simulation_->stepSize() / 2 < row.time) {
      for (; next < commands_.size() && commands_[next].time <= simulation_->time(); ++next) {
        const MessagePointer message = newMessage(commands_[next].type);
        ASSERT_FALSE(parseMessage(commands_[next].text, *message)) << commands_[next].text;
        publishers_.at(commands_[next].topic).publish(*message);
      }
      simulation_->step();
    }
    compare(row);
    if (atEach) atEach(row);
  }
  for (const auto& [name, deviation] : deviations_) {
    std::printf("%s: largest %.6g at %.3f s, %.4g rad; last %.6g, %.4g rad; way %.4g m\n", name.c_str(),
                deviation.largest, toSeconds(deviation.when), deviation.largestAngle, deviation.last,
                deviation.lastAngle, deviation.way);
  }
}

void Replay::compare(const RecordedRow& row) {
  if (row.what == "battery") return compareBattery(row);
  const std::string key = row.what + " " + row.name;
  double distance = 0;
  double angle = 0;
  double way = 0;
  if (row.what == "joint") {
    const auto [modelName, jointName] = split(row.name);
    const auto model = modelOf(simulation_->world(), modelName);
    const auto joint = model ? model->joint(jointName) : std::nullopt;
    if (!joint) {
      if (std::ranges::find(missing_, key) == missing_.end()) missing_.push_back(key);
      return;
    }
    const int axes = std::min(joint->axisCount(), static_cast<int>(row.values.size()));
    for (int axis = 0; axis < axes; ++axis) {
      distance = std::max(distance, std::abs(joint->position(axis) - row.values[static_cast<std::size_t>(axis)]));
    }
  } else {
    const std::optional<Pose> pose = poseOf(simulation_->world(), row);
    if (!pose) {
      if (std::ranges::find(missing_, key) == missing_.end()) missing_.push_back(key);
      return;
    }
    const Vector3 position(row.values.at(0), row.values.at(1), row.values.at(2));
    const Quaternion rotation(row.values.at(3), row.values.at(4), row.values.at(5), row.values.at(6));
    distance = (pose->position - position).norm();
    angle = pose->rotation.angularDistance(rotation.normalized());
    const auto [last, isFirst] = lastPositions_.try_emplace(key, position);
    way = (position - last->second).norm();
    last->second = position;
  }
  Deviation& deviation = deviations_[key];
  if (distance > deviation.largest) {
    deviation.largest = distance;
    deviation.when = row.time;
  }
  deviation.largestAngle = std::max(deviation.largestAngle, angle);
  deviation.last = distance;
  deviation.lastAngle = angle;
  deviation.way += way;
}

void Replay::compareBattery(const RecordedRow& row) {
  if (batteries_.empty()) return;
  if (std::exchange(batteryTime_, row.time) != row.time) batteryCount_ = 0;
  const std::string name = batteries_.at(batteryCount_++).name;
  // deliver the message of the last step
  simulation_->transport().dispatch();
  const std::string key = "battery " + name;
  if (!charges_.contains(name)) {
    if (std::ranges::find(missing_, key) == missing_.end()) missing_.push_back(key);
    return;
  }
  Deviation& deviation = deviations_[key];
  deviation.last = std::abs(charges_.at(name) - row.values.at(0));
  if (deviation.last > deviation.largest) {
    deviation.largest = deviation.last;
    deviation.when = row.time;
  }
}

const Deviation& Replay::of(const std::string& whatAndName) const {
  const auto found = deviations_.find(whatAndName);
  if (found != deviations_.end()) return found->second;
  ADD_FAILURE() << whatAndName << " was not compared";
  static const Deviation kNone{1e9, {}, 1e9, 1e9, 1e9, 0};
  return kNone;
}

}  // namespace pongsim::test
