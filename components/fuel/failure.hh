#pragma once

#include "shared/program/failure.hh"

namespace pongsim::fuel {

using cli::Failure;
using cli::UsageError;

/// A temporary failure of the server or the network: a retry may succeed.
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
