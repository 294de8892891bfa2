#include "ros2/services/entity_info.hh"

#include <gtest/gtest.h>

#include "support/running_world.hh"

namespace pongsim::ros2::entity_info_test {
namespace {

namespace si = simulation_interfaces;
using Category = si::EntityCategory;

class EntityInfoTest : public testing::Test {
 protected:
  si::EntityInfo of(const std::string& name) { return infos_.of(world_.simulation().world(), world_.model(name)); }
  std::uint8_t categoryOf(const std::string& name) { return of(name).category.category; }

  test::RunningWorld world_{std::string(
      "<model name='wall'><static>true</static><link name='l'/></model>"
      "<model name='stone'><link name='l'/></model>"
      "<model name='arm'><link name='l'/><link name='m'/><joint name='j' type='revolute'><parent>l</parent>"
      "<child>m</child><axis><xyz>0 0 1</xyz></axis></joint></model>"
      "<model name='eye'><model name='in'><link name='l'><sensor name='s' type='imu'/></link></model>"
      "<plugin filename='ignition-gazebo-imu-system' name='ignition::gazebo::systems::Imu'/></model>"
      "<model name='pair'><link name='l'/><link name='m'/><joint name='j' type='fixed'><parent>l</parent>"
      "<child>m</child></joint></model>"
      "<model name='cart'><gz:semantics><category>dynamic_object</category><description>a cart</description><tag>red"
      "</tag><tag>low</tag></gz:semantics><link name='l'/></model>")};
  EntityInfos infos_;
};

TEST_F(EntityInfoTest, SaysByItselfWhatAModelIs) {
  EXPECT_EQ(categoryOf("wall"), Category::kCategoryStaticObject);
  EXPECT_EQ(categoryOf("stone"), Category::kCategoryObject);
  EXPECT_EQ(categoryOf("arm"), Category::kCategoryRobot);
  EXPECT_EQ(categoryOf("eye"), Category::kCategoryRobot);
  EXPECT_EQ(categoryOf("pair"), Category::kCategoryObject);
  EXPECT_EQ(of("arm").description, "");
}

TEST_F(EntityInfoTest, SaysWhatTheFileSays) {
  EXPECT_EQ(of("cart"), (si::EntityInfo{{Category::kCategoryDynamicObject}, "a cart", {"red", "low"}}));
  EXPECT_TRUE(isOk(infos_.set(world_.model("cart"), {{Category::kCategoryHuman}, "", {}})));
  EXPECT_EQ(of("cart").tags.size(), 0U);
  infos_.forget();
  EXPECT_EQ(of("cart").description, "a cart");
}

TEST_F(EntityInfoTest, KeepsWhatIsSetUntilTheModelGoesOrAllIsReset) {
  const si::EntityInfo info{{Category::kCategoryHuman}, "a walker", {"tall", "slow"}};
  EXPECT_TRUE(isOk(infos_.set(world_.model("stone"), info)));
  EXPECT_TRUE(isOk(infos_.set(world_.model("wall"), info)));
  EXPECT_EQ(of("stone"), info);

  const Model stone = world_.model("stone");
  world_.simulation().remove(stone);
  infos_.sweep(world_.simulation().world());
  EXPECT_EQ(of("wall"), info);
  infos_.forget();
  EXPECT_EQ(categoryOf("wall"), Category::kCategoryStaticObject);
}

TEST_F(EntityInfoTest, RefusesACategoryThatIsNone) {
  for (const int number : {3, 6, 255}) {
    const auto category = static_cast<std::uint8_t>(number);
    const Result result = infos_.set(world_.model("stone"), {{category}, {}, {}});
    EXPECT_EQ(result.result, Result::kResultOperationFailed);
    EXPECT_EQ(result.error_message, "there is no category " + std::to_string(category) + ": 0, 1, 2, 4 and 5 are some");
  }
  EXPECT_EQ(categoryOf("stone"), Category::kCategoryObject);
}

TEST(TagsFilter, WantsAnyOrAll) {
  const std::vector<std::string> tags{"a", "b"};
  EXPECT_TRUE(matches({{}, si::TagsFilter::kFilterModeAll}, tags));
  EXPECT_TRUE(matches({{"a", "c"}, si::TagsFilter::kFilterModeAny}, tags));
  EXPECT_FALSE(matches({{"a", "c"}, si::TagsFilter::kFilterModeAll}, tags));
  EXPECT_TRUE(matches({{"b", "a"}, si::TagsFilter::kFilterModeAll}, tags));
  EXPECT_FALSE(matches({{"c"}, si::TagsFilter::kFilterModeAny}, tags));
  EXPECT_FALSE(matches({{"c"}, si::TagsFilter::kFilterModeAny}, {}));
  EXPECT_EQ(filterError({{}, 1}), std::nullopt);
  EXPECT_EQ(filterError({{}, 2}), "there is no filter mode 2: 0 is any tag, 1 is all");
}

}  // namespace
}  // namespace pongsim::ros2::entity_info_test
