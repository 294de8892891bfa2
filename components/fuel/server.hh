#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "fuel/details.hh"
#include "fuel/http.hh"
#include "fuel/settings.hh"
#include "pongsim/files/fuel_address.hh"

namespace pongsim::fuel {

/// A list of models and worlds: "https://fuel.gazebosim.org/1.0/OWNER/collections/NAME".
struct Collection {
  FuelAddress server;
  std::string owner;
  std::string name;
};
std::optional<Collection> parseCollection(const std::string& address);

/// A client for version 1.0 of the REST API of Fuel servers, https://app.gazebosim.org/docs.
class FuelServer {
 public:
  /// @param headers "Name: value", sent with all requests.
  FuelServer(Server server, std::vector<std::string> headers);

  /// @throws Failure, PassingFailure, Interrupted; the same below.
  Details details(const FuelAddress& address);

  /// @param owner Empty: all.
  /// @return All models or worlds, from all pages.
  std::vector<Details> list(bool worlds, const std::string& owner);
  std::vector<Details> list(bool worlds, const Collection& collection);

  /// Deletes a model or world from the server.
  void remove(const FuelAddress& address);

  /// Requests a zip file. If the response is a link instead, requests the file at that address.
  /// @param version Unset: the newest.
  /// @param from Offset at which to continue, for which `validator` identifies the existing bytes; 0: from the start.
  /// @param isLinked Whether the existing bytes came from a link.
  /// @param begin Called with the version (0 if unknown), whether a link was followed, and the response, whose status
  /// is 206 if the server continues at `from`.
  using Begin = std::function<void(int version, bool isLinked, const Answer& answer)>;
  void zip(const FuelAddress& address, std::uint64_t from, const std::string& validator, bool isLinked,
           const Begin& begin, const Http::Take& take);

 private:
  Request requestFor(const std::string& path) const;
  std::vector<Details> pages(const std::string& path);

  Server server_;
  std::vector<std::string> headers_;
  Http http_;
};

}  // namespace pongsim::fuel
