#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "assets/places.hh"
#include "assets/problem.hh"

namespace pongsim::assets {

/// Downloads from Fuel servers what is missing in the local cache, by running pongsim-fuel. That program is a separate
/// package, so that nothing else depends on network libraries. It reports progress on standard error.
///
/// An object of this class requests each model only once.
class FuelFetch {
 public:
  /// @param program Empty: that of this installation.
  explicit FuelFetch(Places places, std::filesystem::path program = {});

  /// Downloads those addresses that are missing, in parallel. Ignores addresses that are not on Fuel.
  void bring(const std::vector<std::string>& addresses);

  /// @return Why an address that is not in the cache could not be downloaded: a sentence that starts with it, and
  /// advice.
  Problem whyNot(const std::string& address) const;

 private:
  void run(const std::vector<std::string>& addresses);

  Places places_;
  std::filesystem::path program_;
  /// Models and versions requested so far.
  std::set<std::string> requested_;
  std::map<std::string, Problem> failed_;
};

}  // namespace pongsim::assets
