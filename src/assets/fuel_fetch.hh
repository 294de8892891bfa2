#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "assets/places.hh"
#include "assets/problem.hh"

namespace pongsim::assets {

/// Has a program download what is on Fuel servers and not in the local cache: pongsim-fuel, which is a package of its
/// own, so that nothing else brings what a network needs. What it says of its progress goes to standard error.
///
/// Each model is asked for once in the life of one of these.
class FuelFetch {
 public:
  /// @param program Empty: that of this installation.
  explicit FuelFetch(Places places, std::filesystem::path program = {});

  /// Downloads what of the addresses is not there, side by side. Those that are no Fuel addresses are passed over.
  void bring(const std::vector<std::string>& addresses);

  /// @return Why an address that is not in the cache could not be had: a sentence that begins with it, and advice.
  Problem whyNot(const std::string& address) const;

 private:
  void run(const std::vector<std::string>& addresses);

  Places places_;
  std::filesystem::path program_;
  /// By model and version.
  std::set<std::string> asked_;
  std::map<std::string, Problem> failed_;
};

}  // namespace pongsim::assets
