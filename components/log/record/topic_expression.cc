#include "log/record/topic_expression.hh"

#include <regex>
#include <stdexcept>

namespace pongsim::log {

struct TopicExpression::Compiled {
  std::regex value;
};

TopicExpression::TopicExpression(const std::string& expression) try
    : compiled_(std::make_shared<const Compiled>(Compiled{std::regex(expression)})) {
} catch (const std::regex_error& error) {
  throw std::invalid_argument(error.what());
}

bool TopicExpression::matches(const std::string& topic) const { return std::regex_match(topic, compiled_->value); }

}  // namespace pongsim::log
