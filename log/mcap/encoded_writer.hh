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

/// Writes MCAP in another encoding than protobuf's, in which records come. What has nothing in that encoding is left
/// out.
class EncodedWriter final : public Writer {
 public:
  /// @param options Their profile is the encoder's.
  /// @param warn Told what is left out and why, once for each topic.
  /// @throws Failure where the file can't be made.
  EncodedWriter(const std::filesystem::path& path, McapOptions options, std::unique_ptr<MessageEncoder> encoder,
                std::function<void(const std::string&)> warn);

  /// @return Whether the topic is there in the other encoding; of one that is not is warned.
  bool takes(std::string_view topic, std::string_view type);

  void write(const Record& record) override;
  void close() override { writer_.close(); }

  /// Of the other encoding, written so far.
  std::uint64_t messages() const { return messages_; }
  std::size_t topics() const { return written_.size(); }
  /// @return Whether there was something that is not in the file.
  bool hasLeftOut() const { return hasLeftOut_; }

 private:
  /// Of one topic and type.
  struct Entry {
    /// Null where it is left out.
    std::unique_ptr<TopicEncoder> encoder;
    bool isDamageSaid = false;
  };

  Entry& entryFor(std::string_view topic, std::string_view type);
  void leaveOut(const std::string& what, const std::string& why);

  std::unique_ptr<MessageEncoder> encoder_;
  std::function<void(const std::string&)> warn_;
  std::map<std::tuple<std::string, std::string>, Entry, std::less<>> entries_;
  /// What is being written.
  const EncodedTopic* current_ = nullptr;
  std::set<std::string, std::less<>> written_;
  std::uint64_t messages_ = 0;
  bool hasLeftOut_ = false;
  McapWriter writer_;
};

}  // namespace pongsim::log
