#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <mutex>
#include <string>

namespace pongsim::fuel {

/// Tells on standard error how several downloads come along: on a terminal by a bar that is drawn anew, elsewhere by a
/// line at the beginning and the end of each. May be called from several threads.
class Progress {
 public:
  /// @param level 0 to 4, as `-v` has it: from 3 on there is progress, from 2 on warnings.
  Progress(int level, bool isTerminal);
  /// Takes the bar away.
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// @param done Bytes that are there already. @param total 0: unknown.
  void begin(const std::string& name, std::uint64_t done, std::uint64_t total);
  void add(const std::string& name, std::uint64_t bytes);
  /// @param note "3.2 MB", or why there is nothing.
  void end(const std::string& name, const std::string& note);
  /// One that did not come: what becomes of it is told elsewhere.
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
