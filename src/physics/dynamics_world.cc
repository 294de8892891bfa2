#include "physics/dynamics_world.hh"

#include <BulletCollision/CollisionShapes/btCollisionShape.h>
#include <BulletDynamics/ConstraintSolver/btNNCGConstraintSolver.h>

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "physics/contact_solver.hh"
#include "physics/group_solver.hh"
#include "physics/manifold_state.hh"

namespace pongsim::physics {

namespace {

// a body that does more than that in one step rolls [rad], [m]
constexpr double kSmallTurn = 1e-4;
constexpr double kSmallShift = 1e-5;

std::unique_ptr<btConstraintSolver> makeSolver(const Settings& settings) {
  switch (settings.solver) {
    case Solver::kDirect:
      break;
    case Solver::kSequentialImpulse:
      return std::make_unique<ContactSolver>();
    case Solver::kNncg:
      return std::make_unique<btNNCGConstraintSolver>();
  }
  return std::make_unique<GroupSolver>(settings.mostDirectRows);
}

std::vector<std::unique_ptr<btConstraintSolver>> makeSolvers(const Settings& settings) {
  std::vector<std::unique_ptr<btConstraintSolver>> solvers;
  for (int i = 0; i < settings.threads; ++i) solvers.push_back(makeSolver(settings));
  return solvers;
}

}  // namespace

DynamicsWorld::DynamicsWorld(const Settings& settings, CollisionConfiguration& configuration, GroupWork& work)
    : workers_(settings.threads),
      dispatcher_(configuration, workers_, rest_),
      world_(dispatcher_, broadphase_, configuration, makeSolvers(settings), workers_, rest_, work) {
  world_.setGravity(btVector3(0, 0, 0));
  world_.setForceUpdateAllAabbs(false);

  btContactSolverInfo& info = world_.getSolverInfo();
  info.m_numIterations = settings.iterations;
  info.m_leastSquaresResidualThreshold = settings.residual;
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
  broadphase_.setAabbForceUpdate(proxy, proxy->m_aabbMin, proxy->m_aabbMax, &dispatcher_);
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
  forgetRolledContacts(dt);
  world_.stepSimulation(dt, 0);
}

// A rolling wheel's old points of contact lie behind it and would push it forward. The step finds those on a plane
// anew; a body that does not roll keeps its own, which give it a broader base.
void DynamicsWorld::forgetRolledContacts(double dt) {
  const auto isPlane = [](const btCollisionObject* object) {
    return object->getCollisionShape()->getShapeType() == STATIC_PLANE_PROXYTYPE;
  };
  for (int i = 0; i < dispatcher_.getNumManifolds(); ++i) {
    btPersistentManifold* manifold = dispatcher_.getManifoldByIndexInternal(i);
    if (manifold->getNumContacts() == 0) continue;
    const btCollisionObject* other = isPlane(manifold->getBody0())   ? manifold->getBody1()
                                     : isPlane(manifold->getBody1()) ? manifold->getBody0()
                                                                     : nullptr;
    if (other == nullptr) continue;
    const btRigidBody& body = *btRigidBody::upcast(other);
    const btVector3& normal = manifold->getContactPoint(0).m_normalWorldOnB;
    const double turn = body.getAngularVelocity().length() * dt;
    const double shift = body.getLinearVelocity().cross(normal).length() * dt;
    if (turn <= kSmallTurn || shift <= kSmallShift) continue;
    manifold->clearManifold();
    rest_.wake(body);
  }
}

}  // namespace pongsim::physics
