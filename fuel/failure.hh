#pragma once

#include "programs/failure.hh"

namespace pongsim::fuel {

using programs::Failure;
using programs::UsageError;

/// One that another try may be rid of: the server or the way to it failed.
class PassingFailure : public Failure {
 public:
  using Failure::Failure;
};

/// The user ended it.
class Interrupted : public Failure {
 public:
  Interrupted() : Failure("it was interrupted", "what was downloaded is kept: try again to resume") {}
};

}  // namespace pongsim::fuel
