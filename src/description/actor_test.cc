#include "description/actor.hh"

#include <gtest/gtest.h>

#include <variant>
#include <vector>

namespace pongsim::description {
namespace {

TEST(Actor, ShowsItsSkinAndWhatItsLinksShow) {
  Actor actor;
  EXPECT_TRUE(visualsOf(actor).empty());
  Visual& look = actor.visuals.emplace_back();
  look.name = "look";
  EXPECT_EQ(visualsOf(actor), actor.visuals);
  actor.skin = {"model://walker/walk.dae", "/models/walker/walk.dae", 2};
  const std::vector<Visual> visuals = visualsOf(actor);
  ASSERT_EQ(visuals.size(), 2U);
  const Mesh& skin = std::get<Mesh>(visuals[0].geometry);
  EXPECT_EQ(skin.file, "/models/walker/walk.dae");
  EXPECT_EQ(skin.scale, Vector3(2, 2, 2));
  EXPECT_FALSE(visuals[0].material);
  EXPECT_EQ(visuals[1], look);
}

}  // namespace
}  // namespace pongsim::description
