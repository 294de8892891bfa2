#pragma once

#include <memory>
#include <string>
#include <vector>

namespace pongsim::test {

/// A regular expression (ECMAScript). Each file that includes <regex> takes seconds longer to compile; this does not.
class Regex {
 public:
  /// What an expression matches, and after that what each of its groups does.
  using Match = std::vector<std::string>;

  explicit Regex(const std::string& expression);

  /// @return Whether it matches the whole text.
  bool matches(const std::string& text) const;
  /// @return Whether it matches some part of the text.
  bool isIn(const std::string& text) const;
  /// @return The first part of the text that it matches; empty if there is none.
  Match firstIn(const std::string& text) const;
  /// @return All parts of the text that it matches, in order.
  std::vector<Match> allIn(const std::string& text) const;
  /// @return The text with `replacement` in place of each part that it matches.
  std::string replaceAll(const std::string& text, const std::string& replacement) const;

 private:
  struct Expression;
  std::shared_ptr<const Expression> expression_;
};

}  // namespace pongsim::test
