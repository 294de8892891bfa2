#pragma once

#include <string_view>

namespace pongsim::cli {

/// Notifies the service manager that started this process, if it asks for it (sd_notify(3): the environment variable
/// NOTIFY_SOCKET), that startup is complete, with a status line. Does nothing without one. Reports failures.
void tellReady(std::string_view status);

/// Notifies it that the process is stopping.
void tellStopping();

}  // namespace pongsim::cli
