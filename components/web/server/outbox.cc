#include "web/server/outbox.hh"

#include <utility>

namespace pongsim::web {

bool Outbox::add(Item item) {
  const std::lock_guard lock(mutex_);
  if (firstBytes_ + item.frame.size() > limits_.waitingBytes || first_.size() >= limits_.waitingMessages) return false;
  firstBytes_ += item.frame.size();
  first_.push_back(std::move(item));
  return true;
}

void Outbox::addData(std::uint64_t key, std::size_t most, Frame frame) {
  addWaiting(key, most, {.frame = std::move(frame), .make = {}});
}

void Outbox::addMaker(std::uint64_t key, std::function<Frame()> make) {
  addWaiting(key, 1, {.frame = {}, .make = std::move(make)});
}

void Outbox::addWaiting(std::uint64_t key, std::size_t most, Waiting waiting) {
  const std::lock_guard lock(mutex_);
  auto found = lines_.find(key);
  if (found != lines_.end()) {
    // the oldest frames are dropped; the key keeps its turn
    std::deque<Waiting>& line = found->second.waiting;
    while (!line.empty() && line.size() >= most) {
      dataBytes_ -= line.front().frame.size();
      line.pop_front();
      ++dropped_;
    }
  }
  const std::size_t size = waiting.frame.size();
  const bool isFull = found == lines_.end() && lines_.size() >= limits_.waitingKeys;
  if (isFull || dataBytes_ + size > limits_.waitingBytes) {
    ++dropped_;
    if (found != lines_.end() && found->second.waiting.empty()) {
      turns_.erase(found->second.turn);
      lines_.erase(found);
    }
    return;
  }
  if (found == lines_.end()) found = lines_.emplace(key, Line{{}, turns_.insert(turns_.end(), key)}).first;
  dataBytes_ += size;
  found->second.waiting.push_back(std::move(waiting));
}

void Outbox::forget(std::uint64_t key) {
  const std::lock_guard lock(mutex_);
  const auto found = lines_.find(key);
  if (found == lines_.end()) return;
  for (const Waiting& each : found->second.waiting) dataBytes_ -= each.frame.size();
  turns_.erase(found->second.turn);
  lines_.erase(found);
}

void Outbox::clear() {
  const std::lock_guard lock(mutex_);
  first_.clear();
  firstBytes_ = 0;
  lines_.clear();
  turns_.clear();
  dataBytes_ = 0;
}

std::optional<Outbox::Waiting> Outbox::takeData() {
  const std::lock_guard lock(mutex_);
  if (turns_.empty()) return std::nullopt;
  const auto found = lines_.find(turns_.front());
  Line& line = found->second;
  Waiting waiting = std::move(line.waiting.front());
  line.waiting.pop_front();
  dataBytes_ -= waiting.frame.size();
  if (line.waiting.empty()) {
    turns_.pop_front();
    lines_.erase(found);
  } else {
    turns_.splice(turns_.end(), turns_, line.turn);
  }
  return waiting;
}

std::optional<Outbox::Item> Outbox::take() {
  {
    const std::lock_guard lock(mutex_);
    if (!first_.empty()) {
      Item item = std::move(first_.front());
      first_.pop_front();
      firstBytes_ -= item.frame.size();
      return item;
    }
  }
  while (std::optional<Waiting> waiting = takeData()) {
    // without the lock, because it may take long
    if (waiting->make) waiting->frame = waiting->make();
    if (waiting->frame.size() > 0) return Item{.isText = false, .frame = std::move(waiting->frame)};
  }
  return std::nullopt;
}

bool Outbox::isEmpty() const {
  const std::lock_guard lock(mutex_);
  return first_.empty() && turns_.empty();
}

std::uint64_t Outbox::dropped() const {
  const std::lock_guard lock(mutex_);
  return dropped_;
}

}  // namespace pongsim::web
