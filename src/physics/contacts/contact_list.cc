#include "physics/contacts/contact_list.hh"

#include <BulletCollision/CollisionDispatch/btCollisionObject.h>
#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>

#include <algorithm>
#include <tuple>
#include <utility>

#include "physics/convert.hh"

namespace pongsim::physics {

namespace {

/// Bodies closer than this touch [m]. A wheel that bounces over an edge flies this high for a few steps; the gap is far
/// too small to see. Our solver stops a body exactly at the surface, while Fortress's lets it sink in for some steps;
/// with this threshold contacts last as long here.
constexpr double kTouching = 1e-4;

/// @param number Number of the collision in its link, as `combineSurfacesAsFortress` wrote it into the point.
CollisionId collisionOf(const btCollisionObject& object, int number, const world::Entities& entities) {
  const auto link = static_cast<world::Slot>(object.getUserIndex());
  return entities.collisions()[entities.links()[link].firstCollision + static_cast<std::size_t>(number)].id;
}

Contact contactAt(const btManifoldPoint& point, double dt) {
  Contact contact;
  contact.position = (fromBullet(point.m_positionWorldOnA) + fromBullet(point.m_positionWorldOnB)) / 2;
  contact.normal = fromBullet(point.m_normalWorldOnB);
  contact.depth = std::max(0.0, -point.getDistance());
  contact.force = (contact.normal * point.m_appliedImpulse +
                   fromBullet(point.m_lateralFrictionDir1) * point.m_appliedImpulseLateral1 +
                   fromBullet(point.m_lateralFrictionDir2) * point.m_appliedImpulseLateral2) /
                  dt;
  return contact;
}

bool comesFirst(const Contact& a, const Contact& b) {
  const auto key = [](const Contact& contact) {
    const Vector3& p = contact.position;
    return std::tuple(contact.collision1, contact.collision2, p.x(), p.y(), p.z());
  };
  return key(a) < key(b);
}

}  // namespace

void listContacts(btDispatcher& dispatcher, const world::Entities& entities, double dt,
                  std::vector<Contact>& contacts) {
  contacts.clear();
  for (int i = 0; i < dispatcher.getNumManifolds(); ++i) {
    const btPersistentManifold& manifold = *dispatcher.getManifoldByIndexInternal(i);
    for (int j = 0; j < manifold.getNumContacts(); ++j) {
      const btManifoldPoint& point = manifold.getContactPoint(j);
      // Bullet also keeps points that are only near
      if (point.getDistance() > kTouching && point.m_appliedImpulse <= 0) continue;
      Contact contact = contactAt(point, dt);
      contact.collision1 = collisionOf(*manifold.getBody0(), point.m_index0, entities);
      contact.collision2 = collisionOf(*manifold.getBody1(), point.m_index1, entities);
      if (contact.collision2 < contact.collision1) {
        std::swap(contact.collision1, contact.collision2);
        contact.normal = -contact.normal;
        contact.force = -contact.force;
      }
      contacts.push_back(contact);
    }
  }
  std::sort(contacts.begin(), contacts.end(), comesFirst);
}

}  // namespace pongsim::physics
