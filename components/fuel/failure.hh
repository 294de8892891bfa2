#pragma once

#include "shared/program/failure.hh"

namespace pongsim::fuel {

using cli::Failure;
using cli::UsageError;

/// A failure that may not occur again: of the server or the network.
class PassingFailure : public Failure {
 public:
  using Failure::Failure;
};

/// The user interrupted the work.
class Interrupted : public Failure {
 public:
  Interrupted() : Failure("it was interrupted", "what was downloaded is kept: try again to resume") {}
};

}  // namespace pongsim::fuel
