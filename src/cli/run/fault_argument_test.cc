#include "cli/run/fault_argument.hh"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "shared/program/failure.hh"

namespace pongsim::cli {
namespace {

TEST(FaultArgument, BecomesAnElementOfOneSystem) {
  std::vector<Element> systems;
  addFault("drop topic=/lidar  probability=0.3", systems);
  addFault("stick joint=arm::elbow", systems);
  ASSERT_EQ(systems.size(), 1U);
  EXPECT_EQ(systems[0].attributeOr("filename", ""), "pongsim-faults-system");
  ASSERT_EQ(systems[0].children.size(), 2U);
  const Element& drop = systems[0].children[0];
  EXPECT_EQ(drop.name, "fault");
  EXPECT_EQ(drop.attributeOr("type", ""), "drop");
  EXPECT_EQ(drop.attributeOr("topic", ""), "/lidar");
  const Element::Attribute* probability = drop.attribute("probability");
  ASSERT_NE(probability, nullptr);
  EXPECT_EQ(probability->value, "0.3");
  EXPECT_EQ(*probability->position.file, "--fault");
  EXPECT_EQ(probability->position.line, 1);
  EXPECT_EQ(probability->position.column, 20);
  EXPECT_EQ(systems[0].children[1].attributes[1].position.line, 2);
}

TEST(FaultArgument, HasAForm) {
  const auto errorOf = [](const std::string& text) -> std::string {
    try {
      std::vector<Element> systems;
      addFault(text, systems);
    } catch (const UsageError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(errorOf(" "), "option '--fault' takes a fault, and is empty");
  EXPECT_EQ(errorOf("topic=/a drop"), "option '--fault' takes a type first, not 'topic=/a'");
  EXPECT_EQ(errorOf("drop /a"), "option '--fault' takes NAME=VALUE after the type, not '/a'");
  EXPECT_EQ(errorOf("drop =/a"), "option '--fault' takes NAME=VALUE after the type, not '=/a'");
}

}  // namespace
}  // namespace pongsim::cli
