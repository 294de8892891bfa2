#include "pongsim/link_group.hh"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "support/running_world.hh"

namespace pongsim {
namespace {

using test::RunningWorld;

/// Three bodies of 2 kg without gravity; the centre of mass of "b" is not at its link's origin.
std::string threeBodies() {
  std::string models = "<gravity>0 0 0</gravity>";
  for (const std::string name : {"a", "b", "c"}) {
    models += "<model name='" + name + "'><pose>" + std::to_string(name[0] - 'a') +
              " 0 0 0.1 0.2 0.3</pose><link name='link'><inertial>" +
              (name == "b" ? "<pose>0.1 0.2 0 0 0 0</pose>" : "") + "<mass>2</mass></inertial></link></model>";
  }
  return models;
}

class LinkGroupTest : public testing::Test {
 protected:
  static std::vector<Link> links(RunningWorld& world) {
    std::vector<Link> links;
    for (const char* name : {"c", "a", "b"}) links.push_back(world.model(name).link("link").value());
    return links;
  }
  LinkGroup group() { return {world_.simulation().world(), links(world_)}; }

  RunningWorld world_{threeBodies()};
  const std::vector<Wrench> wrenches_{{{1, 2, 3}, {0.1, 0.2, 0.3}}, {{-1, 0, 0}, {0, 0, 0}}, {{0, 5, 0}, {0, 0, 1}}};
};

TEST_F(LinkGroupTest, TellsWhereItsLinksAreInTheirOrder) {
  LinkGroup group = this->group();
  ASSERT_EQ(group.poses().size(), 3U);
  world_.model("a").setVelocity({1, 0, 0}, {0, 0, 1});
  world_.step(10);
  const std::vector<Link> links = this->links(world_);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(*group.poses()[i], links[i].pose());
}

TEST_F(LinkGroupTest, CopiesWhereItsLinksAre) {
  LinkGroup group = this->group();
  world_.model("a").setVelocity({1, 0, 0}, {0, 0, 1});
  world_.step(10);
  std::vector<Pose> X_WorldLinks(3);
  group.copyPoses(X_WorldLinks);
  const std::vector<Link> links = this->links(world_);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(X_WorldLinks[i], links[i].pose());
  X_WorldLinks.pop_back();
  EXPECT_THROW(group.copyPoses(X_WorldLinks), std::invalid_argument);
}

TEST_F(LinkGroupTest, PushesAsTheHandlesDoBitByBit) {
  RunningWorld other{threeBodies()};
  LinkGroup group = this->group();
  std::vector<Link> links = this->links(other);
  for (int step = 0; step < 10; ++step) {
    group.addWrenches(wrenches_);
    for (std::size_t i = 0; i < 3; ++i) links[i].addWrench(wrenches_[i].force, wrenches_[i].torque);
    world_.step(1);
    other.step(1);
  }
  EXPECT_EQ(world_.simulation().stateHash(), other.simulation().stateHash());
  EXPECT_NE(links[0].linearVelocity(), Vector3::Zero());
}

TEST_F(LinkGroupTest, FindsItsLinksWhereTheArraysHaveMovedUp) {
  LinkGroup group(world_.simulation().world(), std::vector<Link>{*world_.model("c").link("link")});
  EXPECT_EQ(group.poses()[0]->position.x(), 2);
  ASSERT_TRUE(world_.simulation().remove(world_.model("a")));
  EXPECT_EQ(group.poses()[0]->position.x(), 2);
  Diagnostics diagnostics;
  world_.simulation().reset(diagnostics);
  EXPECT_EQ(group.poses()[0]->position.x(), 2);
}

TEST_F(LinkGroupTest, ThrowsWhereALinkHasGone) {
  LinkGroup group = this->group();
  ASSERT_TRUE(world_.simulation().remove(world_.model("a")));
  EXPECT_THROW(group.poses(), Gone);
  EXPECT_THROW(group.addWrenches(wrenches_), Gone);
}

TEST_F(LinkGroupTest, RefusesWhatIsNotFiniteAndWrongNumbers) {
  LinkGroup group = this->group();
  EXPECT_THROW(group.addWrenches({}), std::invalid_argument);
  std::vector<Wrench> wrenches = wrenches_;
  wrenches[0].force.x() = std::numeric_limits<double>::infinity();
  testing::internal::CaptureStderr();
  group.addWrenches(wrenches);
  EXPECT_NE(testing::internal::GetCapturedStderr().find("link 'link' was given a wrench that is not finite"),
            std::string::npos);
  world_.step(1);
  EXPECT_EQ(world_.model("c").link("link")->linearVelocity(), Vector3::Zero());
  EXPECT_NE(world_.model("a").link("link")->linearVelocity(), Vector3::Zero());
}

}  // namespace
}  // namespace pongsim
