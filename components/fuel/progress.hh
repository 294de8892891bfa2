#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <mutex>
#include <string>

namespace pongsim::fuel {

/// Reports the progress of several downloads on standard error: on a terminal by a bar, elsewhere by a line at the
/// start and the end of each. For any thread.
class Progress {
 public:
  /// @param level 0 to 4, like `-v`: from 3 on progress, from 2 on warnings.
  Progress(int level, bool isTerminal);
  /// Removes the bar.
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// @param done Bytes from an earlier attempt. @param total 0: unknown.
  void begin(const std::string& name, std::uint64_t done, std::uint64_t total);
  void add(const std::string& name, std::uint64_t bytes);
  /// @param note "3.2 MB", or why nothing was downloaded.
  void end(const std::string& name, const std::string& note);
  /// Ends a failed download without a line; its reason is reported elsewhere.
  void drop(const std::string& name);

  void info(const std::string& line);
  void warning(const std::string& line);

 private:
  struct Item {
    std::uint64_t done = 0, total = 0;
  };
  void say(const std::string& line);
  void draw(bool isForced);
  void clear();

  const int level_;
  const bool isTerminal_;
  std::mutex mutex_;
  std::map<std::string, Item> items_;
  std::uint64_t finishedBytes_ = 0;
  std::size_t finished_ = 0;
  std::uint64_t sinceStart_ = 0;
  bool isDrawn_ = false;
  std::chrono::steady_clock::time_point start_, last_;
};

/// @return "12 B", "3.4 kB", "1.2 MB", in units of 1000.
std::string sizeText(std::uint64_t bytes);

}  // namespace pongsim::fuel
