#pragma once

#include <filesystem>
#include <string>
#include <variant>

namespace pongsim::base {

/// A library opened at run time, which then stays loaded: for what only some runs need, or only some installations
/// have.
class SharedLibrary {
 public:
  /// @param name A file, or a name such as "libembree3.so.3", which is looked up like a linked library.
  /// @return The library, or the system's reason why it can't be opened.
  static std::variant<SharedLibrary, std::string> open(const std::string& name);

  /// @param package The Debian package that contains it.
  /// @throws std::runtime_error if it can't be opened, with the reason and what to install.
  static SharedLibrary require(const std::string& name, const std::string& package);

  /// @param Symbol Type of the function or variable, as declared in its header.
  /// @return Null if there is no symbol with this name.
  template <class Symbol>
  Symbol* find(const char* name) const {
    return reinterpret_cast<Symbol*>(address(name));
  }

  /// Points `symbol` to the symbol with this name.
  /// @throws std::runtime_error if there is none.
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

/// @return The file that contains this code: pongsim's library, or a program with the library built in. Empty if
/// unknown.
std::filesystem::path ownLibraryFile();

}  // namespace pongsim::base
