#pragma once

#include <unistd.h>

#include <utility>

namespace pongsim::assets {

/// A file descriptor, closed on destruction.
class FileDescriptor {
 public:
  /// @param number Negative: none is open.
  explicit FileDescriptor(int number) : number_(number) {}
  ~FileDescriptor() { close(); }
  FileDescriptor(const FileDescriptor&) = delete;
  FileDescriptor& operator=(const FileDescriptor&) = delete;
  int number() const { return number_; }
  bool isOpen() const { return number_ >= 0; }
  /// @return Whether it was open and everything was written successfully.
  bool close() { return isOpen() && ::close(std::exchange(number_, -1)) == 0; }

 private:
  int number_;
};

}  // namespace pongsim::assets
