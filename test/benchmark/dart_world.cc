#include "benchmark/dart_world.hh"

#include <chrono>
#include <ignition/physics/FindFeatures.hh>
#include <ignition/physics/ForwardStep.hh>
#include <ignition/physics/FrameSemantics.hh>
#include <ignition/physics/GetEntities.hh>
#include <ignition/physics/Joint.hh>
#include <ignition/physics/RequestEngine.hh>
#include <ignition/physics/config.hh>
#include <ignition/physics/sdf/ConstructWorld.hh>
#include <ignition/plugin/Loader.hh>
#include <sdf/Root.hh>
#include <sdf/World.hh>
#include <stdexcept>
#include <utility>
#include <vector>

namespace pongsim::benchmark {

namespace physics = ignition::physics;

using Features = physics::FeatureList<physics::ForwardStep, physics::sdf::ConstructSdfWorld, physics::GetModelFromWorld,
                                      physics::GetLinkFromModel, physics::GetJointFromModel,
                                      physics::LinkFrameSemantics, physics::SetJointVelocityCommandFeature>;

struct DartWorld::Content {
  physics::World3dPtr<Features> world;
  std::vector<std::pair<physics::Joint3dPtr<Features>, double>> motors;
  physics::ForwardStep::Input input;
  physics::ForwardStep::State state;
  physics::ForwardStep::Output output;
};

DartWorld::DartWorld(const std::string& sdf) : content_(std::make_unique<Content>()) {
  ::sdf::Root root;
  root.LoadSdfString(sdf);
  if (root.WorldCount() != 1) throw std::runtime_error("libsdformat finds no world here");
  ignition::plugin::Loader loader;
  loader.LoadLib(IGNITION_PHYSICS_ENGINE_INSTALL_DIR "/libignition-physics5-dartsim-plugin.so.5");
  const auto engine =
      physics::RequestEngine3d<Features>::From(loader.Instantiate("ignition::physics::dartsim::Plugin"));
  if (!engine) throw std::runtime_error("DART can't be had");
  content_->world = engine->ConstructWorld(*root.WorldByIndex(0));
}

DartWorld::~DartWorld() = default;
DartWorld::DartWorld(DartWorld&&) noexcept = default;

void DartWorld::setVelocity(const std::string& joint, double velocity) {
  for (std::size_t i = 0; i < content_->world->GetModelCount(); ++i) {
    const auto found = content_->world->GetModel(i)->GetJoint(joint);
    if (found) content_->motors.emplace_back(found, velocity);
  }
}

void DartWorld::step(double dt) {
  // in each step, as Fortress does, because a command holds for one step
  for (const auto& [joint, velocity] : content_->motors) joint->SetVelocityCommand(0, velocity);
  content_->input.Get<std::chrono::steady_clock::duration>() =
      std::chrono::duration_cast<std::chrono::steady_clock::duration>(std::chrono::duration<double>(dt));
  content_->world->Step(content_->output, content_->state, content_->input);
}

Vector3 DartWorld::position(const std::string& model, const std::string& link) const {
  for (std::size_t i = 0; i < content_->world->GetModelCount(); ++i) {
    const auto each = content_->world->GetModel(i);
    if (!model.empty() && each->GetName() != model) continue;
    if (const auto found = each->GetLink(link)) return found->FrameDataRelativeToWorld().pose.translation();
  }
  throw std::runtime_error("there is no link '" + link + "'");
}

}  // namespace pongsim::benchmark
