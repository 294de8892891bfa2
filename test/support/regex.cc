#include "support/regex.hh"

#include <regex>

namespace pongsim::test {

struct Regex::Expression {
  std::regex value;
};

Regex::Regex(const std::string& expression)
    : expression_(std::make_shared<const Expression>(Expression{std::regex(expression)})) {}

bool Regex::matches(const std::string& text) const { return std::regex_match(text, expression_->value); }

bool Regex::isIn(const std::string& text) const { return std::regex_search(text, expression_->value); }

Regex::Match Regex::firstIn(const std::string& text) const {
  std::smatch found;
  return std::regex_search(text, found, expression_->value) ? Match(found.begin(), found.end()) : Match();
}

std::vector<Regex::Match> Regex::allIn(const std::string& text) const {
  std::vector<Match> all;
  for (std::sregex_iterator found(text.begin(), text.end(), expression_->value), end; found != end; ++found) {
    all.emplace_back(found->begin(), found->end());
  }
  return all;
}

std::string Regex::replaceAll(const std::string& text, const std::string& replacement) const {
  return std::regex_replace(text, expression_->value, replacement);
}

}  // namespace pongsim::test
