#include "sdf/readers/shapes/data_systems.hh"

#include <limits>

#include "support/sdf/load_support.hh"

namespace pongsim::sdf::test {
namespace {

std::string plugin(const std::string& name, const std::string& className, const std::string& content) {
  return "<plugin filename='ignition-gazebo-" + name + "-system' name='ignition::gazebo::systems::" + className + "'>" +
         content + "</plugin>";
}

std::string label(const std::string& content) { return plugin("label", "Label", "<label>" + content + "</label>"); }

std::string thermal(const std::string& content) { return plugin("thermal", "Thermal", content); }

Loaded loadVisual(const std::string& content) {
  return loadLink("<visual name='v'>" + content + "<geometry><sphere><radius>1</radius></sphere></geometry></visual>");
}

const description::Visual& visualOf(const Loaded& loaded) { return loaded.model().links.at(0).visuals.at(0); }

Loaded loadThermal(const std::string& content) {
  return loadLink("<sensor name='s' type='thermal'><camera/>" + plugin("thermal-sensor", "ThermalSensor", content) +
                  "</sensor>");
}

const ThermalSettings& settingsOf(const Loaded& loaded) {
  return std::get<CameraSettings>(loaded.model().links.at(0).sensors.at(0).settings).thermal;
}

TEST(DataSystems, LabelVisualsModelsAndActors) {
  const Loaded loaded = loadWorld(
      "<model name='m'><link name='l'/>" + label("40") + "<model name='n'><link name='l'><visual name='v'>" +
      label("0") + "<geometry><sphere><radius>1</radius></sphere></geometry></visual></link></model></model>" +
      "<actor name='a'>" + label("255") + "</actor>");
  EXPECT_EQ(loaded.messages, Messages());
  EXPECT_EQ(loaded.model().label, 40);
  EXPECT_EQ(loaded.model().models.at(0).label, std::nullopt);
  EXPECT_EQ(loaded.model().models.at(0).links.at(0).visuals.at(0).label, 0);
  EXPECT_EQ(loaded.world().actors.at(0).label, 255);
}

TEST(DataSystems, OfWhichTheLastCounts) {
  EXPECT_EQ(visualOf(loadVisual(label("1") + label("2"))).label, 2);
  EXPECT_EQ(visualOf(loadVisual("<plugin filename='gz-sim-label-system' name=''><label>3</label></plugin>")).label, 3);
  EXPECT_EQ(visualOf(loadVisual("<plugin filename='x' name='my::Label'><label>3</label></plugin>")).label,
            std::nullopt);
}

TEST(DataSystems, WarnOfLabelsThatAreNone) {
  const auto message = [](const std::string& content) {
    const Loaded loaded = loadVisual(content);
    EXPECT_EQ(visualOf(loaded).label, std::nullopt);
    return loaded.messages.at(0);
  };
  EXPECT_EQ(message("\n" + label("65536")),
            "t.sdf:5:89: warning: label of visual 'v' of link 'l' of model 'm': <label> is '65536', which is not an "
            "integer from 0 to 255 | it has no effect");
  EXPECT_NE(message(label("-1")).find("is '-1', which is not an integer from 0 to 255"), std::string::npos);
  EXPECT_NE(message(label("1.5")).find("is '1.5', which is not an integer from 0 to 255"), std::string::npos);
  EXPECT_NE(message(label("red")).find("is 'red', which is not a finite number"), std::string::npos);
  EXPECT_NE(message(plugin("label", "Label", ""))
                .find("label of visual 'v' of link 'l' of model 'm' is left out: it has no <label>"),
            std::string::npos);
}

TEST(DataSystems, GiveVisualsATemperature) {
  EXPECT_EQ(visualOf(loadVisual("")).heat, std::nullopt);
  EXPECT_EQ(visualOf(loadVisual(thermal("<temperature>285.5</temperature>"))).heat,
            (description::Heat{.temperature = 285.5}));
  const Loaded cold = loadVisual(thermal("<temperature>-10</temperature>"));
  EXPECT_EQ(visualOf(cold).heat, description::Heat());
  ASSERT_EQ(cold.messages.size(), 1U);
  EXPECT_NE(cold.messages[0].find("<temperature> is below absolute zero | 0 K is used"), std::string::npos)
      << cold.messages[0];
  for (const char* wrong : {"", "<temperature>nan</temperature>", "<temperature>warm</temperature>"}) {
    const Loaded loaded = loadVisual(thermal(wrong));
    EXPECT_EQ(visualOf(loaded).heat, std::nullopt) << wrong;
    EXPECT_EQ(loaded.messages.size(), 1U) << wrong;
  }
}

TEST(DataSystems, WarnOfASignatureThatIsNotThere) {
  const Loaded loaded = loadVisual(thermal("<heat_signature>no_such.png</heat_signature>"));
  EXPECT_EQ(visualOf(loaded).heat, std::nullopt);
  ASSERT_EQ(loaded.messages.size(), 2U);
  EXPECT_NE(loaded.messages[0].find("thermal of visual 'v' of link 'l' of model 'm' is left out: its <heat_signature>"),
            std::string::npos)
      << loaded.messages[0];
  EXPECT_NE(loaded.messages[1].find("<heat_signature> 'no_such.png' is not found"), std::string::npos)
      << loaded.messages[1];
}

TEST(DataSystems, SetHowAThermalCameraShowsTemperatures) {
  EXPECT_EQ(settingsOf(loadThermal("")), ThermalSettings());
  const ThermalSettings settings =
      settingsOf(loadThermal("<min_temp>253.15</min_temp><max_temp>673.15</max_temp><resolution>3</resolution>"));
  EXPECT_EQ(settings.resolution, 3);
  EXPECT_EQ(settings.coldest, 253.15);
  EXPECT_EQ(settings.hottest, 673.15);
  // each alone, as in Fortress
  EXPECT_EQ(settingsOf(loadThermal("<min_temp>250</min_temp>")).hottest, std::numeric_limits<double>::infinity());
  EXPECT_EQ(settingsOf(loadThermal("<max_temp>250</max_temp>")).coldest, 0);
}

TEST(DataSystems, WarnOfRangesTheWrongWayRound) {
  const Loaded loaded = loadThermal("<min_temp>999</min_temp><max_temp>-590</max_temp><resolution>0.0</resolution>");
  EXPECT_EQ(settingsOf(loaded), ThermalSettings());
  ASSERT_EQ(loaded.messages.size(), 2U);
  EXPECT_NE(loaded.messages[0].find("<min_temp> is above <max_temp> | all temperatures are shown"), std::string::npos)
      << loaded.messages[0];
  EXPECT_NE(
      loaded.messages[1].find("thermal-sensor of sensor 's': <resolution> is not above zero | the default is used"),
      std::string::npos)
      << loaded.messages[1];
}

}  // namespace
}  // namespace pongsim::sdf::test
