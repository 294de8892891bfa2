#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <variant>

#include "pongsim/messages/message_encoder.hh"
#include "pongsim/system.hh"

namespace pongsim::plugin {

/// A loaded system library.
class Library {
 public:
  /// @return The library, or why it can't be used, as the end of a sentence: "it has no systems for pongsim".
  static std::variant<std::unique_ptr<Library>, std::string> open(const std::filesystem::path& file);

  const std::filesystem::path& file() const { return file_; }
  std::span<const SystemEntry> systems() const { return table_->entries; }
  /// @return Null if it has none.
  const EncoderTable* encoder() const { return encoder_; }

 private:
  Library(std::filesystem::path file, const SystemTable* table, const EncoderTable* encoder)
      : file_(std::move(file)), table_(table), encoder_(encoder) {}

  std::filesystem::path file_;
  const SystemTable* table_;
  const EncoderTable* encoder_;
};

}  // namespace pongsim::plugin
