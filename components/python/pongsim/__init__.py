"""pongsim: worlds written for Gazebo Fortress, simulated in this process, without a display or ROS.

    import pongsim

    with pongsim.Simulation("worlds/pong_world.sdf", seed=7) as sim:
        sim.publish("/cmd_vel", {"linear": {"x": 0.5}})
        sim.run_until(2.0)
        print(sim.model("pong_bot").pose)
"""

from . import messages, worlds
from ._core import Collision, Diagnostic, Joint, Link, Model, StepInfo, Subscription, message_types, set_log_level
from ._core import version as __version__
from .errors import (
    Busy,
    Error,
    Gone,
    LoadError,
    NoReading,
    Refused,
    ServiceError,
    SystemFailed,
    WorldWarning,
)
from .sensor import Sensor
from .simulation import Simulation
from .state import Layout
from .system import System
from .values import Contacts, JointAxis, Noise, Pose, RayHit, RayHits
from .viewing import View
from .worlds import to_sdf

__all__ = [
    "Busy",
    "Collision",
    "Contacts",
    "Diagnostic",
    "Error",
    "Gone",
    "Joint",
    "JointAxis",
    "Layout",
    "Link",
    "LoadError",
    "Model",
    "NoReading",
    "Noise",
    "Pose",
    "RayHit",
    "RayHits",
    "Refused",
    "Sensor",
    "ServiceError",
    "Simulation",
    "StepInfo",
    "Subscription",
    "System",
    "SystemFailed",
    "View",
    "WorldWarning",
    "__version__",
    "message_types",
    "messages",
    "set_log_level",
    "to_sdf",
    "worlds",
]
