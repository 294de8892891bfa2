#pragma once

#include <stdlib.h>

#include <optional>
#include <string>

namespace pongsim::test {

/// Sets a variable of this process's environment; the destructor restores the value before.
class EnvironmentVariable {
 public:
  explicit EnvironmentVariable(const char* name) : name_(name) {
    if (const char* const value = ::getenv(name)) before_ = value;
  }
  EnvironmentVariable(const char* name, const std::string& value) : EnvironmentVariable(name) { set(value); }
  ~EnvironmentVariable() { before_ ? set(*before_) : unset(); }
  EnvironmentVariable(const EnvironmentVariable&) = delete;
  EnvironmentVariable& operator=(const EnvironmentVariable&) = delete;

  void set(const std::string& value) { ::setenv(name_, value.c_str(), 1); }
  void unset() { ::unsetenv(name_); }

 private:
  const char* name_;
  std::optional<std::string> before_;
};

}  // namespace pongsim::test
