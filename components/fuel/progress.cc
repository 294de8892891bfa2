#include "fuel/progress.hh"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>

namespace pongsim::fuel {

namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds kBetweenDraws{100};
constexpr int kBar = 20;

void writeError(const std::string& text) { std::fwrite(text.data(), 1, text.size(), stderr); }

std::size_t terminalWidth() {
  winsize size{};
  return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

}  // namespace

std::string sizeText(std::uint64_t bytes) {
  constexpr std::array<const char*, 5> kUnits{"B", "kB", "MB", "GB", "TB"};
  double value = static_cast<double>(bytes);
  std::size_t unit = 0;
  while (value >= 999.95 && unit + 1 < kUnits.size()) {
    value /= 1000;
    ++unit;
  }
  char text[32];
  std::snprintf(text, sizeof text, unit == 0 ? "%.0f %s" : "%.1f %s", value, kUnits.at(unit));
  return text;
}

Progress::Progress(int level, bool isTerminal) : level_(level), isTerminal_(isTerminal), start_(Clock::now()) {}

Progress::~Progress() { clear(); }

void Progress::begin(const std::string& name, std::uint64_t done, std::uint64_t total) {
  const std::scoped_lock lock(mutex_);
  items_[name] = {done, total};
  if (!isTerminal_ && level_ >= 3) {
    say("downloading " + name + (total > 0 ? ", " + sizeText(total) : "") +
        (done > 0 ? ", from byte " + std::to_string(done) + " on" : ""));
  }
  draw(true);
}

void Progress::add(const std::string& name, std::uint64_t bytes) {
  const std::scoped_lock lock(mutex_);
  items_[name].done += bytes;
  sinceStart_ += bytes;
  draw(false);
}

void Progress::end(const std::string& name, const std::string& note) {
  const std::scoped_lock lock(mutex_);
  finishedBytes_ += items_[name].done;
  ++finished_;
  items_.erase(name);
  if (level_ >= 3) say(name + ": " + note);
  draw(true);
}

void Progress::drop(const std::string& name) {
  const std::scoped_lock lock(mutex_);
  items_.erase(name);
  draw(true);
}

void Progress::info(const std::string& line) {
  const std::scoped_lock lock(mutex_);
  if (level_ >= 3) say(line);
}

void Progress::warning(const std::string& line) {
  const std::scoped_lock lock(mutex_);
  if (level_ >= 2) say("warning: " + line);
}

void Progress::say(const std::string& line) {
  clear();
  writeError("pongsim: " + line + "\n");
}

void Progress::clear() {
  if (isDrawn_) writeError("\r\x1b[K");
  isDrawn_ = false;
}

void Progress::draw(bool isForced) {
  if (!isTerminal_ || level_ < 3) return;
  const Clock::time_point now = Clock::now();
  if (!isForced && now - last_ < kBetweenDraws) return;
  last_ = now;
  if (items_.empty()) return clear();
  std::uint64_t done = finishedBytes_, total = finishedBytes_;
  std::string names;
  bool isKnown = true;
  for (const auto& [name, item] : items_) {
    done += item.done;
    total += std::max(item.total, item.done);
    isKnown = isKnown && item.total > 0;
    names += (names.empty() ? "" : ", ") + name;
  }
  std::string line;
  if (isKnown && total > 0) {
    const double part = static_cast<double>(done) / static_cast<double>(total);
    const auto full = static_cast<std::size_t>(part * kBar);
    line = "[" + std::string(full, '=') + std::string(kBar - full, ' ') + "] " +
           std::to_string(static_cast<int>(part * 100)) + " %  " + sizeText(done) + " of " + sizeText(total);
  } else {
    line = sizeText(done);
  }
  const double seconds = std::chrono::duration<double>(now - start_).count();
  if (seconds > 1)
    line += "  " + sizeText(static_cast<std::uint64_t>(static_cast<double>(sinceStart_) / seconds)) + "/s";
  line += "  " + names;
  const std::size_t width = terminalWidth() - 1;
  if (line.size() > width) {
    // does not cut a UTF-8 character: bytes 10xxxxxx continue one
    std::size_t end = width;
    while (end > 0 && (static_cast<unsigned char>(line[end]) & 0xc0U) == 0x80U) --end;
    line.resize(end);
  }
  writeError("\r\x1b[K" + line);
  isDrawn_ = true;
}

}  // namespace pongsim::fuel
