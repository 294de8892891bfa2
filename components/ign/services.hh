#pragma once

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <ignition/transport/Node.hh>

#include "ign/offered_service.hh"

namespace pongsim::ign {

/// The services that this process offers on ign-transport. For the courier's thread.
class Services {
 public:
  Services();

  void advertise(const std::shared_ptr<OfferedService>& service);
  void unadvertise(const OfferedService& service);

 private:
  ignition::transport::Node node_;
  std::string nodeUuid_;
};

}  // namespace pongsim::ign
