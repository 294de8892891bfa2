"""What happens to a world of the long run between one reset and the next.

A cycle is a generator: it asks for changes by `ask(service, request, type)`, which waits for the answer, and yields a number of
steps that are to be made before it goes on. The world pauses at each change, so that all cycles of a kind have the same bits.
"""

#: Number of steps in a cycle, and between two hashes.
STEPS = 1000
PERIOD = 250

BALL = """<sdf version='1.9'><model name='guest'><link name='link'>
  <collision name='c'><geometry><sphere><radius>0.15</radius></sphere></geometry></collision>
  <visual name='v'><geometry><sphere><radius>0.15</radius></sphere></geometry></visual></link></model></sdf>"""


def guest(name, x):
    """A request for a model of that name."""
    return {"sdf": BALL, "name": name, "pose": {"position": {"x": x, "y": 0.05, "z": 2.5}}}


def plain(ask):
    ask("control", {"pause": True, "reset": {"all": True}}, "WorldControl")
    yield STEPS


def seeded(ask):
    ask("control", {"pause": True, "reset": {"all": True}, "seed": 7}, "WorldControl")
    yield STEPS


def interrupted(ask):
    """Reset in the middle of a run; the bits are those of a plain cycle."""
    ask("control", {"pause": False}, "WorldControl")
    ask("control", {"pause": True, "reset": {"all": True}}, "WorldControl")
    yield STEPS


def spawned(ask):
    yield from begin(ask)
    ask("create", guest("alone", 0.1), "EntityFactory")
    ask("create_multiple", {"data": [guest("first", -0.3), guest("second", 0.3)]}, "EntityFactory_V")
    ask("create", {"clone_name": "box", "name": "twin", "pose": {"position": {"y": 1.0, "z": 2.0}}}, "EntityFactory")
    lamp = {"name": "lamp", "type": "POINT", "range": 10, "pose": {"position": {"z": 3}}}
    ask("create", {"light": lamp, "name": "lamp"}, "EntityFactory")
    yield STEPS - PERIOD


def removed(ask):
    yield from begin(ask)
    ask("create", guest("alone", 0.1), "EntityFactory")
    yield PERIOD
    ask("remove", {"name": "alone", "type": "MODEL"}, "Entity")
    ask("remove", {"name": "box", "type": "MODEL"}, "Entity")
    ask("remove", {"name": "sun", "type": "LIGHT"}, "Entity")
    yield STEPS - 2 * PERIOD


def changed(ask):
    yield from begin(ask)
    ask("set_physics", {"gravity": {"x": 0.5, "z": -3.7}, "max_step_size": 0.003}, "Physics")
    ask("light_config", {"name": "sun", "type": "DIRECTIONAL", "intensity": 0.4, "diffuse": {"r": 1.0, "a": 1.0}}, "Light")
    yield PERIOD
    ask("set_physics", {"gravity": {"z": 1.0}, "real_time_factor": 0.5}, "Physics")
    yield STEPS - 2 * PERIOD


def moved(ask):
    yield from begin(ask)
    ask("create", guest("alone", 0.1), "EntityFactory")
    poses = [{"name": "alone", "position": {"x": 0.2, "z": 1.5}}, {"name": "ground", "position": {"z": -0.1}}]
    ask("set_pose_vector", {"pose": poses}, "Pose_V")
    yield STEPS - PERIOD


def begin(ask):
    ask("control", {"pause": True, "reset": {"all": True}}, "WorldControl")
    yield PERIOD


#: In the order of their execution.
KINDS = [plain, spawned, removed, changed, moved, seeded, interrupted]
#: The kind whose hashes a kind must have, if not its own.
SAME_BITS = {"interrupted": "plain", "saved": "plain", "loaded": "plain"}
