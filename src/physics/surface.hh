#pragma once

namespace pongsim::physics {

/// Makes Bullet ask us how two surfaces act on each other. Bullet keeps this in one place for the whole process; any
/// number of engines may call it, at any time.
///
/// As Fortress's default engine DART does: the smaller of the two friction coefficients, the product of the two
/// coefficients of restitution.
void combineSurfacesAsFortress();

}  // namespace pongsim::physics
