#pragma once

#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "pongsim/export.hh"

namespace pongsim {

/// A position in a text. Lines and columns count from 1; 0 means unknown.
struct SourcePosition {
  /// The file's name as the user gave it; null without a file.
  std::shared_ptr<const std::string> file;
  int line = 0;
  int column = 0;
  bool operator==(const SourcePosition&) const = default;
};

enum class Severity { kWarning, kError };

/// An error or warning: where it is, what is wrong, and how to fix it.
struct Diagnostic {
  Severity severity = Severity::kError;
  SourcePosition position;
  /// One line without a full stop that names the thing: "joint 'left_wheel_joint' has no <child>".
  std::string message;
  /// One line with a hint, or empty.
  std::string hint;
  /// Where the file of `position` is included, where that file is included, and so on; empty for the top-level file.
  std::vector<SourcePosition> includedFrom = {};
};

/// @return "world.sdf:41:9: error: joint 'j' has no <child>", followed by the hint and the chain of includes.
PONGSIM_API std::string format(const Diagnostic& diagnostic);

/// A line of a source file, or a part of it, in UTF-8, without its line break.
struct SourceExcerpt {
  std::string_view text;
  /// Column of the first character of `text`.
  int firstColumn = 1;
  /// Whether the line continues after `text`.
  bool isCutOff = false;
};

/// As `format`, with the source line and a mark under the diagnostic's column.
/// @param source Line `position.line` of the file. A long line is cut to the part around the column.
/// @param hasColors Whether to use terminal colours.
PONGSIM_API std::string format(const Diagnostic& diagnostic, const SourceExcerpt& source, bool hasColors = false);

/// Errors and warnings, in the order in which they were found.
class PONGSIM_API Diagnostics {
 public:
  void error(SourcePosition position, std::string message, std::string hint = {});
  void warning(SourcePosition position, std::string message, std::string hint = {});
  void add(Diagnostic diagnostic);

  bool hasErrors() const { return errorCount_ > 0; }
  const std::vector<Diagnostic>& all() const { return all_; }

 private:
  std::vector<Diagnostic> all_;
  std::size_t errorCount_ = 0;
};

/// An invalid value in a user's file, with its position.
class PONGSIM_API Error : public std::runtime_error {
 public:
  explicit Error(Diagnostic diagnostic);
  const Diagnostic& diagnostic() const { return diagnostic_; }

 private:
  Diagnostic diagnostic_;
};

}  // namespace pongsim
