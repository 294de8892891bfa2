#pragma once

#include "shared/program/failure.hh"

namespace pongsim::log {

/// Why a log can't be written or read; names the file.
using cli::Failure;

}  // namespace pongsim::log
