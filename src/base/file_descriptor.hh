#pragma once

#include <unistd.h>

#include <utility>

namespace pongsim::base {

/// A file descriptor, closed on destruction.
class FileDescriptor {
 public:
  /// @param number Negative: none is open.
  explicit FileDescriptor(int number) : number_(number) {}
  ~FileDescriptor() { close(); }
  FileDescriptor(FileDescriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  FileDescriptor& operator=(FileDescriptor&&) = delete;
  int number() const { return number_; }
  bool isOpen() const { return number_ >= 0; }
  /// @return Whether it was open and everything was written successfully.
  bool close() { return isOpen() && ::close(std::exchange(number_, -1)) == 0; }

 private:
  int number_;
};

}  // namespace pongsim::base
