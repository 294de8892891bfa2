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
#include "pongsim/state/state_archive.hh"
#include "pongsim/types.hh"
#include "world/entities.hh"

namespace pongsim::sim {

class Access;

/// Box of models that become performers at run time, as in Fortress [m].
inline const Vector3 kPerformerSize(2, 2, 2);

/// The performers of a world, and which levels are loaded. As in Fortress, a level is loaded when the box of a
/// performer overlaps the level's box, and unloaded when no performer's box overlaps it, enlarged by the level's
/// buffer. Entities that are only in unloaded levels are set aside. Performers, entities in no level, and entities that
/// a joint connects to a loaded one always exist.
class Levels {
 public:
  /// @param access Must outlive this.
  explicit Levels(Access& access) : access_(access) {}

  /// Resets to the start, when all entities exist: no level is loaded, and the performers are those of the file.
  void start();

  /// Enables levels; by default everything is always loaded.
  void use() { areUsed_ = true; }
  bool areUsed() const { return areUsed_; }

  /// Loads and unloads levels with their entities. Call it at the start and before each step; it does not allocate
  /// unless something changes.
  void update();

  /// Makes a top-level model a performer.
  /// @param name The performer's name; empty: "perf_" and the model's name.
  /// @param size Side lengths of its box [m].
  Outcome<void> add(ModelId model, std::string name, const Vector3& size);
  /// Makes a model a performer once a model of that name is added.
  void addLater(std::string model) { awaited_.push_back(std::move(model)); }

  /// Overwrites `performers` with the existing performers.
  void listPerformers(std::vector<Performer>& performers) const;

  /// Saves or restores the loaded levels and the performers.
  void transfer(StateArchive& archive);

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
  /// An entity in levels.
  struct Member {
    Kind kind;
    std::uint64_t id;
    /// Indices of the levels that contain it.
    std::vector<std::size_t> zones;
  };
  struct PerformerOfLevels {
    std::uint64_t id;
    std::string name;
    /// The model or actor that performs; the other one is unset.
    ModelId model;
    const description::Actor* actor;
    Vector3 size;
    /// Whether the file defines it.
    bool isOfFile;
  };

  void readZones();
  void readPerformers();
  std::optional<Pose> poseOf(const PerformerOfLevels& performer) const;
  bool isPerforming(ModelId model) const;
  void addAwaited();
  bool switchZones();
  void rearrange();

  Access& access_;
  bool areUsed_ = false;
  std::vector<Zone> zones_;
  std::vector<Member> members_;
  std::vector<PerformerOfLevels> performers_;
  std::vector<std::string> awaited_;
  /// Whether a joint keeps an entity that would otherwise be set aside.
  bool isHeld_ = false;
  /// Whether membership in levels has yet to be evaluated.
  bool isNew_ = true;
  /// `Access::changes` at the last evaluation.
  std::uint64_t changes_ = 0;
  // Buffers, kept to avoid allocations in each step.
  std::vector<Eigen::AlignedBox3d> boxes_;
};

}  // namespace pongsim::sim
