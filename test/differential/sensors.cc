#include "sensors.hh"

#include <array>
#include <variant>

#include "near.hh"

namespace pongsim::test {

namespace {

void compareNoise(const NoiseSettings& a, const theirs::Noise& b, const std::string& what) {
  EXPECT_EQ(static_cast<int>(a.type), static_cast<int>(b.Type())) << what;
  expectNear(a.mean, b.Mean(), what + ", mean");
  expectNear(a.standardDeviation, b.StdDev(), what + ", stddev");
  expectNear(a.biasMean, b.BiasMean(), what + ", bias");
  expectNear(a.biasStandardDeviation, b.BiasStdDev(), what + ", stddev of bias");
  expectNear(a.dynamicBiasStandardDeviation, b.DynamicBiasStdDev(), what + ", stddev of dynamic bias");
  expectNear(a.dynamicBiasCorrelationTime, b.DynamicBiasCorrelationTime(), what + ", correlation time");
  expectNear(a.precision, b.Precision(), what + ", precision");
}

void compareNoises(const NoiseSettings3& a, const std::array<const theirs::Noise*, 3>& b, const std::string& what) {
  for (std::size_t i = 0; i < 3; ++i) compareNoise(a[i], *b[i], what + " " + std::to_string(i));
}

/// Compares the settings of a sensor's type with libsdformat's.
struct Compare {
  const theirs::Sensor& b;
  const std::string& what;

  void operator()(const std::monostate&) const {}
  void operator()(const ContactSettings&) const {}
  void operator()(const LogicalCameraSettings&) const {}
  void operator()(const SonarSettings&) const {}
  void operator()(const TransceiverSettings&) const {}

  void operator()(const ImuSettings& a) const {
    const theirs::Imu* imu = b.ImuSensor();
    if (imu == nullptr) return;
    compareNoises(a.angularVelocity,
                  {&imu->AngularVelocityXNoise(), &imu->AngularVelocityYNoise(), &imu->AngularVelocityZNoise()},
                  what + ", angular velocity");
    compareNoises(
        a.linearAcceleration,
        {&imu->LinearAccelerationXNoise(), &imu->LinearAccelerationYNoise(), &imu->LinearAccelerationZNoise()},
        what + ", acceleration");
    EXPECT_EQ(a.enableOrientation, imu->OrientationEnabled()) << what;
  }

  void operator()(const AltimeterSettings& a) const {
    const theirs::Altimeter* altimeter = b.AltimeterSensor();
    if (altimeter == nullptr) return;
    compareNoise(a.verticalPosition, altimeter->VerticalPositionNoise(), what + ", position");
    compareNoise(a.verticalVelocity, altimeter->VerticalVelocityNoise(), what + ", velocity");
  }

  void operator()(const AirPressureSettings& a) const {
    const theirs::AirPressure* pressure = b.AirPressureSensor();
    if (pressure == nullptr) return;
    compareNoise(a.pressure, pressure->PressureNoise(), what + ", pressure");
    expectNear(a.referenceAltitude, pressure->ReferenceAltitude(), what + ", altitude");
  }

  void operator()(const MagnetometerSettings& a) const {
    const theirs::Magnetometer* field = b.MagnetometerSensor();
    if (field == nullptr) return;
    compareNoises(a.field, {&field->XNoise(), &field->YNoise(), &field->ZNoise()}, what + ", field");
  }

  void operator()(const ForceTorqueSettings& a) const {
    const theirs::ForceTorque* sensor = b.ForceTorqueSensor();
    if (sensor == nullptr) return;
    compareNoises(a.force, {&sensor->ForceXNoise(), &sensor->ForceYNoise(), &sensor->ForceZNoise()}, what + ", force");
    compareNoises(a.torque, {&sensor->TorqueXNoise(), &sensor->TorqueYNoise(), &sensor->TorqueZNoise()},
                  what + ", torque");
    using Frame = ForceTorqueSettings::Frame;
    EXPECT_EQ(a.frame == Frame::kParent, sensor->Frame() == theirs::ForceTorqueFrame::PARENT) << what;
    EXPECT_EQ(a.frame == Frame::kSensor, sensor->Frame() == theirs::ForceTorqueFrame::SENSOR) << what;
    EXPECT_EQ(a.isParentToChild, sensor->MeasureDirection() == theirs::ForceTorqueMeasureDirection::PARENT_TO_CHILD)
        << what;
  }

  void operator()(const NavSatSettings& a) const {
    const theirs::NavSat* navsat = b.NavSatSensor();
    if (navsat == nullptr) return;
    compareNoise(a.horizontalPosition, navsat->HorizontalPositionNoise(), what + ", horizontal position");
    compareNoise(a.verticalPosition, navsat->VerticalPositionNoise(), what + ", vertical position");
    compareNoise(a.horizontalVelocity, navsat->HorizontalVelocityNoise(), what + ", horizontal velocity");
    compareNoise(a.verticalVelocity, navsat->VerticalVelocityNoise(), what + ", vertical velocity");
  }

