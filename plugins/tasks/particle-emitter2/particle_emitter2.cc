// Fortress has this name for the system in a world, which is the same one.

#include "particle_emitter.hh"

PONGSIM_EXPORT_SYSTEM(pongsim::ParticleEmitter, "ignition::gazebo::systems::ParticleEmitter2",
                      "gz::sim::systems::ParticleEmitter2");
