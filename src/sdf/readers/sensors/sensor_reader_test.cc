#include <limits>

#include "support/sdf/load_support.hh"

namespace pongsim::sdf::test {
namespace {

const description::Sensor& sensorOf(const Loaded& loaded) { return loaded.model().links.at(0).sensors.at(0); }

TEST(Sensor, ReadsWhatAllTypesHave) {
  const Loaded loaded = loadLink(
      "<sensor name='s' type='imu'><pose>1 0 0 0 0 0</pose><topic>imu</topic><update_rate>30</update_rate>"
      "<always_on>1</always_on></sensor>");
  EXPECT_EQ(loaded.messages, Messages());
  const description::Sensor& sensor = sensorOf(loaded);
  EXPECT_EQ(sensor.name, "s");
  EXPECT_EQ(sensor.type, "imu");
  EXPECT_EQ(sensor.position.line, 4);
  expectPose(sensor.X_ParentSensor, {1, 0, 0});
  EXPECT_EQ(sensor.topic, "imu");
  EXPECT_EQ(sensor.frame, "");
  EXPECT_EQ(sensor.updateRate, 30);
  EXPECT_TRUE(sensor.alwaysOn);
  EXPECT_NE(sensor.sdf.child("topic"), nullptr);
}

TEST(Sensor, HasTheDefaultsOfTheFormat) {
  const Loaded loaded = loadLink("<sensor name='s' type='imu'/>");
  EXPECT_EQ(sensorOf(loaded).updateRate, 0);
  EXPECT_FALSE(sensorOf(loaded).alwaysOn);
  const ImuSettings& imu = std::get<ImuSettings>(sensorOf(loaded).settings);
  EXPECT_TRUE(imu.enableOrientation);
  EXPECT_EQ(imu.localization, "");
}

TEST(Sensor, ReadsAnImu) {
  const Loaded loaded = loadLink(
      "<sensor name='s' type='imu'><imu><enable_orientation>false</enable_orientation>"
      "<orientation_reference_frame><custom_rpy parent_frame='world'>0 0 1</custom_rpy></orientation_reference_frame>"
      "<angular_velocity><z><noise type='gaussian'><mean>1</mean></noise></z></angular_velocity>"
      "<linear_acceleration><y><noise type='gaussian'><mean>2</mean></noise></y></linear_acceleration></imu></sensor>");
  EXPECT_EQ(loaded.messages, Messages());
  const ImuSettings& imu = std::get<ImuSettings>(sensorOf(loaded).settings);
  EXPECT_FALSE(imu.enableOrientation);
  EXPECT_EQ(imu.localization, "CUSTOM");
  EXPECT_LT(imu.customRotation.angularDistance(fromRollPitchYaw(0, 0, 1)), 1e-9);
  EXPECT_EQ(imu.angularVelocity[2].mean, 1);
  EXPECT_EQ(imu.linearAcceleration[1].mean, 2);
  EXPECT_EQ(imu.linearAcceleration[0].type, NoiseSettings::Type::kNone);
}

TEST(Sensor, WarnsOfAnImuWhoseFrameIsMeasuredElsewhere) {
  const Loaded loaded = loadLink(
      "<sensor name='s' type='imu'><imu><orientation_reference_frame>\n"
      "<custom_rpy>0 0 1</custom_rpy></orientation_reference_frame></imu></sensor>");
  EXPECT_EQ(loaded.messages, Messages{"t.sdf:5:1: warning: <custom_rpy> is used only with parent_frame=\"world\" | the "
                                      "orientation is relative to the initial one instead"});
  EXPECT_EQ(std::get<ImuSettings>(sensorOf(loaded).settings).localization, "");
}

TEST(Sensor, ReadsAContactSensor) {
  const Loaded loaded = loadLink(
      "<sensor name='s' type='contact'><topic>not_this</topic><contact><collision>a</collision><collision>b</collision>"
      "<topic>felt</topic></contact></sensor><sensor name='t' type='contact'><contact><collision>a</collision>"
      "<topic>__default_topic__</topic></contact></sensor>");
  EXPECT_EQ(loaded.messages, Messages());
  EXPECT_EQ(std::get<ContactSettings>(sensorOf(loaded).settings).collisions, (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(sensorOf(loaded).topic, "felt");
  EXPECT_EQ(loaded.model().links.at(0).sensors.at(1).topic, "");
}

TEST(Sensor, WarnsOfAContactSensorThatFeelsNothing) {
  EXPECT_EQ(loadLink("<sensor name='s' type='contact'/>").messages,
            Messages{"t.sdf:4:1: warning: sensor 's' has no <collision>: it will report no contacts | write "
                     "<contact><collision>NAME</collision></contact>"});
}

TEST(Sensor, ReadsTheSmallTypes) {
  const std::string noise = "<noise type='gaussian'><mean>1</mean></noise>";
  const Loaded loaded = loadLink(
      "<sensor name='a' type='altimeter'><altimeter><vertical_velocity>" + noise + "</vertical_velocity></altimeter>" +
      "</sensor><sensor name='b' type='air_pressure'><air_pressure><pressure>" + noise + "</pressure></air_pressure>" +
      "</sensor><sensor name='c' type='magnetometer'><magnetometer><z>" + noise + "</z></magnetometer></sensor>");
  EXPECT_EQ(loaded.messages, Messages());
  const std::vector<description::Sensor>& sensors = loaded.model().links.at(0).sensors;
  EXPECT_EQ(std::get<AltimeterSettings>(sensors.at(0).settings).verticalVelocity.mean, 1);
  EXPECT_EQ(std::get<AltimeterSettings>(sensors.at(0).settings).verticalPosition.mean, 0);
  EXPECT_EQ(std::get<AirPressureSettings>(sensors.at(1).settings).pressure.mean, 1);
  EXPECT_EQ(std::get<MagnetometerSettings>(sensors.at(2).settings).field[2].mean, 1);
}

TEST(Sensor, ReadsANavSat) {
  const auto noise = [](const char* mean) {
    return std::string("<noise type='gaussian'><mean>") + mean + "</mean></noise>";
  };
  const Loaded loaded = loadLink(
      "<sensor name='s' type='navsat'><navsat><position_sensing><horizontal>" + noise("1") + "</horizontal><vertical>" +
      noise("2") + "</vertical></position_sensing><velocity_sensing><horizontal>" + noise("3") +
      "</horizontal><vertical>" + noise("4") + "</vertical></velocity_sensing></navsat></sensor>");
  EXPECT_EQ(loaded.messages, Messages());
  const NavSatSettings& settings = std::get<NavSatSettings>(sensorOf(loaded).settings);
  EXPECT_EQ(settings.horizontalPosition.mean, 1);
  EXPECT_EQ(settings.verticalPosition.mean, 2);
  EXPECT_EQ(settings.horizontalVelocity.mean, 3);
  EXPECT_EQ(settings.verticalVelocity.mean, 4);
}

TEST(Sensor, ReadsALogicalCamera) {
  const auto load = [](const std::string& content) {
    return loadLink("<sensor name='s' type='logical_camera'>\n<logical_camera>\n" + content +
                    "</logical_camera></sensor>");
  };
  const Loaded loaded =
      load("<near>0.5</near><far>5</far><aspect_ratio>2</aspect_ratio><horizontal_fov>1.5</horizontal_fov>");
  EXPECT_EQ(loaded.messages, Messages());
  EXPECT_EQ(std::get<LogicalCameraSettings>(sensorOf(loaded).settings),
            (LogicalCameraSettings{.near = 0.5, .far = 5, .horizontalFov = 1.5, .aspectRatio = 2}));
  EXPECT_EQ(std::get<LogicalCameraSettings>(sensorOf(load("")).settings), LogicalCameraSettings());
  EXPECT_EQ(load("<near>2</near>").messages,
            Messages{"t.sdf:5:1: error: sensor 's' sees nothing: <near> must be below <far>"});
  EXPECT_EQ(load("<horizontal_fov>4</horizontal_fov>").messages,
            Messages{"t.sdf:6:1: error: <horizontal_fov> must be below pi"});
}

TEST(Sensor, ReadsAForceTorqueSensor) {
  const auto load = [](const std::string& content) {
    return loadLink("<sensor name='s' type='force_torque'><force_torque>\n" + content + "</force_torque></sensor>");
  };
  const Loaded loaded = load(
      "<frame>sensor</frame><measure_direction>parent_to_child</measure_direction>"
      "<torque><y><noise type='gaussian'><mean>1</mean></noise></y></torque>");
  EXPECT_EQ(loaded.messages, Messages());
  const ForceTorqueSettings& settings = std::get<ForceTorqueSettings>(sensorOf(loaded).settings);
  EXPECT_EQ(settings.frame, ForceTorqueSettings::Frame::kSensor);
  EXPECT_TRUE(settings.isParentToChild);
  EXPECT_EQ(settings.torque[1].mean, 1);
  EXPECT_EQ(std::get<ForceTorqueSettings>(sensorOf(load("")).settings).frame, ForceTorqueSettings::Frame::kChild);
  EXPECT_EQ(load("<frame>joint</frame>").messages,
            Messages{"t.sdf:5:1: error: <frame> has the unknown value 'joint' | it can be child, parent, sensor"});
}

TEST(Sensor, ReadsNavSat) {
  const Loaded loaded = loadLink(
      "<sensor name='s' type='gps'><gps><position_sensing><horizontal><noise type='gaussian'><stddev>1</stddev></noise>"
      "</horizontal></position_sensing><velocity_sensing><vertical><noise type='gaussian'><mean>2</mean></noise>"
      "</vertical></velocity_sensing></gps></sensor>"
      "<sensor name='t' type='navsat'><navsat><position_sensing><vertical><noise type='gaussian'><mean>3</mean></noise>"
      "</vertical></position_sensing></navsat></sensor>");
  const auto& gps = std::get<NavSatSettings>(sensorOf(loaded).settings);
  EXPECT_EQ(gps.horizontalPosition.standardDeviation, 1);
  EXPECT_EQ(gps.verticalPosition, NoiseSettings());
  EXPECT_EQ(gps.verticalVelocity.mean, 2);
  const auto& navsat = std::get<NavSatSettings>(loaded.model().links.at(0).sensors.at(1).settings);
  EXPECT_EQ(navsat.verticalPosition.mean, 3);
}

TEST(Sensor, ReadsThoseThatAreRare) {
  const Loaded loaded = loadLink(
      "<sensor name='a' type='logical_camera'><logical_camera><near>1</near><far>2</far><horizontal_fov>0.5"
      "</horizontal_fov><aspect_ratio>3</aspect_ratio></logical_camera></sensor>"
      "<sensor name='b' type='sonar'><sonar><geometry>sphere</geometry><min>1</min><max>inf</max></sonar></sensor>"
      "<sensor name='c' type='wireless_receiver'><transceiver><essid>e</essid><gain>1</gain>"
      "<sensitivity>-50</sensitivity></transceiver></sensor><sensor name='d' type='rfid'/>");
  const std::vector<description::Sensor>& sensors = loaded.model().links.at(0).sensors;
  const LogicalCameraSettings camera{.near = 1, .far = 2, .horizontalFov = 0.5, .aspectRatio = 3};
  EXPECT_EQ(std::get<LogicalCameraSettings>(sensors.at(0).settings), camera);
  const auto& sonar = std::get<SonarSettings>(sensors.at(1).settings);
  EXPECT_EQ(sonar.shape, SonarSettings::Shape::kSphere);
  EXPECT_EQ(sonar.maxRange, std::numeric_limits<double>::infinity());
  const auto& receiver = std::get<TransceiverSettings>(sensors.at(2).settings);
  EXPECT_EQ(receiver.essid, "e");
  EXPECT_EQ(receiver.sensitivity, -50);
  EXPECT_TRUE(std::holds_alternative<std::monostate>(sensors.at(3).settings));
}

TEST(Sensor, ReadsWhatIsOfNoType) {
  const Loaded loaded = loadLink(
      "<sensor name='s' type='imu'><enable_metrics>true</enable_metrics><visualize>1</visualize>"
      "<plugin filename='f' name='n'><x/></plugin></sensor>");
  EXPECT_EQ(loaded.messages, Messages());
  EXPECT_TRUE(sensorOf(loaded).hasMetrics);
  EXPECT_TRUE(sensorOf(loaded).isVisualized);
  EXPECT_EQ(sensorOf(loaded).plugins.at(0).className, "n");
  EXPECT_NE(sensorOf(loaded).plugins.at(0).sdf.child("x"), nullptr);
}

TEST(Sensor, OfACustomTypeHasThatOfItsSystem) {
  const auto typeOf = [](const std::string& attribute, const std::string& content) {
    const auto loaded = loadLink("<sensor name='s' type='custom' " + attribute + ">" + content + "</sensor>");
    return loaded.root.worlds.at(0).models.at(0).links.at(0).sensors.at(0).type;
  };
  EXPECT_EQ(typeOf("gz:type='dvl'", ""), "dvl");
  EXPECT_EQ(typeOf("ignition:type='dvl'", ""), "dvl");
  EXPECT_EQ(typeOf("gz:type='environmental_sensor/heat'", ""), "environmental_sensor");
  EXPECT_EQ(typeOf("gz:type='environmental_sensor/heat'", "<output_format>vector3</output_format>"),
            "environmental_vector_sensor");
  EXPECT_EQ(typeOf("gz:type='environmental_sensor'", ""), "custom");
  EXPECT_EQ(typeOf("gz:type='odometer'", ""), "custom");
  EXPECT_EQ(typeOf("", ""), "custom");
}

TEST(Sensor, WarnsOfTheParametersOfAnotherType) {
  EXPECT_EQ(loadLink("<sensor name='s' type='imu'>\n<camera/></sensor>").messages,
            Messages{"t.sdf:5:1: warning: <camera> has no effect in a sensor of type 'imu'"});
  EXPECT_EQ(loadLink("<sensor name='s' type='navsat'><gps/></sensor>").messages, Messages());
}

TEST(Sensor, OfAnUnknownTypeIsNamed) {
  EXPECT_EQ(loadLink("<sensor name='s' type='gpu_lidr'/>").messages,
            Messages{"t.sdf:4:1: warning: sensor type 'gpu_lidr' is unknown | did you mean 'gpu_lidar'?"});
}

TEST(Sensor, IsPlacedInWhatHoldsItOrInAnotherFrame) {
  const Loaded loaded = loadModel(
      "<frame name='f'><pose>10 0 0 0 0 0</pose></frame><link name='a'><pose>1 0 0 0 0 0</pose>"
      "<sensor name='s' type='imu'><pose relative_to='f'>0 0 1 0 0 0</pose></sensor></link><link name='b'/>"
      "<joint name='j' type='fixed'><pose>0 3 0 0 0 0</pose><parent>a</parent><child>b</child>"
      "<sensor name='s' type='imu'><pose>0 0 2 0 0 0</pose></sensor>"
      "<sensor name='t' type='imu'><pose relative_to='f'>0 0 0 0 0 0</pose></sensor></joint>");
  EXPECT_EQ(loaded.messages, Messages());
  expectPose(sensorOf(loaded).X_ParentSensor, {9, 0, 1});
  expectPose(loaded.model().joints.at(0).sensors.at(0).X_ParentSensor, {0, 0, 2});
  expectPose(loaded.model().joints.at(0).sensors.at(1).X_ParentSensor, {10, -3, 0});
}

TEST(Sensor, StaysInWhatHoldsItIfItsFrameIsMissing) {
  const Loaded loaded = loadLink("<sensor name='s' type='imu'><pose relative_to='f'>0 0 1 0 0 0</pose></sensor>");
  EXPECT_EQ(loaded.messages, Messages{"t.sdf:4:35: warning: the pose of sensor 's' is relative to 'f', which is not in "
                                      "model 'm' | it is taken as relative to what holds the sensor"});
  expectPose(sensorOf(loaded).X_ParentSensor, {0, 0, 1});
}

TEST(Sensor, HasATypeAndANameOfItsOwn) {
  EXPECT_EQ(loadLink("<sensor name='a'/>\n<sensor name='b' type='imu'/><sensor name='b' type='imu'/>").messages,
            (Messages{"t.sdf:4:1: error: sensor 'a' has no type | write type=\"imu\", for example",
                      "t.sdf:5:30: error: sensor 'b' has the same name as another sensor of link 'l' of model 'm' | "
                      "the first one is in line 5"}));
}

TEST(Sensor, OfATypeThatIsNotThereYetIsNamedOnceAType) {
  EXPECT_EQ(loadLink("<sensor name='a' type='sonar'/>\n<sensor name='b' type='sonar'/>\n<sensor name='c' type='rfid'/>")
                .messages,
            (Messages{"t.sdf:4:1: warning: sensor type 'sonar' is not simulated yet",
                      "t.sdf:6:1: warning: sensor type 'rfid' is not simulated yet"}));
}

}  // namespace
}  // namespace pongsim::sdf::test
