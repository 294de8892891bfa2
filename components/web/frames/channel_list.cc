#include "web/frames/channel_list.hh"

#include <utility>

namespace pongsim::web {

void ChannelList::add(std::shared_ptr<OwnChannel> channel) {
  const std::lock_guard lock(mutex_);
  channels_.push_back(std::move(channel));
  ++version_;
}

void ChannelList::remove(const OwnChannel& channel) {
  const std::lock_guard lock(mutex_);
  std::erase_if(channels_, [&](const auto& each) { return each.get() == &channel; });
  ++version_;
}

std::vector<std::shared_ptr<OwnChannel>> ChannelList::all() const {
  const std::lock_guard lock(mutex_);
  return channels_;
}

}  // namespace pongsim::web
