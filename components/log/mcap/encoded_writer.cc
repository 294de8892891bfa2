#include "log/mcap/encoded_writer.hh"

#include <span>
#include <stdexcept>
#include <utility>
#include <variant>

#include "log/store/failure.hh"

namespace pongsim::log {

namespace {

McapOptions withProfile(McapOptions options, std::string_view profile) {
  options.profile = profile;
  return options;
}

std::string_view textOf(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

}  // namespace

EncodedWriter::EncodedWriter(const std::filesystem::path& path, McapOptions options,
                             std::unique_ptr<MessageEncoder> encoder, std::function<void(const std::string&)> warn)
    : encoder_(std::move(encoder)),
      warn_(std::move(warn)),
      writer_(path, withProfile(std::move(options), encoder_->profile()),
              // called from within `write`, for the topic being written
              [this](std::string_view, std::string_view) {
                return Definition{current_->schemaEncoding, current_->schema, current_->messageEncoding,
                                  current_->metadata};
              }) {}

bool EncodedWriter::takes(std::string_view topic, std::string_view type) {
  return topicFor(topic, type).encoder != nullptr;
}

EncodedWriter::Topic& EncodedWriter::topicFor(std::string_view topic, std::string_view type) {
  const auto found = topics_.find(std::tie(topic, type));
  if (found != topics_.end()) return found->second;
  Topic& known = topics_[std::tuple(std::string(topic), std::string(type))];
  auto opened = encoder_->openTopic(topic, type);
  if (auto* encoder = std::get_if<std::unique_ptr<TopicEncoder>>(&opened)) {
    known.encoder = std::move(*encoder);
  } else {
    leaveOut("'" + std::string(topic) + "'", std::get<std::string>(opened));
  }
  return known;
}

void EncodedWriter::leaveOut(const std::string& what, const std::string& why) {
  hasLeftOut_ = true;
  warn_(what + " is left out: " + why);
}

void EncodedWriter::write(const Record& record) {
  Topic& known = topicFor(record.topic, record.type);
  if (known.encoder == nullptr) return;
  try {
    known.encoder->encode(std::as_bytes(std::span(record.payload)),
                          [&](std::size_t place, std::span<const std::byte> payload) {
                            current_ = &known.encoder->topics()[place];
                            writer_.write({record.timeNs, current_->name, current_->type, textOf(payload)});
                            if (!written_.contains(current_->name)) written_.insert(current_->name);
                            ++messages_;
                          });
  } catch (const Failure&) {
    throw;
  } catch (const std::runtime_error& damage) {
    if (std::exchange(known.isDamageSaid, true)) return;
    leaveOut("a message of '" + std::string(record.topic) + "'", damage.what());
  }
}

}  // namespace pongsim::log
