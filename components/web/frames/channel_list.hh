#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

#include "web/server/session.hh"

namespace pongsim::web {

/// The own channels of all worlds in the process.
class ChannelList final : public OwnChannels {
 public:
  void add(std::shared_ptr<OwnChannel> channel);
  void remove(const OwnChannel& channel);

  std::vector<std::shared_ptr<OwnChannel>> all() const override;
  std::uint64_t version() const override { return version_; }

 private:
  mutable std::mutex mutex_;
  std::vector<std::shared_ptr<OwnChannel>> channels_;
  std::atomic<std::uint64_t> version_ = 0;
};

}  // namespace pongsim::web
