#include <limits>

#include "support/sdf/load_support.hh"

namespace pongsim::sdf::test {
namespace {

Loaded loadCamera(const std::string& content, const std::string& type = "camera") {
  return loadLink("<sensor name='s' type='" + type + "'>\n<camera>" + content + "</camera></sensor>");
}

const CameraSettings& cameraOf(const Loaded& loaded) {
  return std::get<CameraSettings>(loaded.model().links.at(0).sensors.at(0).settings);
}

TEST(Camera, HasTheDefaultsOfTheFormat) {
  EXPECT_EQ(cameraOf(loadCamera("")), CameraSettings());
  EXPECT_EQ(cameraOf(loadLink("<sensor name='s' type='camera'/>")), CameraSettings());
}

TEST(Camera, ReadsItsPicture) {
  const CameraSettings camera = cameraOf(loadCamera(
      "<horizontal_fov>1.5</horizontal_fov><image><width>640</width><height>480</height><format>L_INT8</format>"
      "<anti_aliasing>8</anti_aliasing></image><clip><near>0.2</near><far>inf</far></clip>"
      "<noise><mean>0.1</mean><stddev>0.2</stddev></noise><visibility_mask>0xFF</visibility_mask>"
      "<save enabled='true'><path>/tmp/x</path></save><triggered>true</triggered><trigger_topic>t</trigger_topic>"
      "<camera_info_topic>i</camera_info_topic><optical_frame_id>o</optical_frame_id>"));
  EXPECT_EQ(camera.horizontalFov, 1.5);
  EXPECT_EQ(camera.width, 640U);
  EXPECT_EQ(camera.height, 480U);
  EXPECT_EQ(camera.format, PixelFormat::kL8);
  EXPECT_EQ(camera.antiAliasing, 8U);
  EXPECT_EQ(camera.clip.near, 0.2);
  EXPECT_EQ(camera.clip.far, std::numeric_limits<double>::infinity());
  EXPECT_EQ(camera.noise.type, NoiseSettings::Type::kGaussian);
  EXPECT_EQ(camera.noise.standardDeviation, 0.2);
  EXPECT_EQ(camera.visibilityMask, 0xFFU);
  EXPECT_TRUE(camera.savesPictures);
  EXPECT_EQ(camera.savePath, "/tmp/x");
  EXPECT_TRUE(camera.isTriggered);
  EXPECT_EQ(camera.triggerTopic, "t");
  EXPECT_EQ(camera.infoTopic, "i");
  EXPECT_EQ(camera.opticalFrame, "o");
}

TEST(Camera, WarnsOfQuantizedNoise) {
  const Loaded loaded = loadCamera("\n<noise><type>gaussian_quantized</type><stddev>0.2</stddev></noise>");
  EXPECT_EQ(cameraOf(loaded).noise.type, NoiseSettings::Type::kGaussianQuantized);
  ASSERT_EQ(loaded.messages.size(), 1U);
  EXPECT_NE(loaded.messages[0].find("warning: the noise of sensor 's' has no effect: its type is gaussian_quantized"),
            std::string::npos)
      << loaded.messages[0];
}

TEST(Camera, ReadsItsLens) {
  const CameraSettings camera = cameraOf(loadCamera(
      "<distortion><k1>1</k1><k2>2</k2><k3>3</k3><p1>4</p1><p2>5</p2><center>0.4 0.6</center></distortion><lens>"
      "<type>custom</type><scale_to_hfov>false</scale_to_hfov><custom_function><c1>1.1</c1><c2>1.2</c2><c3>1.3</c3>"
      "<f>1.4</f><fun>sin</fun></custom_function><cutoff_angle>2</cutoff_angle><env_texture_size>512</env_texture_size>"
      "<intrinsics><fx>1</fx><fy>2</fy><cx>3</cx><cy>4</cy><s>5</s></intrinsics>"
      "<projection><p_fx>1</p_fx><p_fy>2</p_fy><p_cx>3</p_cx><p_cy>4</p_cy><tx>5</tx><ty>6</ty></projection></lens>"));
  EXPECT_EQ(camera.distortion, (DistortionSettings{1, 2, 3, 4, 5, {0.4, 0.6}}));
  ASSERT_TRUE(camera.lens);
  EXPECT_EQ(camera.lens->type, LensSettings::Type::kCustom);
  EXPECT_FALSE(camera.lens->scalesToHorizontalFov);
  EXPECT_EQ(camera.lens->custom, (LensSettings::Custom{1.1, 1.2, 1.3, 1.4, LensSettings::Function::kSin}));
  EXPECT_EQ(camera.lens->cutoffAngle, 2);
  EXPECT_EQ(camera.lens->environmentTextureSize, 512);
  EXPECT_EQ(camera.lens->intrinsics, (LensSettings::Intrinsics{1, 2, 3, 4, 5}));
  EXPECT_EQ(camera.lens->projection, (LensSettings::Projection{1, 2, 3, 4, 5, 6}));
}

TEST(Camera, ReadsWhatItsTypeIsFor) {
  const CameraSettings depth = cameraOf(
      loadCamera("<depth_camera><output>points</output><clip><near>0.5</near></clip></depth_camera>", "rgbd_camera"));
  EXPECT_EQ(depth.depthOutput, "points");
  EXPECT_EQ(depth.depthClip, (ClipSettings{0.5, 10}));
  EXPECT_EQ(cameraOf(loadCamera("<segmentation_type>instance</segmentation_type>", "segmentation")).segmentation,
            CameraSettings::Segmentation::kPanoptic);
  EXPECT_EQ(cameraOf(loadCamera("<box_type>full_box_2d</box_type>", "boundingbox_camera")).boxes,
            CameraSettings::Boxes::kFull2d);
}

TEST(Camera, ForBoxesInSpaceHasATypeOfItsOwn) {
  const auto typeOf = [](const std::string& content, const std::string& type) {
    return loadCamera(content, type).model().links.at(0).sensors.at(0).type;
  };
  EXPECT_EQ(typeOf("<box_type>3d</box_type>", "boundingbox"), "boundingbox_camera_3d");
  EXPECT_EQ(typeOf("<box_type>2d</box_type>", "boundingbox"), "boundingbox");
  EXPECT_EQ(typeOf("<box_type>3d</box_type>", "camera"), "camera");
}

TEST(Camera, MayBeTooLargeToDraw) {
  const Loaded loaded = loadCamera("<image><width>100000</width><height>100000</height></image>");
  EXPECT_EQ(loaded.messages, Messages());
  EXPECT_EQ(cameraOf(loaded).width, 100'000U);
}

TEST(Camera, IsPlacedInItsSensorOrInAnotherFrame) {
  const Loaded loaded = loadModel(
      "<frame name='f'><pose>10 0 0 0 0 0</pose></frame><link name='l'><pose>1 0 0 0 0 0</pose>"
      "<sensor name='s' type='camera'><pose>0 0 2 0 0 0</pose><camera><pose>0 1 0 0 0 0</pose></camera></sensor>"
      "<sensor name='t' type='camera'><pose>0 0 2 0 0 0</pose><camera><pose relative_to='f'/></camera></sensor>\n"
      "<sensor name='u' type='camera'><camera><pose relative_to='g'/></camera></sensor></link>");
  EXPECT_EQ(loaded.messages,
            (Messages{"t.sdf:4:46: warning: the pose of the camera of sensor 'u' is relative to 'g', which is not in "
                      "model 'm' | it is taken as relative to the sensor"}));
  const auto& sensors = loaded.model().links.at(0).sensors;
  expectPose(std::get<CameraSettings>(sensors.at(0).settings).X_SensorCamera, {0, 1, 0});
  expectPose(std::get<CameraSettings>(sensors.at(1).settings).X_SensorCamera, {9, 0, -2});
}

TEST(Camera, SaysWhatIsWrong) {
  const auto message = [](const std::string& content) { return loadCamera(content).messages.at(0); };
  EXPECT_EQ(message("<image><width>0</width></image>"),
            "t.sdf:5:16: error: <width> is '0', which is not an integer from 1 to 2147483647");
  EXPECT_EQ(message("<image><format>R8G8B</format></image>"),
            "t.sdf:5:16: error: <format> has the unknown value 'R8G8B' | did you mean 'R8G8B8'?");
  EXPECT_EQ(message("<clip><near>5</near><far>1</far></clip>"),
            "t.sdf:5:9: error: sensor 's' sees nothing: <near> must be below <far>");
  EXPECT_EQ(message("<horizontal_fov>60</horizontal_fov>"),
            "t.sdf:5:9: error: the field of view of sensor 's' is more than 2 pi");
  EXPECT_EQ(message("<horizontal_fov>nan</horizontal_fov>"),
            "t.sdf:5:9: error: <horizontal_fov> is 'nan', which is not a finite number above zero");
  EXPECT_EQ(
      message("<image><width>640.0</width></image>"),
      "t.sdf:5:16: warning: <width> is '640.0', which is not an integer | Fortress reads as much of it as it can");
}

}  // namespace
}  // namespace pongsim::sdf::test
