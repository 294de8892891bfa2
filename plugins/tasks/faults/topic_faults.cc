#include "topic_faults.hh"

#include <google/protobuf/message.h>

#include <utility>

#include "message_noise.hh"

namespace pongsim::faults {

namespace {

std::span<const std::byte> bytesOf(const std::string& text) { return std::as_bytes(std::span(text)); }

std::size_t placeOf(bool isIncoming) { return isIncoming ? 1 : 0; }

}  // namespace

void TopicFaults::Passing::transfer(StateArchive& archive) {
  archive(type);
  archive(bytes);
  archive(isIncoming);
  archive(isCarried);
  archive.check(messageTypeName(type).has_value());
}

void TopicFaults::Delayed::transfer(StateArchive& archive) {
  archive(due);
  archive(passing);
}

TopicFaults::TopicFaults(const Node& node, std::string topic, const Logger& log)
    : topic_(std::move(topic)),
      log_(log),
      interception_(std::make_unique<Interception>(node, topic_, [this](const auto& crossing) { take(crossing); })) {}

void TopicFaults::add(const Fault& fault, const Random& random) {
  stages_.push_back({fault, random, {}, {}, {}, false});
}

void TopicFaults::take(const Interception::Crossing& crossing) {
  const auto* text = reinterpret_cast<const char*>(crossing.bytes.data());
  run(0,
      {std::string(crossing.type), std::string(text, crossing.bytes.size()), crossing.isIncoming, crossing.isCarried},
      crossing.pass);
}

Random& TopicFaults::randomOf(Stage& stage, bool isIncoming) {
  Draws& draws = stage.draws[placeOf(isIncoming)];
  if (draws.at != now_ || !draws.random) {
    draws = {now_, stage.stream.at(2 * static_cast<std::uint64_t>(now_.count()) + placeOf(isIncoming))};
  }
  return *draws.random;
}

bool TopicFaults::happens(Stage& stage, bool isIncoming) {
  if (!stage.fault.isActive(now_)) return false;
  return stage.fault.probability >= 1 || randomOf(stage, isIncoming).uniform() < stage.fault.probability;
}

TopicFaults::Passing TopicFaults::withNoise(Stage& stage, const Passing& passing) {
  const MessagePointer message = newMessage(passing.type);
  if (!message || !message->ParseFromString(passing.bytes)) return passing;
  const Fault& fault = stage.fault;
  if (!addNoise(*message, fault.field, fault.deviation, randomOf(stage, passing.isIncoming)) &&
      !std::exchange(stage.isFieldUnknown, true)) {
    log_.warning("topic '" + topic_ + "': " + passing.type + " has no number '" + fault.field + "': it gets no noise");
  }
  Passing changed = passing;
  message->SerializeToString(&changed.bytes);
  return changed;
}

/// Lets a message pass the faults from a stage on.
void TopicFaults::run(std::size_t number, const Passing& passing, const Pass& pass) {
  if (number == stages_.size()) return pass(bytesOf(passing.bytes));
  Stage& stage = stages_[number];
  std::optional<std::string>& last = stage.last[placeOf(passing.isIncoming)];
  const Kind kind = stage.fault.kind;
  const bool happensNow = happens(stage, passing.isIncoming);
  if (kind == Kind::kFreeze) {
    if (!happensNow || !last) last = passing.bytes;
    return run(number + 1, {passing.type, *last, passing.isIncoming, passing.isCarried}, pass);
  }
  if (!happensNow) return run(number + 1, passing, pass);
  if (kind == Kind::kDrop || kind == Kind::kSensor) return;
  if (kind == Kind::kDelay) {
    stage.delayed.push_back({now_ + stage.fault.delay, passing});
    return;
  }
  if (kind == Kind::kNoise) return run(number + 1, withNoise(stage, passing), pass);
  run(number + 1, passing, pass);
  run(number + 1, passing, pass);
}

void TopicFaults::release() {
  for (std::size_t number = 0; number < stages_.size(); ++number) {
    std::deque<Delayed>& delayed = stages_[number].delayed;
    while (!delayed.empty() && delayed.front().due <= now_) {
      const Passing passing = std::move(delayed.front().passing);
      delayed.pop_front();
      run(number + 1, passing, [&](std::span<const std::byte> bytes) {
        interception_->send(passing.type, bytes, passing.isIncoming, passing.isCarried);
      });
    }
  }
}

void TopicFaults::reset() {
  now_ = Time(0);
  for (Stage& stage : stages_) {
    stage.draws = {};
    stage.last = {};
    stage.delayed.clear();
  }
}

void TopicFaults::transfer(StateArchive& archive) {
  archive(now_);
  for (Stage& stage : stages_) {
    if (archive.isGiving()) stage.draws = {};
    for (std::optional<std::string>& last : stage.last) archive(last);
    archive(stage.delayed);
  }
}

}  // namespace pongsim::faults
