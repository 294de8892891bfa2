"""Which part of a step takes how much of it: run by tools/bench profile.

Counts instructions and bytes by callgrind and its cache simulation, so that no neighbour on the machine changes them. Each
function counts for the part that it belongs to by its name; what the C library does counts for nobody ("rest").
"""

import collections
import os
import re
import shutil
import subprocess
import sys
import tempfile

PROGRAM = sys.argv[1]
COUNTS = [int(each) for each in sys.argv[2:]] or [1, 10, 50, 200, 1000]

# the first pattern that matches counts
PARTS = [
    ("LCP", r"physics::(Lcp|ReducedLcp|.*::(eliminate|substitute)[A-Z]|eliminate|substitute)"),
    ("rows", r"physics::(IslandRows|Articulation|JointTree|BodyCoupling|.*RowEnd|DirectSolver|IslandSolver|GaussSeidel|"
             r"SolverContact|Joint::(rows|motion|add|held|Row)|.*::(factorLink|climb|addSquare)|pointSurface|settlePoint|"
             r".*[fF]riction|.*chordVelocity|.*restitution|bounce)"),
    ("islands", r"Stepper::(gather|form|find)|physics::(Islands|Neighbourhoods|Rest|PieceLimits)"),
    ("broad phase", r"btDbvt|OverlappingPair|[aA]abb|SweptBoxes|BroadPhase|ContactFilter"),
    ("narrow phase", r"Algorithm|Manifold|Dispatcher|Shape|btGjk|btVoronoi|HullOnPlane|combine|ContactAdded|collide"
                     r"|forgetRolled|Surface"),
    ("integration", r"Stepper::|btTransformUtil|integrate|updateInertia|gyration|Gyration|Turn|addForces|"
                    r"btRigidBody|move|btMatrix|btQuaternion|sincos|btTransform|Joint::|Body::"),
    ("systems", r"diff_drive|DiffDrive|System|systems|Handle|handles|Transport|transport|google|msgs|Odometry"),
    ("bookkeeping", r"pongsim::|bt[A-Z]"),
]


def part_of(function):
    return next((name for name, pattern in PARTS if re.search(pattern, function)), "rest")


def counts(what, number, skipped, measured):
    """Instructions, reads and writes of each part, for one step."""

    def collect(steps):
        with tempfile.TemporaryDirectory() as folder:
            out = os.path.join(folder, "out")
            command = ["valgrind", "--tool=callgrind", f"--callgrind-out-file={out}", "--cache-sim=yes",
                       "--toggle-collect=pongsim::Simulation::step*", PROGRAM, what, str(number)]
            run = subprocess.run(command, input="\n".join(map(str, steps)), capture_output=True, text=True)
            if run.returncode != 0:
                sys.exit("profile: error: " + run.stderr.strip().splitlines()[-1])
            text = subprocess.run(["callgrind_annotate", "--threshold=100", "--show=Ir,Dr,Dw,D1mr,D1mw,DLmr", out],
                                  capture_output=True, text=True, check=True).stdout
        found = collections.defaultdict(lambda: [0] * 6)
        for line in text.splitlines():
            cells = re.match(r"^((?:\s*(?:[\d,]+|\.) (?:\([ .\d]+%\))?)+)\s+(\S.*)$", line)
            if cells is None or "PROGRAM TOTALS" in line:
                continue
            values = [int(each.replace(",", "")) for each in re.findall(r"([\d,]*\d)(?= \()", cells.group(1))]
            values += [0] * (6 - len(values))
            total = found[part_of(cells.group(2))]
            for i in range(6):
                total[i] += values[i]
        return found

    base, more = collect([skipped] if skipped else [1]), collect([skipped or 1, measured])
    return {part: [(b - base[part][i]) / measured for i, b in enumerate(more[part])] for part in more}


def show(title, what, number, skipped, measured):
    found = counts(what, number, skipped, measured)
    total = sum(values[0] for values in found.values())
    print(f"\n{title}: {total / number:.0f} instructions for each in a step")
    print(f"{'':14} {'instructions':>13} {'reads':>9} {'writes':>9} {'missed in L1':>13} {'in the last cache':>18}")
    for part, values in sorted(found.items(), key=lambda entry: -entry[1][0]):
        ir, reads, writes, missed_reads, missed_writes, missed_last = (value / number for value in values)
        print(f"{part:14} {100 * values[0] / total:12.1f}% {reads:9.0f} {writes:9.0f} "
              f"{64 * (missed_reads + missed_writes):11.0f} B {64 * missed_last:16.0f} B", flush=True)


if shutil.which("valgrind") is None:
    sys.exit("profile: error: valgrind is not installed")
print("for each robot or shape; a number that is missed in a cache costs a line of 64 bytes")
for each in COUNTS:
    show(f"{each} robots", "robots", each, 0, max(5, 100 // each))
if len(sys.argv) == 2:
    show("3,000 shapes that fall", "falling", 3000, 100, 5)
    show("3,000 shapes that stand", "shapes", 3000, 500, 5)
