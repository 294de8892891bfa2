#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <variant>

#include "pongsim/system.hh"

namespace pongsim::plugin {

/// A system library in memory. The systems made by it must not outlive it.
class Library {
 public:
  /// @return The library, or why it can't be used, as the end of a sentence: "it has no systems for pongsim".
  static std::variant<std::unique_ptr<Library>, std::string> open(const std::filesystem::path& file);
  ~Library();
  Library(const Library&) = delete;
  Library& operator=(const Library&) = delete;

  const std::filesystem::path& file() const { return file_; }
  std::span<const SystemEntry> systems() const { return table_->entries; }

 private:
  Library(std::filesystem::path file, void* handle, const SystemTable* table)
      : file_(std::move(file)), handle_(handle), table_(table) {}

  std::filesystem::path file_;
  void* handle_;
  const SystemTable* table_;
};

}  // namespace pongsim::plugin
