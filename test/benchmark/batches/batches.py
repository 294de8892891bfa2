"""Many worlds of one robot at once, in pongsim's VectorEnv and in MuJoCo's batch engines: run by tools/bench python.

The robots are those of ../engines/, each alone on the ground. In each step their motors are told other velocities, and
their state is observed. The engines take turns; those that are not installed are left out. EnvPool has robots of its own,
so its Ant is compared with MuJoCo's rollout of the same model.
"""

import importlib.util
import pathlib
import statistics
import sys
import time

import numpy

sys.path.insert(0, str(pathlib.Path(__file__).parent.parent / "engines"))

import pongsim_engine
import trees
import worlds

import pongsim.gym as gym

#: Of physics [s], and how many of these make one of an environment.
STEP, STEPS = 0.005, 4
WORLDS, THREADS, ROUNDS, BATCHES = 64, 2, 7, 10


def robots():
    """Scenes by name; each with its model, and the largest velocity that its motors are told [rad/s]."""
    return {
        "robot on wheels": (worlds.robots(1, 0.5, 0.4, systems=False), "robot0", 2.0),
        "quadruped, 13 links": (trees.quadruped(1, True), "quadruped0", 0.2),
    }


def driven(scene):
    return [joint.name for joint in scene.joints if joint.drive is not None]


class VectorEnv:
    name = "pongsim, VectorEnv"

    def __init__(self, scene, model, most):
        names = [f"{model}::{name}" for name in driven(scene)]
        task = gym.Task(
            world=pongsim_engine.sdf_of(scene, STEP),
            action=[gym.JointVelocity(name, -most, most) for name in names],
            observation={"pose": gym.Pose(model), "velocity": gym.Velocity(model)}
            | {name: gym.Joint(name) for name in names},
            reward=lambda now: 0.0,
            step_time=STEP * STEPS,
        )
        self.envs = gym.VectorEnv(task, WORLDS, threads=THREADS)
        self.envs.reset(seed=1)

    def step(self, told):
        observed, *_ = self.envs.step(told.astype(numpy.float32))
        return observed

    def close(self):
        self.envs.close()


class Rollout:
    """Each step of the environment is a rollout of some steps from the states that the one before ended with."""

    name = "MuJoCo, threaded rollout"

    def __init__(self, model, steps=STEPS):
        import mujoco
        from mujoco import rollout

        self.model, self.steps = model, steps
        self.datas = [mujoco.MjData(model) for _ in range(THREADS)]
        mujoco.mj_forward(model, self.datas[0])
        full = mujoco.mjtState.mjSTATE_FULLPHYSICS
        state = numpy.zeros(mujoco.mj_stateSize(model, full))
        mujoco.mj_getState(model, self.datas[0], state, full)
        self.states = numpy.tile(state, (WORLDS, 1))
        self.pool = rollout.Rollout(nthread=THREADS)

    def step(self, told):
        control = numpy.repeat(told[:, None, :], self.steps, axis=1)
        states, _ = self.pool.rollout(self.model, self.datas, self.states, control)
        self.states = states[:, -1]
        return self.states

    def close(self):
        self.pool.close()


class Mjx:
    name = "MJX on the CPU"

    def __init__(self, model):
        import jax
        from mujoco import mjx

        jax.config.update("jax_platforms", "cpu")
        device = mjx.put_model(model)

        def advance(data, control):
            data = data.replace(ctrl=control)
            return jax.lax.fori_loop(0, STEPS, lambda _, each: mjx.step(device, each), data)

        self.advance = jax.jit(jax.vmap(advance))
        self.data = jax.vmap(lambda _: mjx.make_data(device))(numpy.arange(WORLDS))
        self.step(numpy.zeros((WORLDS, model.nu)))

    def step(self, told):
        self.data = self.advance(self.data, told)
        return numpy.concatenate([self.data.qpos, self.data.qvel], axis=1)

    def close(self):
        pass


class EnvPool:
    name = "EnvPool"

    def __init__(self):
        import envpool

        self.envs = envpool.make("Ant-v4", env_type="gymnasium", num_envs=WORLDS, num_threads=THREADS)
        self.envs.reset()

    def step(self, told):
        observed, *_ = self.envs.step(told)
        return observed

    def close(self):
        self.envs.close()


def compare(title, engines, size, most):
    """Prints steps of environments a second of processor time and by the clock."""
    random = numpy.random.default_rng(1)
    spent, waited = [[] for _ in engines], [[] for _ in engines]
    for _ in range(ROUNDS):
        told = random.uniform(-most, most, (BATCHES, WORLDS, size))
        for i, engine in enumerate(engines):
            begin, start = time.process_time(), time.perf_counter()
            for each in told:
                if not numpy.isfinite(engine.step(each)).all():
                    raise RuntimeError(f"{engine.name}: {title} flew apart")
            spent[i].append(WORLDS * BATCHES / (time.process_time() - begin))
            waited[i].append(WORLDS * BATCHES / (time.perf_counter() - start))
    for engine, cpu, clock in zip(engines, spent, waited):
        ratios = [ours / theirs for ours, theirs in zip(spent[0], cpu)]
        print(f"{title:<22} {engine.name:<26} {statistics.median(cpu):10.0f} {statistics.median(clock):10.0f} "
              f"{statistics.median(ratios):8.2f}  ({min(ratios):.2f} to {max(ratios):.2f})", flush=True)
        engine.close()


def made(kinds):
    """Engines of these kinds, of which some can't be had; says why."""
    for name, make in kinds:
        try:
            yield make()
        except (ImportError, NotImplementedError) as error:
            print(f"{name} is left out: {error}", file=sys.stderr)


def main():
    print(f"\n{WORLDS} worlds at once on {THREADS} threads, a step of {STEPS} x {1000 * STEP:g} ms: steps a second of "
          f"processor time, by the clock; by processor time, the first is as many times as fast, medians of {ROUNDS} by "
          "turns")
    for title, (scene, model, most) in robots().items():
        kinds = [(VectorEnv.name, lambda: VectorEnv(scene, model, most))]
        if importlib.util.find_spec("mujoco"):
            import mujoco_engine

            theirs = mujoco_engine.mujoco.MjModel.from_xml_string(mujoco_engine.mjcf_of(scene, STEP))
            kinds += [(kind.name, lambda kind=kind: kind(theirs)) for kind in (Rollout, Mjx)]
        compare(title, list(made(kinds)), len(driven(scene)), most)
    if importlib.util.find_spec("envpool") and importlib.util.find_spec("mujoco"):
        import gymnasium
        import mujoco

        ant = mujoco.MjModel.from_xml_path(
            str(pathlib.Path(gymnasium.__file__).parent / "envs/mujoco/assets/ant.xml"))
        # Ant-v4 makes five steps of 10 ms
        kinds = [(Rollout.name, lambda: Rollout(ant, 5)), (EnvPool.name, EnvPool)]
        compare("Ant-v4, of EnvPool", list(made(kinds)), ant.nu, 1.0)
    else:
        print("EnvPool is left out", file=sys.stderr)


if __name__ == "__main__":
    main()
