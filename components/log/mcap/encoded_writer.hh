#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <tuple>

#include "log/mcap/mcap_writer.hh"
#include "log/store/writer.hh"
#include "pongsim/messages/message_encoder.hh"

namespace pongsim::log {

/// Writes MCAP in an encoding other than the records' protobuf. Messages without an equivalent in that encoding are
/// left out.
class EncodedWriter final : public Writer {
 public:
  /// @param options The profile is set by the encoder.
  /// @param warn Called once for each topic that is left out, with the reason.
  /// @throws Failure if the file can't be created.
  EncodedWriter(const std::filesystem::path& path, McapOptions options, std::unique_ptr<MessageEncoder> encoder,
                std::function<void(const std::string&)> warn);

  /// @return Whether the topic exists in the other encoding; warns if not.
  bool takes(std::string_view topic, std::string_view type);

  void write(const Record& record) override;
  void close() override { writer_.close(); }

  /// Number of messages written in the other encoding.
  std::uint64_t messages() const { return messages_; }
  std::size_t topics() const { return written_.size(); }
  /// @return Whether anything was left out.
  bool hasLeftOut() const { return hasLeftOut_; }

 private:
  /// State of one topic and type.
  struct Topic {
    /// Null if it is left out.
    std::unique_ptr<TopicEncoder> encoder;
    bool isDamageSaid = false;
  };

  Topic& topicFor(std::string_view topic, std::string_view type);
  void leaveOut(const std::string& what, const std::string& why);

  std::unique_ptr<MessageEncoder> encoder_;
  std::function<void(const std::string&)> warn_;
  std::map<std::tuple<std::string, std::string>, Topic, std::less<>> topics_;
  /// The topic being written.
  const EncodedTopic* current_ = nullptr;
  std::set<std::string, std::less<>> written_;
  std::uint64_t messages_ = 0;
  bool hasLeftOut_ = false;
  McapWriter writer_;
};

}  // namespace pongsim::log
