"""What mechanics say, for the cases of cases.py: formulas, and integrals of motions with one degree of freedom."""

import math

import numpy

G = 9.8


def rocking_period(a, c, mass, moment, angle):
    """Of an ellipse with level semi-axis `a` and upright `c` that rolls to and fro on level ground from `angle` [s].

    With h(q) the height of its middle, 1/2 (I + m (h^2 + h'^2)) q'^2 + m g h is kept; integrated over u, q = A sin(u).
    """

    def height(q):
        return math.sqrt((a * math.sin(q)) ** 2 + (c * math.cos(q)) ** 2)

    def inertia(q):
        slope = (a * a - c * c) * math.sin(q) * math.cos(q) / height(q)
        return moment + mass * (height(q) ** 2 + slope**2)

    count, total = 20000, 0.0
    for i in range(count):
        u = (i + 0.5) / count * math.pi / 2
        q = angle * math.sin(u)
        left = mass * G * (height(angle) - height(q))
        total += math.sqrt(inertia(q) / (2 * left)) * angle * math.cos(u) * (math.pi / 2 / count)
    return 4 * total


def rolling_cylinder(radius, length, mass, moments, tilt, circle):
    """The steady roll of a cylinder on its lower edge, its axis `tilt` from upright, its middle on a circle.

    Of the balance of angular momentum, dL/dt = W z x L = r x F, without slip; for a thin coin and no circle it is
    W^2 = 4 g / (R sin tilt). See L. D. Landau, E. M. Lifshitz, Mechanics, paragraphs 35 and 38.
    Returns the rate of going round, the spin about the axis, and the height of the middle.
    """
    across, along = moments
    sine, cosine = math.sin(tilt), math.cos(tilt)
    arm = radius * cosine - length / 2 * sine
    height = radius * sine + length / 2 * cosine
    spin = -(circle + arm) / radius
    left = -across * sine * cosine + along * sine * (cosine + spin) - mass * circle * height
    rate = math.sqrt(-mass * G * arm / left)
    return rate, rate * spin, height


def domino_times(count, height, width, pitch, mass, angle):
    """When each of a row of dominoes begins to fall, the first one leaning by `angle`; without friction or bounce [s].

    All that have been hit lean on each other, with one degree of freedom; what a hit gives follows from the momentum
    along that. After J. M. J. van Leeuwen, The domino effect, American Journal of Physics 78, 2010.
    """
    inertia = mass * (height**2 + width**2) / 3
    limit = math.asin((pitch - width) / height)

    def behind(q):
        """Angle of the domino that leans on one at q, and its derivative: h sin(p - q) = pitch cos q - width."""
        bent = math.asin((pitch * math.cos(q) - width) / height)
        return q + bent, 1 - pitch * math.sin(q) / (height * math.cos(bent))

    def train(q, hit):
        """Inertia and potential energy, for the angle of the foremost."""
        moment, energy, slope = 0.0, 0.0, 1.0
        for place in range(hit):
            moment += inertia * slope**2
            energy += mass * G / 2 * (height * math.cos(q) + width * math.sin(q))
            if place + 1 < hit:
                q, d = behind(q)
                slope *= d
        return moment, energy

    times, now, speed, q = [0.0], 0.0, 0.0, angle
    for hit in range(1, count):
        total = train(q, hit)
        kept = total[0] * speed**2 / 2 + total[1]
        pieces = 400
        # the motion starts from rest, where the integrand is singular: quadratically spaced points keep the sum finite
        places = [q + (limit - q) * (i / pieces) ** 2 for i in range(pieces + 1)]
        for a, b in zip(places, places[1:]):
            moment, energy = train((a + b) / 2, hit)
            now += (b - a) / math.sqrt(2 * (kept - energy) / moment)
        moment, energy = train(limit, hit)
        speed = math.sqrt(2 * (kept - energy) / moment)
        times.append(now)
        after, _ = train(0.0, hit + 1)
        speed *= behind(0.0)[1] * moment / after
        q = 0.0
    return times


def crank_way(crank, rod, angle):
    """How far a slider is from the middle of the crank's circle."""
    return crank * math.cos(angle) + math.sqrt(rod**2 - (crank * math.sin(angle)) ** 2)


def wheelie_way(seconds, speed, coupled=True):
    """How far the tutorial's robot goes while its wheels spin and its caster is in the air [m]; friction is 1.

    In the plane: the axle's place, and the angle by which the nose is up. Where not coupled, the normal force is that
    of a ground without friction.
    """
    radius, wheels, wheel_inertia = 0.4, 3.0, 0.25
    parts = [(1.14395, 0.5, 0.0), (1.0, 1.3, -0.2)]
    total = wheels + sum(mass for mass, _, _ in parts)

    def arms(angle):
        c, s = math.cos(angle), math.sin(angle)
        return [(mass, x * c - z * s, x * s + z * c) for mass, x, z in parts]

    def sums(angle):
        found = arms(angle)
        return (
            0.416519 + wheel_inertia + sum(m * (x * x + z * z) for m, x, z in found),
            sum(m * x for m, x, _ in found),
            sum(m * z for m, _, z in found),
        )

    def solve(moment, across, up, right):
        """Unknown: motion of the axle, of the nose, normal force, and that without friction."""
        rows = numpy.array([[total, -up, -1.0], [-up, moment, -radius], [0.0, across, -1.0]])
        if coupled:
            return numpy.linalg.solve(rows, right)[:2]
        without = rows.copy()
        without[:2, 2] = 0
        normal = numpy.linalg.solve(without, right)[2]
        return numpy.linalg.solve(rows[:2, :2], right[:2] - rows[:2, 2] * normal)

    # the wheels reach their speed at once
    moment, across, up = sums(0.0)
    velocity, turning = solve(moment, across, up, numpy.array([0.0, wheel_inertia * speed / radius, 0.0]))
    way, angle, step = 0.0, 0.0, 1e-5
    for _ in range(round(seconds / step)):
        moment, across, up = sums(angle)
        right = numpy.array([across * turning**2, -G * across, up * turning**2 - total * G])
        forward, rising = solve(moment, across, up, right)
        velocity += forward * step
        turning += rising * step
        way += velocity * step
        angle += turning * step
    return way
