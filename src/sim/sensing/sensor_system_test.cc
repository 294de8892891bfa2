#include "pongsim/sensing/sensor_system.hh"

#include <gtest/gtest.h>
#include <ignition/msgs/vector3d.pb.h>

#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "pongsim/physical_properties.hh"
#include "pongsim/simulation.hh"

namespace pongsim {
namespace {

/// A sensor written like one outside this project: measures its height with noise, and counts steps.
class HeightSensor final : public SensorOf<ignition::msgs::Vector3d> {
 public:
  static constexpr SensorKind kKind{
      .text = "Publishes heights.", .type = "height", .suffix = "/height", .holder = "joint/J"};

  explicit HeightSensor(const SensorContext& context)
      : SensorOf(context),
        sensor_(context.sensor),
        noise_(context.noises.add({.type = NoiseSettings::Type::kGaussian, .standardDeviation = 1}, "height")) {
    if (sensor_.name() == "broken") throw std::runtime_error("as it must");
    if (sensor_.name() == "doubtful") context.diagnostics.warning({}, "it is doubtful");
  }

  void observe(const StepInfo&) override { ++steps_; }
  bool isReady() override { return sensor_.name() != "sleeping"; }
  void measure() override {
    message().set_x(noise_.apply(sensor_.pose().position.z()));
    message().set_y(steps_);
  }
  void reset() override { steps_ = 0; }
  void transfer(StateArchive& archive) override { archive(steps_); }

 private:
  Sensor sensor_;
  Noise& noise_;
  int steps_ = 0;
};

/// A system for two types of such sensors; each sensor has a second topic.
class HeightSystem final : public SensorSystem {
 public:
  HeightSystem()
      : SensorSystem({{.sensorType = "late", .suffix = "/late", .messageType = "ignition.msgs.Vector3d"},
                      {.sensorType = "height", .suffix = "/height", .messageType = "ignition.msgs.Vector3d"},
                      {.sensorType = "height",
                       .kind = "copies",
                       .suffix = "/height",
                       .behind = "/copies",
                       .messageType = "ignition.msgs.Vector3d"}}) {}

 protected:
  std::unique_ptr<SensorDevice> make(const SensorContext& context) override {
    if (context.sensor.type() == "height") copies_.push_back(context.advertise("copies"));
    EXPECT_THROW(context.advertise("others"), std::logic_error);
    return std::make_unique<HeightSensor>(context);
  }

 private:
  std::vector<Publisher> copies_;
};

std::string modelWith(const std::string& name, const std::string& sensor, const std::string& type = "height") {
  return "<model name='" + name + "'><static>true</static><pose>0 0 5 0 0 0</pose><link name='l'><sensor name='" +
         sensor + "' type='" + type + "'/></link></model>";
}

class SensorSystemTest : public testing::Test {
 protected:
  void start(const std::string& models, std::unique_ptr<System> system) {
    Diagnostics diagnostics;
    simulation_ = Simulation::fromText("<sdf version='1.9'><world name='w'>" + models + "</world></sdf>", "world.sdf",
                                       {}, diagnostics);
    ASSERT_NE(simulation_, nullptr);
    Diagnostics found;
    ASSERT_TRUE(simulation_->addSystem("heights", std::move(system), found));
    for (const Diagnostic& diagnostic : found.all()) complaints_.push_back(diagnostic.message);
  }

  void listen(const std::string& sensor, const std::string& suffix = "/height") {
    const std::string topic = "/world/w/model/" + sensor + "/link/l/sensor/" + sensor + suffix;
    subscriptions_.push_back(simulation_->transport().node().subscribe<ignition::msgs::Vector3d>(
        topic, [this, sensor](const ignition::msgs::Vector3d& message) { heard_[sensor].push_back(message); }));
  }

  /// @return The measurements of a few steps, as text.
  std::string measured() {
    heard_.clear();
    simulation_->step(3);
    simulation_->transport().dispatch();
    std::string text;
    for (const auto& [sensor, messages] : heard_) {
      for (const ignition::msgs::Vector3d& message : messages) text += sensor + messageText(message);
    }
    return text;
  }

