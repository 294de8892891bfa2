#include "physics/dynamics_world.hh"

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "physics/contacts/manifold_state.hh"
#include "physics/solving/contact_solver.hh"
#include "physics/solving/group_solver.hh"

namespace pongsim::physics {

namespace {

std::unique_ptr<btConstraintSolver> makeSolver(const Settings& settings) {
  if (settings.solver == Solver::kSequentialImpulse) return std::make_unique<ContactSolver>();
  return std::make_unique<GroupSolver>(settings.mostDirectRows);
}

std::vector<std::unique_ptr<btConstraintSolver>> makeSolvers(const Settings& settings) {
  std::vector<std::unique_ptr<btConstraintSolver>> solvers;
  for (int i = 0; i < settings.threads; ++i) solvers.push_back(makeSolver(settings));
  return solvers;
}

}  // namespace

DynamicsWorld::DynamicsWorld(const Settings& settings, CollisionConfiguration& configuration, base::Arena& arena,
                             GroupWork& work)
    : workers_(settings.threads),
      dispatcher_(configuration, arena, workers_, rest_, settings.maxContacts),
      world_(dispatcher_, broadphase_, configuration, makeSolvers(settings), settings.maxContacts, workers_, rest_,
             work) {
  world_.setGravity(btVector3(0, 0, 0));

  btContactSolverInfo& info = world_.getSolverInfo();
  info.m_numIterations = settings.iterations;
  info.m_globalCfm = settings.softness;
  info.m_erp = settings.jointErrorReduction;
  info.m_erp2 = settings.contactErrorReduction;
  // friction resists in both directions of the surface, also where nothing slides yet
  info.m_solverMode |= SOLVER_USE_2_FRICTION_DIRECTIONS;
  // and in those that the surfaces ask for
  info.m_solverMode |= SOLVER_ENABLE_FRICTION_DIRECTION_CACHING;
  // depth is taken back without giving speed, however small it is
  info.m_splitImpulse = 1;
  info.m_splitImpulsePenetrationThreshold = BT_LARGE_FLOAT;
  // each point has its own
  info.m_restitutionVelocityThreshold = 0;
}

void DynamicsWorld::add(btRigidBody& body, std::uint64_t number) {
  // the broad phase gives each body the next number, and finds its pairs at once
  const int last = broadphase_.m_gid;
  broadphase_.m_gid = static_cast<int>(number) - 1;
  world_.addRigidBody(&body);
  broadphase_.m_gid = std::max(last, static_cast<int>(number));
}

void DynamicsWorld::moved(btRigidBody& body) {
  if (body.getBroadphaseProxy() == nullptr) return;
  world_.updateSingleAabb(&body);
  world_.forgetBox(body);
  broadphase_.getOverlappingPairCache()->cleanProxyFromPairs(body.getBroadphaseProxy(), &dispatcher_);
}

void DynamicsWorld::separate(btRigidBody& a, btRigidBody& b) {
  if (a.getBroadphaseProxy() == nullptr || b.getBroadphaseProxy() == nullptr) return;
  broadphase_.getOverlappingPairCache()->removeOverlappingPair(a.getBroadphaseProxy(), b.getBroadphaseProxy(),
                                                               &dispatcher_);
}

void DynamicsWorld::findPairsOf(btRigidBody& body) {
  btBroadphaseProxy* proxy = body.getBroadphaseProxy();
  if (proxy == nullptr) return;
  broadphase_.findPairs(*proxy);
}

void DynamicsWorld::transferContacts(StateArchive& archive) {
  // what algorithms and manifolds there must be follows from where the bodies are
  if (archive.isGiving()) findTouches();
  transferManifolds(archive, dispatcher_);
}

// whoever moves thousands of bodies asks once for each
void DynamicsWorld::forgetRest() {
  if (std::exchange(hasStepped_, false)) rest_.forget();
}

void DynamicsWorld::step(double dt) {
  if (std::exchange(lastStep_, dt) != dt) forgetRest();
  hasStepped_ = true;
  world_.step(dt);
}

}  // namespace pongsim::physics
