#pragma once

#include <string>
#include <vector>

#include "security/documents.hh"

namespace pongsim::security {

/// The parsed arguments of an action.
struct Options {
  /// Empty: not given.
  std::string keystore;
  std::string name;
  /// 0: the default.
  int days = 0;
  Permissions permissions;
  std::string permissionsFile;
  bool asJson = false;
};

namespace actions {

/// Each function runs one action, or throws why it failed.
/// @return The exit code.
int init(const Options& options);
int add(const Options& options);
int list(const Options& options);

}  // namespace actions

}  // namespace pongsim::security
