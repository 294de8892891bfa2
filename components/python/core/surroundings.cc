#include "core/surroundings.hh"

#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "core/errors.hh"
#include "core/memory.hh"
#include "core/values.hh"
#include "pongsim/contact.hh"
#include "pongsim/sensing/ray_scene.hh"

namespace pongsim::python {

namespace {

/// Numbers of a contact: position, normal, depth, force.
constexpr std::size_t kContactSize = 10;

/// @return The ids of both collisions of each contact point; its numbers; and the names of the collisions by their ids.
py::tuple contacts(Owner& owner) {
  World world = owner.life->use().world();
  std::vector<Contact> contacts;
  world.contacts(contacts);
  auto ids = std::make_shared<Memory>(contacts.size() * 2 * sizeof(std::uint64_t));
  auto numbers = std::make_shared<Memory>(contacts.size() * kContactSize * sizeof(double));
  auto* id = reinterpret_cast<std::uint64_t*>(ids->bytes.data());
  auto* to = reinterpret_cast<double*>(numbers->bytes.data());
  py::dict names;
  for (const Contact& contact : contacts) {
    for (const CollisionId collision : {contact.collision1, contact.collision2}) {
      *id++ = collision.value;
      const py::int_ key(collision.value);
      if (names.contains(key)) continue;
      const std::optional<Collision> found = world.collision(collision);
      names[key] = found ? py::object(py::str(found->scopedName())) : py::none();
    }
    to = std::copy_n(contact.position.data(), 3, to);
    to = std::copy_n(contact.normal.data(), 3, to);
    *to++ = contact.depth;
    to = std::copy_n(contact.force.data(), 3, to);
  }
  return py::make_tuple(ids, numbers, names);
}

std::vector<Ray> raysIn(const py::buffer_info& origins, const py::buffer_info& directions) {
  std::vector<Ray> rays(static_cast<std::size_t>(origins.size / 3));
  const auto* from = static_cast<const double*>(origins.ptr);
  const auto* along = static_cast<const double*>(directions.ptr);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const Vector3 origin(from + 3 * i), direction(along + 3 * i);
    const double length = direction.stableNorm();
    if (!origin.allFinite() || !std::isfinite(length) || length == 0) {
      throw py::value_error("ray " + std::to_string(i) + " must have a finite origin and a direction that is not zero");
    }
    rays[i] = {origin, direction / length};
  }
  return rays;
}

/// @param origins, directions Arrays of n x 3 doubles.
/// @return The distances, and for each ray the scoped name of the link that it hits, or None.
py::tuple castRays(Owner& owner, const py::buffer& origins, const py::buffer& directions, double farthest,
                   std::uint32_t mask) {
  Simulation& simulation = owner.life->use();
  const py::buffer_info from = origins.request(), along = directions.request();
  const std::vector<Ray> rays = raysIn(from, along);
  if (!(farthest > 0)) throw py::value_error("the longest distance must be above 0 m");
  if (!owner.life->rayScene) owner.life->rayScene = std::make_shared<RayScene>(simulation.world());
  std::vector<RayHit> hits(rays.size());
  Diagnostics diagnostics;
  owner.life->rayScene->cast(rays, farthest, mask, hits, diagnostics);
  warnOf(diagnostics.all());
  auto distances = std::make_shared<Memory>(rays.size() * sizeof(double));
  auto* to = reinterpret_cast<double*>(distances->bytes.data());
  py::list links;
  LinkId last;
  py::object name = py::none();
  for (const RayHit& hit : hits) {
    *to++ = hit.distance;
    // neighbouring rays mostly hit the same
    if (hit.link && *hit.link != last) {
      const std::optional<Link> link = simulation.world().link(*hit.link);
      name = link ? py::object(py::str(link->scopedName())) : py::none();
      last = *hit.link;
    }
    links.append(hit.link ? name : py::none());
  }
  return py::make_tuple(distances, links);
}

}  // namespace

void bindSurroundings(py::class_<Owner>& simulation) {
  simulation.def("_contacts", &contacts).def("_cast_rays", &castRays);
}

}  // namespace pongsim::python
