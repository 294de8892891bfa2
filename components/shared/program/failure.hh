#pragma once

#include <stdexcept>
#include <string>
#include <utility>

namespace pongsim::cli {

/// Why something failed, as a sentence without a full stop, with a hint.
class Failure : public std::runtime_error {
 public:
  explicit Failure(const std::string& message, std::string hint = {})
      : std::runtime_error(message), hint_(std::move(hint)) {}
  /// One line of advice, or empty.
  const std::string& hint() const { return hint_; }

 private:
  std::string hint_;
};

/// The command line is wrong; ends the program with `kWrongUsage`.
class UsageError : public Failure {
 public:
  using Failure::Failure;
};

}  // namespace pongsim::cli
