#include "web/world/recent_log.hh"

#include <string_view>
#include <utility>

namespace pongsim::web {

namespace {

/// @return The text, or its beginning, which does not end inside a UTF-8 character.
std::string_view cut(std::string_view text) {
  if (text.size() <= RecentLog::kLongest) return text;
  std::size_t end = RecentLog::kLongest;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xc0U) == 0x80U) --end;
  return text.substr(0, end);
}

}  // namespace

std::shared_ptr<void> RecentLog::watch(Callback callback) {
  const auto shared = std::make_shared<const Callback>(std::move(callback));
  const std::lock_guard lock(mutex_);
  for (const Line& line : kept_) (*shared)(line);
  watches_.push_back(shared);
  return {this, [this, shared](void*) {
            const std::lock_guard ending(mutex_);
            std::erase(watches_, shared);
          }};
}

void RecentLog::add(const LogRecord& record) {
  const std::lock_guard lock(mutex_);
  kept_.push_back(
      {std::chrono::system_clock::now(), record.level, std::string(record.speaker), std::string(cut(record.message))});
  if (kept_.size() > kKept) kept_.pop_front();
  for (const auto& watch : watches_) (*watch)(kept_.back());
}

}  // namespace pongsim::web
