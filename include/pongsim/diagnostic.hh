#pragma once

#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "pongsim/export.hh"

namespace pongsim {

/// A place in a text that a user wrote. Lines and columns count from 1; 0 means that it is not known.
struct SourcePosition {
  /// The file's name as the user gave it; null where there is no file.
  std::shared_ptr<const std::string> file;
  int line = 0;
  int column = 0;
  bool operator==(const SourcePosition&) const = default;
};

enum class Severity { kWarning, kError };

/// One thing that is wrong, where, and what to do about it.
struct Diagnostic {
  Severity severity = Severity::kError;
  SourcePosition position;
  /// One line without a full stop, naming the thing: "joint 'left_wheel_joint' has no <child>".
  std::string message;
  /// One line of help, or empty.
  std::string hint;
  /// Where the file of `position` is included, where that file is included, and so on; empty for the file that the user
  /// named.
  std::vector<SourcePosition> includedFrom = {};
};

/// @return "world.sdf:41:9: error: joint 'j' has no <child>", and below it the hint and where the file is included.
PONGSIM_API std::string format(const Diagnostic& diagnostic);

/// A line of a source, or a part of it, in UTF-8, without its end.
struct SourceExcerpt {
  std::string_view text;
  /// That of the first letter of `text`.
  int firstColumn = 1;
  /// The line goes on behind it.
  bool isCutOff = false;
};

/// As `format`, with the line of the source and a mark under the diagnostic's column below the first line.
/// @param source Of line `position.line` of the file. Of a long line a part around the column is shown.
/// @param hasColors For a terminal that knows them.
PONGSIM_API std::string format(const Diagnostic& diagnostic, const SourceExcerpt& source, bool hasColors = false);

/// What was found wrong while reading something, in the order in which it was found.
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

/// Thrown where a value asked for can't be had, with the place in the user's text to blame.
class PONGSIM_API Error : public std::runtime_error {
 public:
  explicit Error(Diagnostic diagnostic);
  const Diagnostic& diagnostic() const { return diagnostic_; }

 private:
  Diagnostic diagnostic_;
};

}  // namespace pongsim