  std::unique_ptr<Simulation> simulation_;
  std::vector<std::string> complaints_;
  std::map<std::string, std::vector<ignition::msgs::Vector3d>> heard_;
  std::vector<Subscription> subscriptions_;
};

TEST_F(SensorSystemTest, PublishesWhatASensorMeasuresWithItsHeader) {
  start(modelWith("a", "a"), std::make_unique<SensorSystemFor<HeightSensor>>());
  listen("a");
  measured();
  ASSERT_EQ(heard_["a"].size(), 3U);
  const ignition::msgs::Vector3d& last = heard_["a"].back();
  EXPECT_NE(last.x(), 5);
  EXPECT_NEAR(last.x(), 5, 10);
  EXPECT_EQ(last.y(), 3);
  EXPECT_EQ(last.header().data(0).key(), "frame_id");
  EXPECT_EQ(last.header().data(0).value(0), "a::l::a");
  EXPECT_EQ(last.header().data(1).value(0), "2");
  EXPECT_EQ(last.header().stamp().nsec(), 3'000'000);
}

TEST_F(SensorSystemTest, DescribesItself) {
  SensorSystemFor<HeightSensor> system;
  Declaration declaration;
  system.declare(declaration);
  EXPECT_EQ(declaration.text(), "Publishes heights.");
  ASSERT_FALSE(declaration.endpoints().empty());
  EXPECT_EQ(declaration.endpoints()[0].name, "/world/W/model/M/joint/J/sensor/S/height");
  EXPECT_EQ(declaration.endpoints()[0].type, "ignition.msgs.Vector3d");
}

TEST_F(SensorSystemTest, HasReadingsThatProgramsFindByTheSensorsType) {
  start(modelWith("a", "a"), std::make_unique<HeightSystem>());
  const std::vector<SensorReadings> readings = simulation_->readings("height");
  ASSERT_EQ(readings.size(), 2U);
  EXPECT_EQ(readings[0].kind, "message");
  EXPECT_EQ(readings[1].kind, "copies");
  EXPECT_EQ(readings[1].messageType, "ignition.msgs.Vector3d");
  EXPECT_EQ(simulation_->world().sensors("height").at(0).topic(readings[1]),
            "/world/w/model/a/link/l/sensor/a/height/copies");
  EXPECT_TRUE(simulation_->readings("imu").empty());
}

TEST_F(SensorSystemTest, TakesNoReadingOfASensorThatIsNotReady) {
  start(modelWith("sleeping", "sleeping"), std::make_unique<HeightSystem>());
  listen("sleeping");
  EXPECT_EQ(measured(), "");
}

TEST_F(SensorSystemTest, LeavesOutASensorThatCantBeMade) {
  start(modelWith("broken", "broken") + modelWith("doubtful", "doubtful"), std::make_unique<HeightSystem>());
  EXPECT_EQ(complaints_,
            (std::vector<std::string>{"sensor 'broken::l::broken' is left out: as it must", "it is doubtful"}));
}

TEST_F(SensorSystemTest, RepeatsItsNoiseAfterAReset) {
  // sensors of two types, in another order than the system's, after one that is left out
  start(modelWith("broken", "broken") + modelWith("a", "a") + modelWith("b", "b", "late") + modelWith("c", "c"),
        std::make_unique<HeightSystem>());
  listen("a");
  listen("b", "/late");
  listen("c");
  const std::string first = measured();
  EXPECT_EQ(heard_.size(), 3U);
  EXPECT_NE(measured(), first);
  Diagnostics diagnostics;
  simulation_->reset(diagnostics);
  EXPECT_EQ(measured(), first);
}

TEST_F(SensorSystemTest, GoesOnFromASavedState) {
  start(modelWith("a", "a"), std::make_unique<HeightSystem>());
  listen("a");
  measured();
  const std::vector<std::byte> state = simulation_->saveState();
  const std::string next = measured();
  EXPECT_NE(measured(), next);
  EXPECT_TRUE(simulation_->restoreState(state));
  EXPECT_EQ(measured(), next);
}

TEST_F(SensorSystemTest, MakesTheNoiseOfItsSensorsKnown) {
  start(modelWith("a", "a") + modelWith("b", "b"), std::make_unique<SensorSystemFor<HeightSensor>>());
  listen("a");
  const std::string before = measured();
  PhysicalProperties properties(simulation_->world());
  const Sensor sensor = simulation_->world().model("a")->link("l")->sensors().front();
  const auto noises = properties.noises(sensor);
  ASSERT_EQ(noises.size(), 1U);
  EXPECT_EQ(noises[0].value, "height");
  EXPECT_EQ(noises[0].noise.standardDeviation, 1);
  NoiseSettings none;
  ASSERT_TRUE(properties.setNoise(sensor, "height", none));
  measured();
  EXPECT_EQ(heard_["a"].back().x(), 5);
  EXPECT_EQ(properties.setNoise(sensor, "depth", none).error,
            "sensor 'a::l::a' has no noise of a value 'depth'; it has 'height'");
  NoiseSettings bad;
  bad.standardDeviation = -1;
  EXPECT_FALSE(properties.setNoise(sensor, "height", bad));
  Diagnostics diagnostics;
  simulation_->reset(diagnostics);
  EXPECT_EQ(measured(), before);
  ASSERT_TRUE(simulation_->remove(simulation_->world().model("a").value()));
  EXPECT_EQ(properties.noises(simulation_->world().model("b")->link("l")->sensors().front()).size(), 1U);
}

TEST_F(SensorSystemTest, PublishesSeveralSensorsOnOneTopic) {
  const auto onTopic = [](const std::string& model) {
    return "<model name='" + model + "'><static>true</static><link name='l'><sensor name='s' type='height'>" +
           "<topic>/shared</topic></sensor></link></model>";
  };
  start(onTopic("a"), std::make_unique<HeightSystem>());
  std::vector<std::string> frames;
  subscriptions_.push_back(simulation_->transport().node().subscribe<ignition::msgs::Vector3d>(
      "/shared",
      [&frames](const ignition::msgs::Vector3d& message) { frames.push_back(message.header().data(0).value(0)); }));
  Diagnostics diagnostics;
  testing::internal::CaptureStderr();
  ASSERT_TRUE(simulation_->insertCopy(*simulation_->world().model("a"), {.name = "b"}, diagnostics));
  EXPECT_NE(testing::internal::GetCapturedStderr().find(
                "the rate of sensor 'b::l::s' can't be changed: service '/shared/set_rate' is already offered"),
            std::string::npos);
  simulation_->step();
  simulation_->transport().dispatch();
  EXPECT_EQ(frames, (std::vector<std::string>{"a::l::s", "b::l::s"}));
}

TEST_F(SensorSystemTest, MakesSensorsOfModelsThatAreInsertedAndEndsThoseOfRemovedOnes) {
  start("", std::make_unique<HeightSystem>());
  listen("a");
  for (int time = 0; time < 2; ++time) {
    Diagnostics diagnostics;
    const auto model =
        simulation_->insertText("<sdf version='1.9'>" + modelWith("a", "a") + "</sdf>", "a.sdf", {}, diagnostics);
    ASSERT_TRUE(model);
    EXPECT_NE(measured(), "");
    ASSERT_TRUE(simulation_->remove(*model));
    EXPECT_EQ(measured(), "");
  }
}

}  // namespace
}  // namespace pongsim
