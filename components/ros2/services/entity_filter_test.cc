#include "ros2/services/entity_filter.hh"

#include <gtest/gtest.h>

#include "support/running_world.hh"

namespace pongsim::ros2::entity_filter_test {
namespace {

namespace si = simulation_interfaces;
using Names = std::vector<std::string>;

class EntityFilterTest : public testing::Test {
 protected:
  Names taken(const si::EntityFilters& asked) {
    const auto filter = EntityFilter::from(asked, result_);
    Names names;
    if (!filter) return {"error"};
    for (const Model& model : world_.simulation().world().models()) {
      if (filter->takes(world_.simulation().world(), model, infos_)) names.emplace_back(model.name());
    }
    return names;
  }
  Names named(const std::string& expression) {
    si::EntityFilters filters;
    filters.filter = expression;
    return taken(filters);
  }

  test::RunningWorld world_{std::string(
      "<model name='box_1'><static>true</static><link name='l'><collision name='c'><geometry><box><size>1 1 "
      "1</size></box>"
      "</geometry></collision></link></model>"
      "<model name='box_2'><pose>9 0 0 0 0 0</pose><link name='l'/></model>"
      "<model name='tree'><static>true</static><link name='l'/></model>")};
  EntityInfos infos_;
  Result result_;
};

TEST_F(EntityFilterTest, SearchesNamesForAPosixExpression) {
  EXPECT_EQ(named(""), (Names{"box_1", "box_2", "tree"}));
  EXPECT_EQ(named("box"), (Names{"box_1", "box_2"}));
  EXPECT_EQ(named("^(box_2|tree)$"), (Names{"box_2", "tree"}));
  EXPECT_EQ(named("[[:digit:]]$"), (Names{"box_1", "box_2"}));
  EXPECT_EQ(named("^.{4}$"), (Names{"tree"}));
  EXPECT_EQ(named("nothing"), Names{});
}

TEST_F(EntityFilterTest, RefusesWhatIsNoExpressionOrWouldTakeForEver) {
  EXPECT_EQ(named("box["), Names{"error"});
  EXPECT_EQ(result_.result, Result::kResultOperationFailed);
  EXPECT_TRUE(result_.error_message.starts_with("filter 'box[' is not a regular expression (POSIX Extended): "))
      << result_.error_message;
  EXPECT_EQ(named("((((a{900}){900}){900}){900}){900}"), Names{"error"});
  EXPECT_EQ(named(std::string(2'000'000, '(')), Names{"error"});
  EXPECT_LT(result_.error_message.size(), 1000U);
  EXPECT_EQ(named("(x+x+)+y"), Names{});
}

TEST_F(EntityFilterTest, TakesWhatAllPartsTake) {
  si::EntityFilters filters;
  filters.categories = {{si::EntityCategory::kCategoryStaticObject}};
  EXPECT_EQ(taken(filters), (Names{"box_1", "tree"}));
  filters.categories.push_back({si::EntityCategory::kCategoryObject});
  EXPECT_EQ(taken(filters), (Names{"box_1", "box_2", "tree"}));
  filters.filter = "1|2";
  infos_.set(world_.model("box_2"), {{}, "", {"red"}});
  filters.tags.tags = {"red"};
  EXPECT_EQ(taken(filters), Names{"box_2"});
  filters.bounds.type = si::Bounds::kTypeSphere;
  filters.bounds.points = {{0, 0, 0}, {2, 0, 0}};
  EXPECT_EQ(taken(filters), Names{});
  filters.tags.tags.clear();
  EXPECT_EQ(taken(filters), Names{"box_1"});
}

TEST_F(EntityFilterTest, RefusesBoundsAndModesThatAreNone) {
  si::EntityFilters filters;
  filters.bounds.type = 4;
  EXPECT_EQ(taken(filters), Names{"error"});
  EXPECT_EQ(result_.result, Result::kResultFeatureUnsupported);
  EXPECT_EQ(result_.error_message, "there is no type 4 of bounds");
  filters.bounds.type = si::Bounds::kTypeBox;
  EXPECT_EQ(taken(filters), Names{"error"});
  EXPECT_EQ(result_.result, Result::kResultOperationFailed);
  filters = {};
  filters.tags.filter_mode = 9;
  EXPECT_EQ(taken(filters), Names{"error"});
  EXPECT_EQ(result_.error_message, "there is no filter mode 9: 0 is any tag, 1 is all");
}

}  // namespace
}  // namespace pongsim::ros2::entity_filter_test
