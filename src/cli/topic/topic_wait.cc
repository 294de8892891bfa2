#include <string>
#include <utility>

#include "cli/topic/topic_command.hh"
#include "shared/program/console.hh"

namespace pongsim::cli {

namespace {

class WaitTask final : public TopicTask {
 public:
  WaitTask(std::string topic, const std::optional<FieldCondition>& condition)
      : topic_(std::move(topic)), condition_(condition) {}

  std::optional<int> begin(const std::string& type) override {
    if (!condition_) return std::nullopt;
    MessageError error;
    check_ = FieldCheck::make(*condition_, type, error);
    return check_ ? std::nullopt : std::optional(fail(error.message, error.hint));
  }

  std::optional<int> take(const Message& message) override {
    ++messages_;
    return !check_ || check_->isMetBy(message) ? std::optional(kDone) : std::nullopt;
  }

  int end(bool isByTime) override {
    // a signal, or a closed output: there is nobody to tell
    if (!isByTime) return kFailed;
    if (messages_ == 0) return fail("no message on " + topic_ + " in time");
    return fail("none of " + std::to_string(messages_) + " messages on " + topic_ + " met the condition in time");
  }

 private:
  const std::string topic_;
  const std::optional<FieldCondition>& condition_;
  std::optional<FieldCheck> check_;
  std::uint64_t messages_ = 0;
};

}  // namespace

int waitForMessage(const ReadOptions& options, const std::optional<FieldCondition>& condition) {
  TopicReader reader(options);
  WaitTask task(options.topic, condition);
  return reader.run(task);
}

}  // namespace pongsim::cli
