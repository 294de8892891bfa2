#pragma once

#include <string_view>

namespace pongsim::cli {

/// Tells the service manager that started this process, if one did and asked for it (sd_notify(3): the environment
/// variable NOTIFY_SOCKET), that the work goes on from here, and in a line which it is. Without one it does nothing.
/// Says where it can't be told.
void tellReady(std::string_view status);

/// Likewise, that the work comes to its end.
void tellStopping();

}  // namespace pongsim::cli
