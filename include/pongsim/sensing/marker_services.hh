#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "pongsim/declaration.hh"
#include "pongsim/export.hh"
#include "pongsim/handles.hh"
#include "pongsim/log.hh"
#include "pongsim/node.hh"
#include "pongsim/types.hh"

namespace pongsim {

/// For whom markers are: for sensors, or for people who look at the world. A marker with the visibility ALL is seen by
/// both.
enum class MarkerViewers { kSensors, kPeople };

/// Services by which programs add shapes to what is seen (`ignition.msgs.Marker`): `/sensors/marker`,
/// `/sensors/marker_array` and `/sensors/marker/list`; for people `/marker`, `/marker_array` and `/marker/list`.
/// Nothing collides with markers, and they are no part of the state; a reset drops those that have a lifetime. Must not
/// outlive the world.
class PONGSIM_API MarkerServices {
 public:
  /// @param log For the reasons of what is refused: a caller of `/marker` gets no answer.
  MarkerServices(const World& world, Node& node, const Logger& log, MarkerViewers viewers);
  ~MarkerServices();
  MarkerServices(MarkerServices&&) noexcept;
  MarkerServices& operator=(MarkerServices&&) noexcept;

  /// Declares the services.
  static void declare(Declaration& declaration, MarkerViewers viewers);

  /// Call it after each step, and with zero when the world was reset: drops markers whose time is over.
  void update(Time now);

 private:
  struct Content;
  std::unique_ptr<Content> content_;
};

}  // namespace pongsim
