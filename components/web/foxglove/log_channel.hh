#pragma once

#include <memory>
#include <string>

#include "web/foxglove/channel.hh"
#include "web/world/recent_log.hh"

namespace pongsim::web::foxglove {

/// The channel with the process's warnings and errors, "/foxglove/log", as foxglove.Log. For the server's thread.
class LogChannel {
 public:
  /// @param log Must outlive it.
  explicit LogChannel(RecentLog& log);

  const Channel& channel() const { return channel_; }

 private:
  Channel channel_;
};

}  // namespace pongsim::web::foxglove
