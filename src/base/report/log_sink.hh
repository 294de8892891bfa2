#pragma once

#include "pongsim/program/log_sink.hh"

namespace pongsim {

/// Passes a message to the sinks that want it; costs almost nothing if there are none.
void tellSinks(const LogRecord& record);

}  // namespace pongsim
