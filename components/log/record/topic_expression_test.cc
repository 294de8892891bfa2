#include "log/record/topic_expression.hh"

#include <gtest/gtest.h>

#include <stdexcept>

namespace pongsim::log {
namespace {

TEST(TopicExpression, IsForWholeNames) {
  const TopicExpression expression("/model/.*/odom|/clock");
  EXPECT_TRUE(expression.matches("/model/rover/odom"));
  EXPECT_TRUE(expression.matches("/clock"));
  EXPECT_FALSE(expression.matches("/world/a/clock"));
  EXPECT_FALSE(expression.matches("/model/rover/odometry"));
}

TEST(TopicExpression, ThatIsNoneIsRefused) {
  EXPECT_THROW(TopicExpression("/model/("), std::invalid_argument);
  EXPECT_THROW(TopicExpression("*"), std::invalid_argument);
}

}  // namespace
}  // namespace pongsim::log
