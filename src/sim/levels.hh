#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "description/actor.hh"
#include "description/levels.hh"
#include "pongsim/handles.hh"
#include "pongsim/state_archive.hh"
#include "pongsim/types.hh"
#include "world/entities.hh"

namespace pongsim::sim {

class Access;

/// Of a model that is made to perform while running, as in Fortress whatever the model [m].
inline const Vector3 kPerformerSize(2, 2, 2);

/// Which levels of a world are loaded, and who performs. A level is loaded when the box of a performer meets its own,
/// and unloaded when none meets that box grown by the buffer, as in Fortress; what is in no loaded level, but in one
/// that is not, is set aside. Performers, what is in no level, and what a joint holds to something that stays, is
/// always there.
class Levels {
 public:
  /// Back to the start, when all entities are there: no level is loaded, and who performs says the file.
  void start(Access& access);

  /// Whether levels are used; otherwise all is there, whoever is where.
  void use() { areUsed_ = true; }
  bool areUsed() const { return areUsed_; }

  /// Loads and unloads levels, and lets come and go what is in them. To be called at the start and before each step;
  /// it allocates nothing where nothing changes.
  void update(Access& access);

  /// Lets a model of the top level perform.
  /// @param name Of the performer; empty: "perf_" and the model's.
  /// @param size Full lengths of its box [m].
  /// @return Why not, or nothing.
  std::optional<std::string> add(Access& access, ModelId model, std::string name, const Vector3& size);
  /// Lets a model perform that is not there yet, from when it is.
  void addLater(std::string model) { awaited_.push_back(std::move(model)); }

  /// Replaces `performers` by those that are there.
  void listPerformers(const Access& access, std::vector<Performer>& performers) const;

  /// Which levels are loaded and who performs.
  void transfer(StateArchive& archive, const Access& access);

  /// The names of all levels, and whether each is loaded.
  std::vector<std::pair<std::string_view, bool>> list() const;

 private:
  struct Zone {
    const description::Level* level;
    Eigen::AlignedBox3d inner;
    Eigen::AlignedBox3d outer;
    bool isLoaded = false;
  };
  enum class Kind { kModel, kLight, kActor };
  /// Something that is in levels.
  struct Member {
    Kind kind;
    std::uint64_t id;
    /// Which.
    std::vector<std::size_t> zones;
  };
  struct Part {
    std::uint64_t id;
    std::string name;
    /// Either is what performs.
    ModelId model;
    const description::Actor* actor;
    Vector3 size;
    /// The file says so.
    bool isOfFile;
  };

  void readZones(const Access& access);
  void readPerformers(Access& access);
  std::optional<Pose> poseOf(const Access& access, const Part& performer) const;
  bool isPerforming(ModelId model) const;
  void addAwaited(Access& access);
  bool switchZones(const Access& access);
  void rearrange(Access& access);
  void bringBack(Access& access, const std::vector<std::uint64_t>& wanted) const;
  void setAside(Access& access, const std::vector<std::uint64_t>& wanted);

  bool areUsed_ = false;
  std::vector<Zone> zones_;
  std::vector<Member> members_;
  std::vector<Part> performers_;
  std::vector<std::string> awaited_;
  /// Something that would go is held by a joint.
  bool isHeld_ = false;
  /// Nobody has looked yet who is to be there.
  bool isNew_ = true;
  /// Those of `Access` that have been looked at.
  std::uint64_t changes_ = 0;
  // made once, used in each step
  std::vector<Eigen::AlignedBox3d> boxes_;
};

}  // namespace pongsim::sim
