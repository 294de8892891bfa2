#include "looks.hh"

#include "near.hh"

namespace pongsim::test {

namespace {

void compareMaps(const ours::PbrMaps& a, const theirs::PbrWorkflow& b, const std::string& what) {
  EXPECT_EQ(a.albedo.uri, b.AlbedoMap()) << what;
  EXPECT_EQ(a.normal.uri, b.NormalMap()) << what;
  // libsdformat 12.3 takes all normals as tangent-space, so the type is not compared
  EXPECT_EQ(a.environment.uri, b.EnvironmentMap()) << what;
  EXPECT_EQ(a.ambientOcclusion.uri, b.AmbientOcclusionMap()) << what;
  EXPECT_EQ(a.emissive.uri, b.EmissiveMap()) << what;
  EXPECT_EQ(a.light.uri, b.LightMap()) << what;
  EXPECT_EQ(a.lightCoordinates, b.LightMapTexCoordSet()) << what;
}

void comparePbr(const ours::Material& a, const theirs::Pbr& b, const std::string& what) {
  const theirs::PbrWorkflow* metal = b.Workflow(theirs::PbrWorkflowType::METAL);
  ASSERT_EQ(a.metal.has_value(), metal != nullptr) << what;
  if (metal != nullptr) {
    compareMaps(a.metal->maps, *metal, what);
    expectNear(a.metal->roughness, metal->Roughness(), what);
    EXPECT_EQ(a.metal->roughnessMap.uri, metal->RoughnessMap()) << what;
    expectNear(a.metal->metalness, metal->Metalness(), what);
    EXPECT_EQ(a.metal->metalnessMap.uri, metal->MetalnessMap()) << what;
  }
  const theirs::PbrWorkflow* gloss = b.Workflow(theirs::PbrWorkflowType::SPECULAR);
  ASSERT_EQ(a.gloss.has_value(), gloss != nullptr) << what;
  if (gloss != nullptr) {
    compareMaps(a.gloss->maps, *gloss, what);
    expectNear(a.gloss->glossiness, gloss->Glossiness(), what);
    EXPECT_EQ(a.gloss->glossinessMap.uri, gloss->GlossinessMap()) << what;
    EXPECT_EQ(a.gloss->specularMap.uri, gloss->SpecularMap()) << what;
  }
}

void compareMaterial(const ours::Material& a, const theirs::Material& b, const std::string& what) {
  expectNear(a.ambient, b.Ambient(), what + ", ambient");
  expectNear(a.diffuse, b.Diffuse(), what + ", diffuse");
  expectNear(a.specular, b.Specular(), what + ", specular");
  expectNear(a.emissive, b.Emissive(), what + ", emissive");
  EXPECT_EQ(a.isLit, b.Lighting()) << what;
  EXPECT_EQ(a.isDoubleSided, b.DoubleSided()) << what;
  expectNear(a.renderOrder, b.RenderOrder(), what + ", render order");
  EXPECT_EQ(a.scriptName, b.ScriptName()) << what;
  if (b.PbrMaterial() != nullptr) comparePbr(a, *b.PbrMaterial(), what);
}

}  // namespace

void compareLight(const ours::Light& a, const theirs::Light& b, const std::string& what) {
  expectNear(a.X_ParentLight, resolved(b), what);
  using enum ours::LightType;
  EXPECT_EQ(a.type == kDirectional, b.Type() == theirs::LightType::DIRECTIONAL) << what;
  EXPECT_EQ(a.type == kSpot, b.Type() == theirs::LightType::SPOT) << what;
  EXPECT_EQ(a.castsShadows, b.CastShadows()) << what;
  expectNear(a.intensity, b.Intensity(), what + ", intensity");
  expectNear(a.diffuse, b.Diffuse(), what + ", diffuse");
  expectNear(a.specular, b.Specular(), what + ", specular");
  if (b.Type() != theirs::LightType::POINT) {
    expectNear(a.direction, vector(b.Direction()).normalized(), what + ", direction");
  }
  expectNear(a.range, b.AttenuationRange(), what + ", range");
  expectNear(a.constantAttenuation, b.ConstantAttenuationFactor(), what + ", constant attenuation");
  expectNear(a.linearAttenuation, b.LinearAttenuationFactor(), what + ", linear attenuation");
  expectNear(a.quadraticAttenuation, b.QuadraticAttenuationFactor(), what + ", quadratic attenuation");
  if (b.Type() == theirs::LightType::SPOT) {
    expectNear(a.innerAngle, b.SpotInnerAngle().Radian(), what + ", inner angle");
    expectNear(a.outerAngle, b.SpotOuterAngle().Radian(), what + ", outer angle");
    expectNear(a.falloff, b.SpotFalloff(), what + ", falloff");
  }
}

void compareLooks(const ours::Visual& a, const theirs::Visual& b, const std::string& what) {
  expectNear(static_cast<float>(a.transparency), b.Transparency(), what + ", transparency");
  EXPECT_EQ(a.castsShadows, b.CastShadows()) << what;
  EXPECT_EQ(a.visibilityFlags, b.VisibilityFlags()) << what;
  expectNear(a.laserRetro, b.LaserRetro(), what + ", laser_retro");
  ASSERT_EQ(a.material.has_value(), b.Material() != nullptr) << what;
  if (a.material) compareMaterial(*a.material, *b.Material(), what);
}

void compareScene(const ours::Scene& a, const theirs::Scene& b) {
  expectNear(a.ambient, b.Ambient(), "ambient light");
  expectNear(a.background, b.Background(), "background");
  EXPECT_EQ(a.hasGrid, b.Grid());
  EXPECT_EQ(a.hasShadows, b.Shadows());
  EXPECT_EQ(a.showsOrigin, b.OriginVisual());
  ASSERT_EQ(a.sky.has_value(), b.Sky() != nullptr);
  if (!a.sky) return;
  expectNear(a.sky->time, b.Sky()->Time(), "time");
  expectNear(a.sky->sunrise, b.Sky()->Sunrise(), "sunrise");
  expectNear(a.sky->sunset, b.Sky()->Sunset(), "sunset");
  expectNear(a.sky->cloudSpeed, b.Sky()->CloudSpeed(), "speed of clouds");
  expectNear(a.sky->cloudDirection, b.Sky()->CloudDirection().Radian(), "direction of clouds");
  expectNear(a.sky->humidity, b.Sky()->CloudHumidity(), "humidity");
  expectNear(a.sky->cloudSize, b.Sky()->CloudMeanSize(), "size of clouds");
  expectNear(a.sky->cloudAmbient, b.Sky()->CloudAmbient(), "colour of clouds");
}

void compareActor(const ours::Actor& a, const theirs::Actor& b, const std::string& what) {
  if (b.PoseRelativeTo().empty()) expectNear(a.X_WorldActor, pose(b.RawPose()), what);
  EXPECT_EQ(a.skin.uri.empty() ? "__default__" : a.skin.uri, b.SkinFilename()) << what;
  expectNear(a.skin.scale, b.SkinScale(), what + ", scale");
  EXPECT_EQ(a.loops, b.ScriptLoop()) << what;
  EXPECT_EQ(a.startsByItself, b.ScriptAutoStart()) << what;
  expectNear(a.startDelay, b.ScriptDelayStart(), what + ", delay");
  ASSERT_EQ(a.animations.size(), b.AnimationCount()) << what;
  for (std::size_t i = 0; i < a.animations.size(); ++i) {
    const theirs::Animation& other = *b.AnimationByIndex(i);
    EXPECT_EQ(a.animations[i].name, other.Name()) << what;
    EXPECT_EQ(a.animations[i].source.uri, other.Filename()) << what;
    expectNear(a.animations[i].source.scale, other.Scale(), what + ", scale of an animation");
    EXPECT_EQ(a.animations[i].followsPath, other.InterpolateX()) << what;
  }
  ASSERT_EQ(a.trajectories.size(), b.TrajectoryCount()) << what;
  for (std::size_t i = 0; i < a.trajectories.size(); ++i) {
    const ours::Trajectory& trajectory = a.trajectories[i];
    const theirs::Trajectory& other = *b.TrajectoryByIndex(i);
    EXPECT_EQ(static_cast<std::uint64_t>(trajectory.id), other.Id()) << what;
    EXPECT_EQ(trajectory.type, other.Type()) << what;
    expectNear(trajectory.tension, other.Tension(), what + ", tension");
    ASSERT_EQ(trajectory.waypoints.size(), other.WaypointCount()) << what;
    for (std::size_t j = 0; j < trajectory.waypoints.size(); ++j) {
      expectNear(trajectory.waypoints[j].time, other.WaypointByIndex(j)->Time(), what + ", time");
      expectNear(trajectory.waypoints[j].X_ActorWaypoint, pose(other.WaypointByIndex(j)->Pose()), what + ", waypoint");
    }
  }
}

}  // namespace pongsim::test
