#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "fuel/http.hh"
#include "fuel/settings.hh"
#include "pongsim/files/fuel_address.hh"

namespace pongsim::fuel {

/// What a server says of a model or world.
struct Details {
  std::string owner;
  std::string name;
  /// The newest; 0: it does not say.
  int version = 0;
  std::uint64_t bytes = 0;
  bool isPrivate = false;
  std::string description, license, created, updated;
  std::vector<std::string> tags;
};

/// A set of models and worlds: "https://fuel.gazebosim.org/1.0/OWNER/collections/NAME".
struct Collection {
  FuelAddress server;
  std::string owner;
  std::string name;
};
std::optional<Collection> parseCollection(const std::string& address);

/// Speaks version 1.0 of the interface of Fuel servers, https://app.gazebosim.org/docs.
class FuelServer {
 public:
  /// @param headers "Name: value", sent with all requests.
  FuelServer(Server server, std::vector<std::string> headers);

  /// @throws Failure, PassingFailure, Interrupted; likewise below.
  Details details(const FuelAddress& address);

  /// @param owner Empty: all.
  /// @return All models or worlds, page by page.
  std::vector<Details> list(bool worlds, const std::string& owner);
  std::vector<Details> list(bool worlds, const Collection& collection);

  /// Takes a model or world off the server.
  void remove(const FuelAddress& address);

  /// Asks for a zip file, following a link where the server answers with one.
  /// @param version Nothing: the newest.
  /// @param from Where to go on, with the `validator` of the bytes that are there; 0: at the beginning.
  /// @param isLinked Whether those came from where a link led to.
  /// @param begin Called with the version, 0 if it is not said, whether a link led here, and the answer, whose status
  /// is 206 where it goes on.
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
