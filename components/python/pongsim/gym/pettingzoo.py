"""Several agents in one world, as PettingZoo's parallel environments have them.

    env = ParallelEnv("chase.sdf", {"cat": Agent(...), "mouse": Agent(...)}, time_limit=20.0)
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Mapping, Sequence, Union

import numpy as np
from gymnasium import error, spaces
from gymnasium.utils import seeding
from numpy.typing import NDArray

try:
    from pettingzoo import ParallelEnv as _ParallelEnv  # type: ignore[import-untyped,import-not-found,unused-ignore]
except ImportError as missing:
    raise ImportError(
        "pongsim.gym.pettingzoo needs PettingZoo, which is not installed: pip install pettingzoo"
    ) from missing

from ..errors import Gone
from ..simulation import Simulation
from .env import check_render_mode
from .parts import Image, Reading, Steering
from .task import NUMBERS, TRUTHS, Judgement, Moment, Task, judge
from .worlds import Worlds


@dataclass(frozen=True, kw_only=True)
class Agent:
    """What one agent does, observes and gets. Its functions receive the `Moment` of the world, in which the readings of
    all agents are: "cat.pose" is the reading "pose" of the agent "cat"."""

    #: Steerings, whose numbers are concatenated.
    action: Sequence[Steering]
    #: Readings, whose numbers are concatenated, and images, beside which they are in a dict, as in a `Task`.
    observation: Mapping[str, Union[Reading, Image]]
    #: The reward of a step.
    reward: Judgement
    #: Whether the agent is done, for example caught. None: never.
    terminated: Judgement | None = None


class ParallelEnv(_ParallelEnv):  # type: ignore[misc]  # it has no types
    """Several agents that act in one world at the same time.

    An agent that has terminated leaves `agents`, and acts no more: its actuators get the numbers nearest to 0. The time
    limit, and the `truncated` of the task, end the episode for all.
    """

    metadata: dict[str, Any] = {"name": "pongsim", "render_modes": ["rgb_array"]}

    def __init__(
        self, world: Any, agents: Mapping[str, Agent], *, render_mode: str | None = None, **task: Any
    ) -> None:
        """Loads the world.

        world: an SDF or URDF file, or its text.
        agents: by their names.
        task: other fields of a `Task`: `start`, `step_time`, `settle_time`, `time_limit`, `truncated`, `extra`,
            `randomise`, `noise`, `camera`.
        Raises the same exceptions as `Env`.
        """
        check_render_mode(render_mode)
        if not agents:
            raise ValueError("an environment needs an agent")
        self._agents = dict(agents)
        self.task = Task(
            world=world,
            action=[each for agent in agents.values() for each in agent.action],
            observation={f"{name}.{key}": each for name, agent in agents.items() for key, each in agent.observation.items()},
            reward=lambda now: 0.0,
            dictionary=True,
            **task,
        )
        self._worlds = Worlds(self.task, 1, 1)
        self.render_mode = render_mode
        self.metadata = {**self.metadata, "render_fps": max(1, round(1 / self.task.step_time))}
        self.possible_agents = list(agents)
        self.agents: list[str] = []
        self._random: np.random.Generator | None = None
        self._places: dict[str, slice] = {}
        self.action_spaces: dict[str, spaces.Box] = {}
        self.observation_spaces: dict[str, Any] = {}
        sizes = iter(self._worlds.action_sizes)
        both = self._worlds.action_space
        assert isinstance(both, spaces.Box)
        end = 0
        for name, agent in agents.items():
            begin, end = end, end + sum(next(sizes) for _ in agent.action)
            self._places[name] = slice(begin, end)
            self.action_spaces[name] = spaces.Box(both.low[begin:end], both.high[begin:end], dtype=np.float32)
            self.observation_spaces[name] = self._space(name)
        # what agents do that are not there
        self._rest = np.clip(np.zeros(both.shape), both.low, both.high)

    def _parts(self, agent: str, of: Any) -> dict[str, Any]:
        return {key: of[f"{agent}.{key}"] for key in self._agents[agent].observation}

    def _is_array(self, agent: str) -> bool:
        observed = self._agents[agent].observation
        return len(observed) == 1 or not any(isinstance(each, Image) for each in observed.values())

    def _space(self, agent: str) -> Any:
        parts = self._parts(agent, self._worlds.observation_space)
        if not self._is_array(agent):
            return spaces.Dict(parts)
        if len(parts) == 1:
            return next(iter(parts.values()))
        low, high = (np.concatenate([getattr(each, side) for each in parts.values()]) for side in ("low", "high"))
        return spaces.Box(low, high, dtype=np.float32)

    def _observations(self, agents: Sequence[str]) -> dict[str, Any]:
        row = self._worlds.observations.row(0)
        seen: dict[str, Any] = {}
        for agent in agents:
            parts = self._parts(agent, row)
            if not self._is_array(agent):
                seen[agent] = parts
            else:
                seen[agent] = next(iter(parts.values())) if len(parts) == 1 else np.concatenate(list(parts.values()))
        return seen

    def observation_space(self, agent: str) -> Any:
        """The space of an agent's observations, always the same object."""
        return self.observation_spaces[agent]

    def action_space(self, agent: str) -> spaces.Box:
        """The space of an agent's actions, always the same object."""
        return self.action_spaces[agent]

    @property
    def simulation(self) -> Simulation:
        """The world, for inspection or changes between two steps."""
        return self._worlds.simulations[0]

    @property
    def moment(self) -> Moment:
        """What the agents' functions received last."""
        return self._worlds.moment

    def reset(
        self, seed: int | None = None, options: dict[str, Any] | None = None
    ) -> tuple[dict[str, Any], dict[str, dict[str, Any]]]:
        """Begins an episode with all agents.

        seed: seed of the environment's random numbers, and of all those of the world in this episode.
        options: not used.
        Returns the observations and empty infos, by the names of the agents.
        """
        if seed is not None or self._random is None:
            self._random, _ = seeding.np_random(seed)
        self.agents = []
        self._worlds.begin(np.ones(1, np.bool_), [seed], [self._random])
        self.agents = list(self.possible_agents)
        return self._observations(self.agents), {agent: {} for agent in self.agents}

    def step(
        self, actions: Mapping[str, Any]
    ) -> tuple[dict[str, Any], dict[str, float], dict[str, bool], dict[str, bool], dict[str, dict[str, Any]]]:
        """Takes a step of the task's `step_time`.

        actions: one for each of `agents`.
        Returns observations, rewards, whether terminated, whether truncated, and empty infos, by the names of these agents;
        those whose episode has ended are not among `agents` any more. Raises ValueError for a missing action, a wrong shape
        and numbers that are not finite, and Gymnasium's ResetNeeded when no agent is there.
        """
        if self._worlds.is_closed:
            raise Gone("the environment is closed")
        if not self.agents:
            raise error.ResetNeeded("call reset before the first step, after the end of an episode, and after a step that "
                                    "raised an exception")
        acting, self.agents = self.agents, []
        _, _, ended = self._worlds.step(self._joined(actions, acting)[None])
        moment = self.moment
        rewards: dict[str, float] = {}
        terminated: dict[str, bool] = {}
        for name in acting:
            agent = self._agents[name]
            done = agent.terminated is not None and judge(f"terminated of '{name}'", agent.terminated, moment, TRUTHS)[0]
            terminated[name] = bool(done)
            rewards[name] = float(judge(f"the reward of '{name}'", agent.reward, moment, NUMBERS)[0])
        truncated = {name: bool(ended[0]) for name in acting}
        self.agents = [name for name in acting if not terminated[name] and not truncated[name]]
        return self._observations(acting), rewards, terminated, truncated, {name: {} for name in acting}

    def _joined(self, actions: Mapping[str, Any], acting: Sequence[str]) -> NDArray[np.float64]:
        joined = self._rest.copy()
        for name in acting:
            if name not in actions:
                raise ValueError(f"there is no action of agent '{name}'")
            action = np.asarray(actions[name], np.float64)
            if action.shape != self.action_spaces[name].shape:
                raise ValueError(
                    f"an action of '{name}' has the shape {self.action_spaces[name].shape}, not {action.shape}"
                )
            joined[self._places[name]] = action
        return joined

    def render(self) -> NDArray[np.uint8] | None:
        """An image of the current world: rows x columns x red, green, blue. None without a `render_mode`."""
        return None if self.render_mode is None else self._worlds.draw()[0]

    def close(self) -> None:
        """Closes the world."""
        self.agents = []
        self._worlds.close()
