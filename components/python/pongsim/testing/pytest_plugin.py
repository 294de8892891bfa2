"""The plugin of pytest: worlds as fixtures.

    from pongsim.testing import expect, topic

    def test_the_wall_is_touched(pongsim_world):
        world = pongsim_world("sensor_tutorial.sdf")
        world.publish("/cmd_vel", {"linear": {"x": 2}})
        expect(topic("/wall/touched")).eventually(data=True, within=20)
        world.run(30)
"""

from __future__ import annotations

from typing import Any, Callable, Iterator

import pytest

from .world import World


@pytest.fixture
def pongsim_world() -> Iterator[Callable[..., World]]:
    """Opens a world: `pongsim_world("world.sdf", seed=1)`. It ends with the test, which fails if something was expected and
    the world was not run."""
    opened: list[World] = []

    def open_world(world: Any, **options: Any) -> World:
        opened.append(World(world, **options))
        return opened[-1]

    yield open_world
    for each in opened:
        each.close()
    for each in opened:
        each.check_done()
