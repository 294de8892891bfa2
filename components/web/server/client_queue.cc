#include "web/server/client_queue.hh"

#include <cassert>
#include <utility>

namespace pongsim::web {

bool ClientQueue::add(Item item) {
  const std::lock_guard lock(mutex_);
  if (reliableBytes_ + item.frame.size() > limits_.waitingBytes || reliable_.size() >= limits_.waitingMessages)
    return false;
  reliableBytes_ += item.frame.size();
  reliable_.push_back(std::move(item));
  return true;
}

void ClientQueue::addData(std::uint64_t key, std::size_t most, Frame frame) {
  addToKey(key, most, {.frame = std::move(frame), .make = {}, .key = key});
}

void ClientQueue::addMaker(std::uint64_t key, std::function<Frame()> make) {
  addToKey(key, 1, {.frame = {}, .make = std::move(make), .key = key});
}

void ClientQueue::addToKey(std::uint64_t key, std::size_t most, Data data) {
  const std::lock_guard lock(mutex_);
  auto found = keys_.find(key);
  if (found != keys_.end()) {
    // drops the oldest frames; the key keeps its place in the order of turns
    std::deque<Data>& frames = found->second.frames;
    while (!frames.empty() && frames.size() >= most) {
      dataBytes_ -= frames.front().frame.size();
      frames.pop_front();
      ++dropped_;
    }
  }
  const std::size_t size = data.frame.size();
  const bool isFull = found == keys_.end() && keys_.size() >= limits_.waitingKeys;
  if (isFull || dataBytes_ + size > limits_.waitingBytes) {
    ++dropped_;
    if (found != keys_.end() && found->second.frames.empty()) {
      turns_.erase(found->second.turn);
      keys_.erase(found);
    }
    return;
  }
  if (found == keys_.end()) found = keys_.emplace(key, KeyQueue{{}, turns_.insert(turns_.end(), key)}).first;
  dataBytes_ += size;
  found->second.frames.push_back(std::move(data));
}

void ClientQueue::forget(std::uint64_t key) {
  const std::lock_guard lock(mutex_);
  const auto found = keys_.find(key);
  if (found == keys_.end()) return;
  for (const Data& each : found->second.frames) dataBytes_ -= each.frame.size();
  turns_.erase(found->second.turn);
  keys_.erase(found);
}

void ClientQueue::clear() {
  const std::lock_guard lock(mutex_);
  reliable_.clear();
  reliableBytes_ = 0;
  keys_.clear();
  turns_.clear();
  dataBytes_ = 0;
}

std::optional<ClientQueue::Data> ClientQueue::takeData() {
  const std::lock_guard lock(mutex_);
  if (turns_.empty()) return std::nullopt;
  const auto found = keys_.find(turns_.front());
  assert(found != keys_.end() && !found->second.frames.empty());
  KeyQueue& queue = found->second;
  Data data = std::move(queue.frames.front());
  queue.frames.pop_front();
  dataBytes_ -= data.frame.size();
  if (queue.frames.empty()) {
    turns_.pop_front();
    keys_.erase(found);
  } else {
    turns_.splice(turns_.end(), turns_, queue.turn);
  }
  return data;
}

std::optional<ClientQueue::Item> ClientQueue::take() {
  {
    const std::lock_guard lock(mutex_);
    if (!reliable_.empty()) {
      Item item = std::move(reliable_.front());
      reliable_.pop_front();
      reliableBytes_ -= item.frame.size();
      return item;
    }
  }
  while (std::optional<Data> data = takeData()) {
    // without the lock, because `make` may take long
    if (data->make) data->frame = data->make();
    const bool isText = data->frame.isText;
    if (data->frame.size() > 0) return Item{.isText = isText, .frame = std::move(data->frame), .key = data->key};
  }
  return std::nullopt;
}

bool ClientQueue::isEmpty() const {
  const std::lock_guard lock(mutex_);
  return reliable_.empty() && turns_.empty();
}

std::uint64_t ClientQueue::dropped() const {
  const std::lock_guard lock(mutex_);
  return dropped_;
}

}  // namespace pongsim::web
