#pragma once

#include <stdexcept>
#include <string>
#include <utility>

namespace pongsim::fuel {

/// Why something can't be done, in a sentence without a full stop, and what can be done about it.
class Failure : public std::runtime_error {
 public:
  explicit Failure(const std::string& message, std::string hint = {})
      : std::runtime_error(message), hint_(std::move(hint)) {}
  const std::string& hint() const { return hint_; }

 private:
  std::string hint_;
};

/// One that another try may be rid of: the server or the way to it failed.
class PassingFailure : public Failure {
 public:
  using Failure::Failure;
};

/// The user ended it.
class Interrupted : public Failure {
 public:
  Interrupted() : Failure("it was interrupted", "what has been downloaded is kept: the next try goes on from there") {}
};

}  // namespace pongsim::fuel
