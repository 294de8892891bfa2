#pragma once

#include <stdexcept>
#include <string>
#include <utility>

#include "fuel/failure.hh"

namespace pongsim::fuel {

constexpr int kDone = 0, kFailed = 1, kWrongUsage = 2;

/// A command line that can't be meant.
class UsageError : public Failure {
 public:
  using Failure::Failure;
};

/// Says on standard error what is wrong, with what can be done about it.
void sayError(const std::string& message, const std::string& hint = {});

/// Writes to standard output.
/// @throws Failure where that can't be written.
void print(const std::string& text);

/// @return Whether standard output is a terminal that is to have colours.
bool outputHasColors();

}  // namespace pongsim::fuel
