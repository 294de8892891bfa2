#include <numbers>

#include "support/sdf/load_support.hh"

namespace pongsim::sdf::test {
namespace {

TEST(Environment, HasTheDefaultsOfTheFormat) {
  const Loaded loaded = loadWorld("");
  const description::Environment& environment = loaded.world().environment;
  EXPECT_EQ(environment.wind, Vector3(0, 0, 0));
  EXPECT_EQ(environment.magneticField, Vector3(5.5645e-6, 22.8758e-6, -42.3884e-6));
  EXPECT_EQ(environment.atmosphere.temperature, 288.15);
  EXPECT_EQ(environment.atmosphere.temperatureGradient, -0.0065);
  EXPECT_EQ(environment.atmosphere.pressure, 101325);
  EXPECT_FALSE(environment.sphericalCoordinates.isGiven);
  EXPECT_EQ(environment.sphericalCoordinates.surfaceModel, "EARTH_WGS84");
  EXPECT_EQ(environment.sphericalCoordinates.worldFrameOrientation, "ENU");
  EXPECT_EQ(environment.sphericalCoordinates.latitude, 0);
}

TEST(Environment, IsRead) {
  const Loaded loaded = loadWorld(
      "<wind><linear_velocity>1 2 3</linear_velocity></wind><magnetic_field>4 5 6</magnetic_field>"
      "<atmosphere type='adiabatic'><temperature>300</temperature><temperature_gradient>-1</temperature_gradient>"
      "<pressure>99000</pressure></atmosphere><spherical_coordinates><surface_model>MOON_SCS</surface_model>"
      "<world_frame_orientation>NED</world_frame_orientation><latitude_deg>90</latitude_deg>"
      "<longitude_deg>-180</longitude_deg><elevation>7</elevation><heading_deg>45</heading_deg>"
      "</spherical_coordinates>");
  EXPECT_EQ(loaded.messages, Messages());
  const description::Environment& environment = loaded.world().environment;
  EXPECT_EQ(environment.wind, Vector3(1, 2, 3));
  EXPECT_EQ(environment.magneticField, Vector3(4, 5, 6));
  EXPECT_EQ(environment.atmosphere.temperature, 300);
  EXPECT_EQ(environment.atmosphere.temperatureGradient, -1);
  EXPECT_EQ(environment.atmosphere.pressure, 99000);
  EXPECT_TRUE(environment.sphericalCoordinates.isGiven);
  EXPECT_EQ(environment.sphericalCoordinates.surfaceModel, "MOON_SCS");
  EXPECT_EQ(environment.sphericalCoordinates.worldFrameOrientation, "NED");
  EXPECT_DOUBLE_EQ(environment.sphericalCoordinates.latitude, std::numbers::pi / 2);
  EXPECT_DOUBLE_EQ(environment.sphericalCoordinates.longitude, -std::numbers::pi);
  EXPECT_EQ(environment.sphericalCoordinates.elevation, 7);
  EXPECT_DOUBLE_EQ(environment.sphericalCoordinates.heading, std::numbers::pi / 4);
}

TEST(Environment, HasNoWindFasterThanAnyIs) {
  const Loaded loaded = loadWorld("<wind><linear_velocity>1e6 0 1</linear_velocity></wind>");
  EXPECT_EQ(loaded.messages, (Messages{"t.sdf:2:7: warning: a wind of '1e6 0 1' m/s is ignored: the limit is 10000 m/s "
                                       "| a hurricane reaches 50 m/s"}));
  EXPECT_EQ(loaded.world().environment.wind, Vector3(0, 0, 0));
  EXPECT_EQ(loadWorld("<wind><linear_velocity>1e308 1e308 0</linear_velocity></wind>").messages.size(), 1U);
  EXPECT_EQ(loadWorld("<wind><linear_velocity>0 1e4 0</linear_velocity></wind>").messages, Messages());
}

TEST(Environment, ThatIsWrongIsAnError) {
  EXPECT_EQ(loadWorld("<wind><linear_velocity>1 2</linear_velocity></wind>\n<magnetic_field>x</magnetic_field>\n"
                      "<atmosphere><pressure>0</pressure></atmosphere>\n"
                      "<spherical_coordinates><latitude_deg>north</latitude_deg></spherical_coordinates>")
                .messages,
            (Messages{"t.sdf:2:7: error: <linear_velocity> is '1 2', which is not three finite numbers | there are 2 "
                      "numbers",
                      "t.sdf:3:1: error: <magnetic_field> is 'x', which is not three finite numbers",
                      "t.sdf:4:13: error: <pressure> is '0', which is not a finite number above zero",
                      "t.sdf:5:24: error: <latitude_deg> is 'north', which is not a number"}));
}

}  // namespace
}  // namespace pongsim::sdf::test
