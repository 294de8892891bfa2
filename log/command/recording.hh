#pragma once

#include <chrono>
#include <cstdint>
#include <exception>
#include <map>
#include <set>
#include <span>
#include <string>
#include <string_view>

#include "log/command/topic_choice.hh"
#include "log/store/writer.hh"
#include "pongsim/node.hh"

namespace pongsim::log {

/// Records topics of other processes, by the clock of the wall, until it is told to end.
class Recording {
 public:
  /// @param transport, writer Must outlive it.
  Recording(Transport& transport, Writer& writer, const TopicChoice& choice);

  /// Takes what comes, for a while; looks for new topics now and then.
  /// @throws Failure where it can't be written.
  void goOn();

  std::uint64_t messages() const { return messages_; }
  /// Those that have been heard.
  std::size_t topics() const { return heard_.size(); }
  bool hasHeard(const std::string& topic) const { return heard_.contains(topic); }
  /// @return Messages that were lost, by topic, of those that lost some.
  std::map<std::string, std::uint64_t> lost() const;

 private:
  using Clock = std::chrono::steady_clock;

  void look();
  void subscribe(const std::string& topic);
  void take(const std::string& topic, std::string_view type, std::span<const std::byte> bytes);

  Transport& transport_;
  Writer& writer_;
  const TopicChoice& choice_;
  Clock::time_point nextLook_ = Clock::now();
  std::uint64_t messages_ = 0;
  std::set<std::string> heard_;
  /// Why nothing more is written.
  std::exception_ptr failure_;
  // last: what it calls is there to the end
  std::map<std::string, Subscription> subscriptions_;
};

}  // namespace pongsim::log
