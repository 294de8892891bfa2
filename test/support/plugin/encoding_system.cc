#include "pongsim/messages/message_encoder.hh"
#include "pongsim/system.hh"

namespace {

class Idle : public pongsim::System {
  void configure(const pongsim::SystemContext&) override {}
};

/// Reverses the bytes of messages.
class Backwards final : public pongsim::TopicEncoder {
 public:
  explicit Backwards(const std::string& topic) : topics_{{topic, "Text", "backwards", "", "", {}}} {}
  const std::vector<pongsim::EncodedTopic>& topics() const override { return topics_; }
  void encode(std::span<const std::byte> message, const Take& take) override {
    std::vector<std::byte> bytes(message.rbegin(), message.rend());
    take(0, bytes);
  }

 private:
  std::vector<pongsim::EncodedTopic> topics_;
};

class Encoder final : public pongsim::MessageEncoder {
 public:
  explicit Encoder(std::string prefix) : prefix_(std::move(prefix)) {}
  std::string_view profile() const override { return "test"; }
  std::variant<std::unique_ptr<pongsim::TopicEncoder>, std::string> openTopic(std::string_view topic,
                                                                              std::string_view type) override {
    if (type != "Text") return "it is no text";
    return std::make_unique<Backwards>(prefix_ + std::string(topic));
  }

 private:
  std::string prefix_;
};

std::unique_ptr<pongsim::MessageEncoder> makeEncoder(const pongsim::EncoderSettings& settings,
                                                     pongsim::Diagnostics& diagnostics) {
  const auto prefix = settings.find("prefix");
  if (prefix != settings.end()) return std::make_unique<Encoder>(prefix->second);
  diagnostics.error({}, "no prefix");
  return nullptr;
}

}  // namespace

PONGSIM_EXPORT_SYSTEM(Idle, "test::Idle");
PONGSIM_EXPORT_ENCODER(makeEncoder);
