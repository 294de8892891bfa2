#pragma once

#include <initializer_list>
#include <ostream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace pongsim {

/// Writes XML from the root to its end, one element per line.
class XmlWriter {
 public:
  using Attributes = std::initializer_list<std::pair<std::string_view, std::string_view>>;

  /// @param out Must outlive it.
  explicit XmlWriter(std::ostream& out);

  /// Begins an element; `end` ends the one that was begun last.
  void begin(std::string_view name, Attributes attributes = {});
  void end();

  /// Writes an element with text, or an empty one.
  void add(std::string_view name, Attributes attributes = {}, std::string_view text = {});

 private:
  void open(std::string_view name, Attributes attributes);

  std::ostream& out_;
  std::vector<std::string> names_;
};

/// @return The text, escaped for XML; characters that XML does not allow become question marks.
std::string escaped(std::string_view text);

}  // namespace pongsim
