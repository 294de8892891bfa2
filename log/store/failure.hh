#pragma once

#include <stdexcept>
#include <string>
#include <utility>

namespace pongsim::log {

/// Why a log can't be written or read, in a sentence without a full stop that names the file, and what can be done
/// about it.
class Failure : public std::runtime_error {
 public:
  explicit Failure(const std::string& message, std::string hint = {})
      : std::runtime_error(message), hint_(std::move(hint)) {}
  /// One line of help, or empty.
  const std::string& hint() const { return hint_; }

 private:
  std::string hint_;
};

}  // namespace pongsim::log
