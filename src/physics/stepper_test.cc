#include "physics/stepper.hh"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/hash.hh"
#include "support/physics/rig.hh"

namespace pongsim::physics {
namespace {

description::Model boxAt(const std::string& name, double x, double z) {
  const Vector3 size(0.4, 0.4, 0.2);
  description::Link link = test::makeLink("link", {x, 0, z}, 1, test::boxMoments(1, size));
  test::addCollision(link, description::Box{size});
  return test::makeModel(name, {link});
}

// two piles and a pair of boxes that a joint connects; `between` comes before what stands in the second pile
description::World piles(const std::vector<description::Model>& between) {
  description::World world;
  world.models = {test::makeGround(), boxAt("a0", 0, 0.1), boxAt("a1", 0.05, 0.3)};
  for (const description::Model& model : between) world.models.push_back(model);
  for (const auto& model : {boxAt("b0", 5, 0.1), boxAt("b1", 5.05, 0.3)}) world.models.push_back(model);
  return world;
}

TEST(Stepper, GivesAnIslandTheSameBitsWhoeverElseIsThere) {
  test::Rig alone(piles({}));
  test::Rig amongOthers(piles({boxAt("c0", 10, 0.1), boxAt("c1", 10, 0.31), boxAt("c2", 10, 0.52)}));
  alone.step(500);
  amongOthers.step(500);
  for (const char* link : {"a0::link", "a1::link", "b0::link", "b1::link"}) {
    EXPECT_EQ(alone.link(link).X_WorldLink, amongOthers.link(link).X_WorldLink) << link;
    EXPECT_EQ(alone.link(link).v_WorldLink, amongOthers.link(link).v_WorldLink) << link;
  }
}

TEST(Stepper, GivesTheSameBitsWhateverHasBeenThere) {
  const description::World world = piles({boxAt("c0", 10, 0.1)});
  world::Entities entities(world);
  world::State state(entities);
  Engine engine(entities);
  // before the first step, so that what is left begins where it would without
  const world::Removal removal = entities.removeModel(entities.findModel("c0"));
  engine.remove(removal);
  state.remove(removal);
  test::Rig never(piles({}));
  for (int i = 0; i < 500; ++i) engine.step(test::Rig::kStep, state);
  never.step(500);
  for (world::Slot link = 0; link < state.links.size(); ++link) {
    EXPECT_EQ(state.links[link].X_WorldLink, never.state.links[link].X_WorldLink) << link;
  }
}

TEST(Stepper, RemovesSeveralBodiesAtOnceWithTheSameBits) {
  // one that is left leaned on those that go
  const description::World world =
      piles({boxAt("c0", 10, 0.1), boxAt("c1", 10, 0.31), boxAt("c2", 10.05, 0.52), boxAt("d0", 14, 0.1)});
  const auto run = [&world](bool atOnce) {
    world::Entities entities(world);
    world::State state(entities);
    Engine engine(entities);
    for (int i = 0; i < 100; ++i) engine.step(test::Rig::kStep, state);
    const auto remove = [&](const std::vector<const char*>& names) {
      std::vector<world::Slot> slots;
      for (const char* name : names) slots.push_back(entities.findModel(name));
      const world::Removal removal = entities.removeModels(slots);
      engine.remove(removal);
      state.remove(removal);
    };
    if (atOnce) {
      remove({"a1", "c0", "c1", "d0"});
    } else {
      for (const char* name : {"c1", "d0", "a1", "c0"}) remove({name});
    }
    for (int i = 0; i < 500; ++i) engine.step(test::Rig::kStep, state);
    EXPECT_LT(state.links[entities.findLink("c2::link")].X_WorldLink.position.z(), 0.2);
    return world::stateHash(state);
  };
  EXPECT_EQ(run(true), run(false));
}

TEST(Stepper, GivesTheSameBitsOnAnyNumberOfThreads) {
  // piles that fall apart, and joints in some of them
  description::World description;
  description.models = {test::makeGround()};
  for (int pile = 0; pile < 12; ++pile) {
    const std::string name = "p" + std::to_string(pile);
    for (int i = 0; i < 4; ++i) {
      description.models.push_back(boxAt(name + std::to_string(i), 3.0 * pile + 0.12 * i, 0.1 + 0.25 * i));
    }
    if (pile % 3 == 0) {
      description.joints.push_back(test::makeJoint(name, description::JointType::kBall, name + "0::link",
                                                   name + "1::link", test::at(0.2, 0, 0), test::at(0.2, 0, 0)));
    }
  }
  const auto hashOn = [&](int threads) {
    const world::Entities entities(description);
    world::State state(entities);
    Engine engine(entities, {.threads = threads});
    for (int i = 0; i < 1000; ++i) engine.step(test::Rig::kStep, state);
    return world::stateHash(state);
  };
  const std::uint64_t expected = hashOn(1);
  for (const int threads : {2, 3, 5}) EXPECT_EQ(hashOn(threads), expected) << threads << " threads";
}

// a body with a bumper, on two wheels that a joint each drives, and a ball that it drags
description::Model vehicleAt(const std::string& name, double x, double y, double yaw) {
  description::Link body = test::makeLink("body", {0, 0, 0.25}, 2, test::boxMoments(2, {0.6, 0.3, 0.1}));
  test::addCollision(body, description::Box{{0.6, 0.3, 0.1}});
  test::addCollision(body, description::Sphere{0.1});
  body.collisions[1].X_LinkCollision.position = {-0.2, 0, -0.15};
  body.collisions[1].surface.mu = 0;
  std::vector<description::Link> links = {body};
  for (const double side : {0.2, -0.2}) {
    description::Link wheel = test::makeLink(side > 0 ? "left" : "right", {0.2, side, 0.1}, 0.3, {1e-3, 1e-3, 1.5e-3});
    wheel.X_ModelLink.rotation = fromRollPitchYaw(-M_PI / 2, 0, 0);
    test::addCollision(wheel, description::Cylinder{0.1, 0.05});
    links.push_back(wheel);
  }
  description::Model model = test::makeModel(name, links);
  model.X_ParentModel = {{x, y, 0}, fromRollPitchYaw(0, 0, yaw)};
  for (std::size_t i = 1; i <= 2; ++i) {
    Pose X_BodyWheel = links[0].X_ModelLink.inverse() * links[i].X_ModelLink;
    model.joints.push_back(
        test::makeJoint(links[i].name, description::JointType::kRevolute, "body", links[i].name, X_BodyWheel, Pose()));
  }
  return model;
}

TEST(Stepper, LetsVehiclesMeetAndPartWithTheSameBitsOnAnyNumberOfThreads) {
  // 24 that run about among posts, a table made of parts and each other
  description::World description;
  description.models = {test::makeGround()};
  for (int i = 0; i < 6; ++i) {
    description::Link post = test::makeLink("link", {0.9 * i + 0.45, 0.8 * (i % 3) + 0.4, 0.2}, 1, {1, 1, 1});
    test::addCollision(post, description::Cylinder{0.15, 0.4});
    test::addCollision(post, description::Box{{0.1, 0.6, 0.3}});
    description.models.push_back(test::makeModel("post" + std::to_string(i), {post}));
    description.models.back().isStatic = i % 2 == 0;
  }
  constexpr int kVehicles = 24;
#if defined(__SANITIZE_THREAD__)
  // who looks for races sees them soon, and takes ten times as long
  constexpr int kSteps = 1200;
  constexpr std::size_t kFewestBumps = 1;
#else
  constexpr int kSteps = 3000;
  constexpr std::size_t kFewestBumps = 20;
#endif
  for (int i = 0; i < kVehicles; ++i) {
    description.models.push_back(vehicleAt("v" + std::to_string(i), 0.9 * (i % 6), 0.8 * (i / 6), 0.9 * i));
  }
  std::size_t bumps = 0;
  const auto hashesOn = [&](int threads) {
    const world::Entities entities(description);
    world::State state(entities);
    Engine engine(entities, {.threads = threads});
    std::vector<std::uint64_t> hashes;
    std::vector<Contact> contacts;
    for (int i = 0; i < kSteps; ++i) {
      if (i % (kSteps / 6) == 0) {
        for (world::Slot joint = 0; joint < entities.joints().size(); ++joint) {
          engine.setJointVelocityTarget(
              joint, static_cast<double>((joint * 7 + static_cast<std::size_t>(i * 6 / kSteps) * 5) % 25) - 8);
        }
        hashes.push_back(world::stateHash(state));
      }
      engine.step(test::Rig::kStep, state);
      if (i % 100 != 0) continue;
      engine.contacts(contacts);
      for (const Contact& contact : contacts) bumps += std::abs(contact.normal.z()) < 0.5 ? 1 : 0;
    }
    StateArchive archive;
    engine.transfer(archive);
    base::Hash all;
    const std::vector<std::byte> bytes = archive.take();
    all.add(std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
    hashes.push_back(all.value());
    return hashes;
  };
  const std::vector<std::uint64_t> expected = hashesOn(1);
  EXPECT_GE(bumps, kFewestBumps);
  for (const int threads : {2, 3}) EXPECT_EQ(hashesOn(threads), expected) << threads << " threads";
}

TEST(Stepper, SolvesJointsBetweenModelsWithBoth) {
  description::World world = piles({});
  description::Joint joint =
      test::makeJoint("rope", description::JointType::kFixed, "a0::link", "b0::link", test::at(5, 0, 0), Pose());
  world.joints = {joint};
  test::Rig rig(std::move(world));
  rig.engine.setLinkVelocity(1, {1, 0, 0}, {0, 0, 0});
  rig.step(1);
  // an impulse of 0.5 N s, and joints that give way by 1e-5 m/s for each
  EXPECT_NEAR(rig.link("b0::link").v_WorldLink.x(), rig.link("a0::link").v_WorldLink.x(), 1e-5);
  EXPECT_GT(rig.link("b0::link").v_WorldLink.x(), 0.1);
}

}  // namespace
}  // namespace pongsim::physics
