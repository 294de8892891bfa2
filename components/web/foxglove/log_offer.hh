#pragma once

#include <memory>
#include <string>

#include "web/foxglove/offer.hh"
#include "web/world/heard_log.hh"

namespace pongsim::web::foxglove {

/// The channel with the process's warnings and errors, "/foxglove/log", as foxglove.Log. For the server's thread.
class LogOffer {
 public:
  /// @param log Must outlive it.
  explicit LogOffer(HeardLog& log);

  const Offer& offer() const { return offer_; }

 private:
  Offer offer_;
};

}  // namespace pongsim::web::foxglove
