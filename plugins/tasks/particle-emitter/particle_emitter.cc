#include "particle_emitter.hh"

PONGSIM_EXPORT_SYSTEM(pongsim::ParticleEmitter, "ignition::gazebo::systems::ParticleEmitter",
                      "gz::sim::systems::ParticleEmitter");