  void operator()(const LidarSettings& a) const {
    const theirs::Lidar* lidar = b.LidarSensor();
    if (lidar == nullptr) return;
    EXPECT_EQ(a.horizontal.samples, lidar->HorizontalScanSamples()) << what;
    EXPECT_EQ(a.vertical.samples, lidar->VerticalScanSamples()) << what;
    expectNear(a.horizontal.resolution, lidar->HorizontalScanResolution(), what + ", horizontal resolution");
    expectNear(a.horizontal.minAngle, lidar->HorizontalScanMinAngle().Radian(), what + ", horizontal min");
    expectNear(a.horizontal.maxAngle, lidar->HorizontalScanMaxAngle().Radian(), what + ", horizontal max");
    expectNear(a.vertical.resolution, lidar->VerticalScanResolution(), what + ", vertical resolution");
    expectNear(a.vertical.minAngle, lidar->VerticalScanMinAngle().Radian(), what + ", vertical min");
    expectNear(a.vertical.maxAngle, lidar->VerticalScanMaxAngle().Radian(), what + ", vertical max");
    expectNear(a.minRange, lidar->RangeMin(), what + ", min range");
    expectNear(a.maxRange, lidar->RangeMax(), what + ", max range");
    expectNear(a.rangeResolution, lidar->RangeResolution(), what + ", range resolution");
    compareNoise(a.noise, lidar->LidarNoise(), what + ", noise");
  }

  void operator()(const CameraSettings& a) const {
    const theirs::Camera* camera = b.CameraSensor();
    if (camera == nullptr) return;
    EXPECT_EQ(a.name.empty() ? "__default__" : a.name, camera->Name()) << what;
    if (camera->PoseRelativeTo().empty()) expectNear(a.X_SensorCamera, pose(camera->RawPose()), what + ", camera");
    expectNear(a.horizontalFov, camera->HorizontalFov().Radian(), what + ", field of view");
    EXPECT_EQ(a.width, camera->ImageWidth()) << what;
    EXPECT_EQ(a.height, camera->ImageHeight()) << what;
    expectNear(a.clip.near, camera->NearClip(), what + ", near");
    expectNear(a.clip.far, camera->FarClip(), what + ", far");
    if (a.depthClip && camera->HasDepthNearClip()) {
      expectNear(a.depthClip->near, camera->DepthNearClip(), what + ", near depth");
    }
    if (a.depthClip && camera->HasDepthFarClip()) {
      expectNear(a.depthClip->far, camera->DepthFarClip(), what + ", far depth");
    }
    EXPECT_EQ(a.visibilityMask, camera->VisibilityMask()) << what;
    EXPECT_EQ(a.savesPictures, camera->SaveFrames()) << what;
    EXPECT_EQ(a.savePath, camera->SaveFramesPath()) << what;
    compareNoise(a.noise, camera->ImageNoise(), what + ", noise");
    compareLens(a, *camera);
  }

  void compareLens(const CameraSettings& a, const theirs::Camera& camera) const {
    const DistortionSettings distortion = a.distortion.value_or(DistortionSettings());
    expectNear(distortion.k1, camera.DistortionK1(), what + ", k1");
    expectNear(distortion.k2, camera.DistortionK2(), what + ", k2");
    expectNear(distortion.k3, camera.DistortionK3(), what + ", k3");
    expectNear(distortion.p1, camera.DistortionP1(), what + ", p1");
    expectNear(distortion.p2, camera.DistortionP2(), what + ", p2");
    expectNear(distortion.center.x(), camera.DistortionCenter().X(), what + ", distortion center x");
    expectNear(distortion.center.y(), camera.DistortionCenter().Y(), what + ", distortion center y");
    if (!a.lens) return;
    EXPECT_EQ(a.lens->scalesToHorizontalFov, camera.LensScaleToHfov()) << what;
    expectNear(a.lens->cutoffAngle, camera.LensCutoffAngle().Radian(), what + ", cutoff angle");
    EXPECT_EQ(a.lens->environmentTextureSize, camera.LensEnvironmentTextureSize()) << what;
    expectNear(a.lens->custom.c1, camera.LensC1(), what + ", c1");
    expectNear(a.lens->custom.c2, camera.LensC2(), what + ", c2");
    expectNear(a.lens->custom.c3, camera.LensC3(), what + ", c3");
    expectNear(a.lens->custom.f, camera.LensFocalLength(), what + ", f");
    ASSERT_EQ(a.lens->intrinsics.has_value(), camera.HasLensIntrinsics()) << what;
    if (!a.lens->intrinsics) return;
    expectNear(a.lens->intrinsics->fx, camera.LensIntrinsicsFx(), what + ", fx");
    expectNear(a.lens->intrinsics->fy, camera.LensIntrinsicsFy(), what + ", fy");
    expectNear(a.lens->intrinsics->cx, camera.LensIntrinsicsCx(), what + ", cx");
    expectNear(a.lens->intrinsics->cy, camera.LensIntrinsicsCy(), what + ", cy");
    expectNear(a.lens->intrinsics->skew, camera.LensIntrinsicsSkew(), what + ", skew");
  }
};

}  // namespace

void compareSensor(const ours::Sensor& a, const theirs::Sensor& b, const std::string& what) {
  // libsdformat 12.3 does not resolve the poses of joints' sensors
  ignition::math::Pose3d X_ParentSensor = b.RawPose();
  if (b.SemanticPose().Resolve(X_ParentSensor).empty() || b.PoseRelativeTo().empty()) {
    expectNear(a.X_ParentSensor, pose(X_ParentSensor), what);
  }
  expectNear(a.updateRate, b.UpdateRate(), what + ", update rate");
  EXPECT_EQ(a.hasMetrics, b.EnableMetrics()) << what;
  if (a.type != "contact") {
    EXPECT_EQ(a.topic, b.Topic()) << what;
  }
  std::visit(Compare{b, what}, a.settings);
}

}  // namespace pongsim::test
