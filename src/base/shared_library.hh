#pragma once

#include <filesystem>
#include <string>
#include <variant>

namespace pongsim::base {

/// A library that is opened while running, and stays in memory: of what some runs need only, or some installations
/// have.
class SharedLibrary {
 public:
  /// @param name A file, or a name such as "libembree3.so.3" that is looked for as those of linked libraries are.
  /// @return The library, or why it can't be opened, as the system says it.
  static std::variant<SharedLibrary, std::string> open(const std::string& name);

  /// @param package Debian's, which holds it.
  /// @throws std::runtime_error where it can't be opened, saying why and what to install.
  static SharedLibrary require(const std::string& name, const std::string& package);

  /// @param Symbol Of the function or the variable, as its header declares it.
  /// @return Null where there is none of that name.
  template <class Symbol>
  Symbol* find(const char* name) const {
    return reinterpret_cast<Symbol*>(address(name));
  }

  /// Lets `symbol` point to what is of that name.
  /// @throws std::runtime_error where there is none.
  template <class Symbol>
  void bind(Symbol*& symbol, const char* name) const {
    symbol = reinterpret_cast<Symbol*>(requiredAddress(name));
  }

 private:
  explicit SharedLibrary(void* handle) : handle_(handle) {}
  void* address(const char* name) const;
  void* requiredAddress(const char* name) const;

  void* handle_;
};

/// @return The file that this code came from: pongsim's library, or a program that holds the same. Empty if unknown.
std::filesystem::path ownLibraryFile();

}  // namespace pongsim::base
