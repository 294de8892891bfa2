#pragma once

#include "pongsim/program/log_sink.hh"

namespace pongsim {

/// Hands a message to the sinks that want it; next to nothing where there are none.
void tellSinks(const LogRecord& record);

}  // namespace pongsim
