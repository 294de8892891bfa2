#pragma once

#include <string>
#include <vector>

#include "security/documents.hh"

namespace pongsim::security {

/// What the words behind an action say.
struct Options {
  /// Empty: nobody has said where.
  std::string keystore;
  std::string name;
  /// 0: as long as it is usual.
  int days = 0;
  Permissions permissions;
  std::string permissionsFile;
  bool asJson = false;
};

namespace actions {

/// Each does its work, or throws why it can't.
/// @return The exit code.
int init(const Options& options);
int add(const Options& options);
int list(const Options& options);

}  // namespace actions

}  // namespace pongsim::security
