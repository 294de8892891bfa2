#pragma once

#include <chrono>
#include <cstdint>
#include <exception>
#include <functional>
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
  /// Whether a topic of that type can be written.
  using CanWrite = std::function<bool(std::string_view topic, std::string_view type)>;

  /// @param transport, writer, choice Must outlive it.
  /// @param canWrite Topics of which it takes no type are not listened to, but for those that are chosen by their
  /// names. Null: it takes all.
  Recording(Transport& transport, Writer& writer, const TopicChoice& choice, CanWrite canWrite = nullptr);

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
  bool isUseful(const TopicInfo& topic) const;
  void subscribe(const std::string& topic);
  void take(const std::string& topic, std::string_view type, std::span<const std::byte> bytes);

  Transport& transport_;
  Writer& writer_;
  const TopicChoice& choice_;
  CanWrite canWrite_;
  Clock::time_point nextLook_ = Clock::now();
  std::uint64_t messages_ = 0;
  std::set<std::string> heard_;
  /// Those that the identity may not subscribe to.
  std::set<std::string> refused_;
  /// Why nothing more is written.
  std::exception_ptr failure_;
  // last: what it calls is there to the end
  std::map<std::string, Subscription> subscriptions_;
};

}  // namespace pongsim::log
