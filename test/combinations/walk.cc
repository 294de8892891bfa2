#include "combinations/walk.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <ranges>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "pongsim/message.hh"
#include "pongsim/sensing/sensor.hh"

namespace pongsim::test {

namespace {

constexpr int kSteps = 3;
constexpr const char* kScout = "scout";

void expectNoErrors(const Diagnostics& diagnostics) {
  for (const Diagnostic& diagnostic : diagnostics.all()) {
    if (diagnostic.severity == Severity::kError) ADD_FAILURE() << format(diagnostic);
  }
}

bool isNear(const Pose& one, const Pose& other) {
  return (one.position - other.position).norm() < 1e-6 && one.rotation.angularDistance(other.rotation) < 1e-6;
}

/// @return The types of all sensors of a model and of its nested models.
void addSensorTypes(const Model& model, std::set<std::string>& types) {
  for (const Link& link : model.links()) {
    for (const Sensor& sensor : link.sensors()) types.emplace(sensor.type());
  }
  for (const Joint& joint : model.joints()) {
    for (const Sensor& sensor : joint.sensors()) types.emplace(sensor.type());
  }
  for (const Model& nested : model.models()) addSensorTypes(nested, types);
}

}  // namespace

Walk::Walk(const Kind& kind, Simulation& simulation, std::vector<Simulation*> beside)
    : kind_(kind), simulation_(simulation), beside_(std::move(beside)), isAlone_(beside_.empty()) {
  settle();
  noteModels();
  noteTopics();
  start_ = simulation_.stateHash();
  step();
  afterStart_ = simulation_.stateHash();
}

void Walk::make(Operation operation) {
  SCOPED_TRACE(nameOf(operation));
  isRestored_ = false;
  change(operation);
  settle();
  heard_.clear();
  step();
  noteModels();
  noteTopics();
  expectStatesAfter(operation);
  expectHandles();
  if (kind_.publishesInEachStep && !subscriptions_.empty()) {
    for (const std::string& topic : sensorTopics()) {
      // one that a model has brought after the subscriptions were made is not among them
      if (listened_.contains(topic)) {
        EXPECT_GT(heard_[topic], 0) << topic;
      }
    }
  }
}

void Walk::change(Operation operation) {
  switch (operation) {
    case Operation::kInsert:
      return insert();
    case Operation::kCopy:
      return copy();
    case Operation::kInsertWithin:
      return insertWithin();
    case Operation::kRemoveFirst:
      return remove(true);
    case Operation::kRemoveAll:
      return remove(false);
    case Operation::kMove:
      return move();
    case Operation::kReset:
      return reset();
    case Operation::kSave:
      return save();
    case Operation::kRestore:
      return restore();
    case Operation::kLeave:
      return moveScout(1e4);
    case Operation::kReturn:
      return moveScout(0);
    case Operation::kListen:
      return listen();
    case Operation::kDeafen:
      return subscriptions_.clear();
    case Operation::kCommand:
      return command();
    case Operation::kLight:
      return changeLight();
    case Operation::kAttach:
      return attach();
    case Operation::kPause:
      return simulation_.stepPaused();
  }
}

void Walk::insert() {
  for (const KindModel& model : kind_.models) {
    const bool isFree = simulation_.world().isNameFree(model.name);
    Diagnostics diagnostics;
    const std::optional<Model> inserted = simulation_.insertText(model.document, model.name, {}, diagnostics);
    EXPECT_EQ(inserted.has_value(), isFree) << model.name;
    if (!inserted) continue;
    origins_.emplace(inserted->id(), model.name);
    expectNoErrors(diagnostics);
    EXPECT_EQ(inserted->name(), model.name);
    EXPECT_TRUE(inserted->isInserted());
  }
}

void Walk::copy() {
  for (const Model& model : simulation_.world().models()) {
    if (model.name() == kScout) continue;
    const Pose pose{Vector3(0, 20, 3), Quaternion::Identity()};
    const bool isFree = simulation_.world().isNameFree("copy");
    Diagnostics diagnostics;
    const std::optional<Model> copied = simulation_.insertCopy(model, {.name = "copy", .pose = pose}, diagnostics);
    EXPECT_EQ(copied.has_value(), isFree);
    if (!copied) return;
    origins_.emplace(copied->id(), origins_.contains(model.id()) ? origins_.at(model.id()) : std::string(model.name()));
    expectNoErrors(diagnostics);
    EXPECT_TRUE(isNear(copied->pose(), pose));
    return;
  }
}

void Walk::insertWithin() {
  if (kind_.models.empty()) return;
  const KindModel& model = kind_.models.front();
  const bool isFree = simulation_.world().isNameFree("within");
  const InsertOptions options{
      .name = "within", .pose = Pose{Vector3(0, -20, 3), Quaternion::Identity()}, .nameSpace = "/within"};
  Diagnostics diagnostics;
  const std::optional<Model> inserted = simulation_.insertText(model.document, model.name, options, diagnostics);
  EXPECT_EQ(inserted.has_value(), isFree);
  if (!inserted) return;
  origins_.emplace(inserted->id(), model.name);
  expectNoErrors(diagnostics);
}

void Walk::remove(bool isFirstOnly) {
  for (const Model& model :
       std::vector<Model>(std::views::values(models_).begin(), std::views::values(models_).end())) {
    if (model.isSetAside()) {
      EXPECT_FALSE(simulation_.remove(model));
      EXPECT_TRUE(model.isSetAside());
    } else if (model.exists() && model.name() != kScout) {
      const std::string name(model.name());
      const Outcome<void> removed = simulation_.remove(model);
      EXPECT_TRUE(removed) << removed.error;
      EXPECT_FALSE(model.exists() || model.isSetAside());
      EXPECT_THROW(model.pose(), Gone);
      EXPECT_FALSE(simulation_.world().model(name));
      if (isFirstOnly) return;
    }
  }
}

void Walk::move() {
  const Pose X_BeforeAfter{Vector3(0.1, 0, 0.2), rotationAbout(Vector3::UnitZ(), 0.3)};
  for (Model model : std::views::values(models_)) {
    if (model.isSetAside()) {
      EXPECT_THROW(model.setPose({}), Gone);
    } else if (model.exists() && model.name() != kScout) {
      const Pose before = model.pose();
      const Outcome<void> moved = model.setPose(before * X_BeforeAfter);
      EXPECT_TRUE(isNear(model.pose(), moved ? before * X_BeforeAfter : before)) << model.name();
      EXPECT_TRUE(moved || moved.error.find("joint") != std::string::npos) << moved.error;
    }
  }
}

void Walk::reset() {
  Diagnostics diagnostics;
  simulation_.reset(diagnostics);
  expectNoErrors(diagnostics);
  EXPECT_EQ(simulation_.stateHash(), start_);
}

void Walk::save() {
  saved_ = Saved{.state = simulation_.saveState(), .hash = simulation_.stateHash()};
  describeModels(saved_);
}

void Walk::restore() {
  if (saved_.state.empty()) return;
  Saved now;
  describeModels(now);
  const std::uint64_t before = simulation_.stateHash();
  const Outcome<void> restored = simulation_.restoreState(saved_.state);
  EXPECT_EQ(simulation_.stateHash(), restored ? saved_.hash : before);
  EXPECT_TRUE(!restored || now.names == saved_.names) << "a state of other models is restored";
  // joints of a model that was inserted again have other ids
  EXPECT_TRUE(restored || now.ids != saved_.ids) << restored.error;
  isRestored_ = restored && now.origins == saved_.origins;
}

void Walk::moveScout(double x) {
  EXPECT_TRUE(simulation_.world().model(kScout)->setPose({Vector3(x, 0, 0), Quaternion::Identity()}));
}

void Walk::listen() {
  subscriptions_.clear();
  for (const auto& [name, type] : topics_) {
    listened_.insert(name);
    subscriptions_.push_back(
        simulation_.transport().node().subscribe(name, type, [this, name = name](const Message&) { ++heard_[name]; }));
  }
}

void Walk::command() {
  for (const KindCommand& command : kind_.commands) publish(command.topic, command.type, command.text);
  for (const OwnTopic& topic : simulation_.transport().node().ownTopics()) {
    if (topic.publishers == 0 && topic.type != "*") publish(topic.name, topic.type, "");
  }
}

void Walk::publish(const std::string& topic, const std::string& type, const std::string& text) {
  Publisher& publisher = publishers_[topic];
  if (!publisher) publisher = simulation_.transport().node().advertise(topic, type);
  const MessagePointer message = newMessage(type);
  EXPECT_FALSE(parseMessage(text, *message)) << text;
  publisher.publish(*message);
}

void Walk::changeLight() {
  const std::string name = "light of the walk";
  if (!simulation_.world().isNameFree(name)) {
    EXPECT_TRUE(simulation_.removeLight({}, name));
    EXPECT_TRUE(simulation_.world().isNameFree(name));
    return;
  }
  const MessagePointer message = newMessage("ignition.msgs.Light");
  EXPECT_FALSE(parseMessage("name: '" + name + "', type: POINT, diffuse {r: 1, a: 1}, range: 5", *message));
  const Outcome<std::string> inserted = simulation_.insertLight(*message, {});
  EXPECT_TRUE(inserted) << inserted.error;
  EXPECT_FALSE(simulation_.world().isNameFree(name));
}

void Walk::attach() {
  for (const Joint& joint : joints_) {
    if (!joint.exists()) continue;
    EXPECT_TRUE(simulation_.world().detach(joint));
    EXPECT_FALSE(joint.exists());
    return;
  }
  std::vector<Link> links;
  for (const Model& model : simulation_.world().models()) {
    if (model.name() != kScout && model.canonicalLink()) links.push_back(*model.canonicalLink());
  }
  if (links.size() < 2) return;
  const std::uint64_t before = simulation_.stateHash();
  Outcome<Joint> joint = simulation_.world().attach(links.front(), links.back());
  if (joint) {
    EXPECT_TRUE(joint->exists());
    joints_.push_back(*joint);
  } else {
    EXPECT_EQ(simulation_.stateHash(), before) << joint.error;
  }
}

bool Walk::isAttached() const { return std::ranges::any_of(joints_, &Joint::exists); }

void Walk::step() {
  for (int i = 0; i < kSteps; ++i) {
    simulation_.step();
    for (Simulation* other : beside_) other->step();
  }
  settle();
}

void Walk::settle() {
  // messages in transit are not part of a saved state; those that systems send in reply are in transit again
  for (int i = 0; i < 10 && simulation_.transport().dispatch() > 0; ++i) {
  }
}

void Walk::noteTopics() {
  for (const OwnTopic& topic : simulation_.transport().node().ownTopics()) {
    if (topic.publishers > 0) topics_.emplace(topic.name, topic.type);
  }
}

void Walk::noteModels() {
  std::erase_if(models_, [](const auto& entry) { return !entry.second.exists() && !entry.second.isSetAside(); });
  for (const Model& model : simulation_.world().models()) {
    models_.emplace(model.id(), model);
    names_.emplace(model.id(), model.name());
    // one that a system has inserted may have begun anywhere
    if (model.isInserted()) origins_.emplace(model.id(), std::to_string(model.id().value));
  }
}

void Walk::describeModels(Saved& saved) {
  noteModels();
  for (const auto& [id, model] : models_) {
    saved.ids.push_back(id);
    saved.names.push_back(names_.at(id));
    const auto origin = origins_.find(id);
    saved.origins.push_back(origin == origins_.end() ? names_.at(id) : origin->second);
  }
}

void Walk::expectStatesAfter(Operation operation) {
  const std::uint64_t hash = simulation_.stateHash();
  if (operation == Operation::kSave) saved_.later = hash;
  if (!isAlone_) return;
  if (operation == Operation::kReset) {
    EXPECT_EQ(hash, afterStart_);
  }
  if (isRestored_) {
    EXPECT_EQ(hash, saved_.later);
  }
}

void Walk::expectHandles() {
  std::size_t setAside = 0;
  for (const Model& model : std::views::values(models_)) {
    if (model.isSetAside()) {
      ++setAside;
      continue;
    }
    EXPECT_TRUE(model.pose().position.allFinite()) << model.name();
    EXPECT_TRUE(simulation_.world().model(model.name())) << model.name();
  }
  EXPECT_EQ(setAside, simulation_.countSetAside());
  const bool isAway = simulation_.world().model(kScout)->pose().position.x() != 0;
  if (!isAway) {
    EXPECT_EQ(setAside, 0U);
  }
  // otherwise what is in the file is only there where a performer of its own or a joint keeps it
  if (!isAway || !kind_.performers.empty() || !kind_.commands.empty() || isAttached()) return;
  for (const Model& model : simulation_.world().models()) {
    EXPECT_TRUE(model.name() == kScout || model.isInserted()) << model.name();
  }
}

std::set<std::string> Walk::sensorTopics() {
  std::set<std::string> types;
  for (const Model& model : simulation_.world().models()) addSensorTypes(model, types);
  std::set<std::string> topics;
  for (const std::string& type : types) {
    for (const SensorReadings& readings : simulation_.readings(type)) {
      for (const Sensor& sensor : simulation_.world().sensors(type)) {
        const std::string topic = sensor.topic(readings);
        topics.insert(topic.starts_with('/') ? topic : "/" + topic);
      }
    }
  }
  return topics;
}

void Walk::expectReadings() {
  make(Operation::kReset);
  make(Operation::kListen);
  // the slowest sensors have 5 Hz
  std::set<std::string> silent = sensorTopics();
  for (int i = 0; i < 100 && !silent.empty(); ++i) {
    step();
    std::erase_if(silent, [this](const std::string& topic) { return heard_.contains(topic); });
  }
  for (const std::string& topic : silent) ADD_FAILURE() << topic << " is silent after a reset";
}

}  // namespace pongsim::test
