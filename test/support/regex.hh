#pragma once

#include <memory>
#include <string>
#include <vector>

namespace pongsim::test {

/// A regular expression (ECMAScript). Hides <regex>, which takes seconds to compile in each file that includes it.
class Regex {
 public:
  /// The text that the expression matches, then the text of each group.
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
