#pragma once

#include <cstddef>
#include <string_view>

#include "base/text.hh"

namespace pongsim::sdf {

/// Characters that separate words, like isspace in the C locale.
using base::kWhiteSpace;

/// Converts offsets to lines and columns. Offsets must not decrease, so that all together take one pass.
class TextCursor {
 public:
  explicit TextCursor(std::string_view text) : text_(text), offset_(startOf(text)) {}

  /// @return Where the text begins: after the byte order mark, if there is one.
  static std::size_t startOf(std::string_view text) { return text.starts_with("\xEF\xBB\xBF") ? 3 : 0; }

  void advanceTo(std::size_t offset) {
    for (; offset_ < offset && offset_ < text_.size(); ++offset_) {
      const auto byte = static_cast<unsigned char>(text_[offset_]);
      if (byte == '\n') {
        ++line_;
        column_ = 1;
      } else if ((byte & 0xC0U) != 0x80U) {
        ++column_;  // counts characters, not bytes
      }
    }
  }

  std::size_t offset() const { return offset_; }
  int line() const { return line_; }
  int column() const { return column_; }

 private:
  std::string_view text_;
  std::size_t offset_;
  int line_ = 1;
  int column_ = 1;
};

}  // namespace pongsim::sdf
