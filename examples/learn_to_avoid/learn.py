"""Learns to drive among walls by trial alone, in minutes:
    python3 examples/learn_to_avoid/learn.py --output policy.npz

The policy is linear: how near the walls are in each of 16 sectors, times 34 parameters, gives speed and turn. They are
found by the cross-entropy method (Rubinstein, 1999): draw candidates around the best guess so far, let all drive at once,
each from the same two starts, and guess again from the best quarter. The same seed gives the same policy, to the bit.
"""

import argparse
import hashlib

import gymnasium
import numpy as np

import pongsim.gym  # noqa: F401  its environments have names then

SECTORS = 16
STARTS = 2
PARAMETERS = 2 * (SECTORS + 1)
SEEN = 5.0  # what is farther away does not matter [m]


def drive(policies, ranges):
    """What each policy does: n x 34 parameters, n x 64 ranges; n x (speed ahead, turn)."""
    nearest = ranges.reshape(len(ranges), SECTORS, -1).min(axis=2)
    nearness = 1 - np.minimum(nearest, SEEN) / SEEN
    inputs = np.concatenate([nearness, np.ones((len(ranges), 1))], axis=1)
    outputs = np.einsum("ni,noi->no", inputs, policies.reshape(-1, 2, SECTORS + 1))
    turn = np.tanh(outputs[:, 1])
    speed = 1 / (1 + np.exp(-outputs[:, 0]))
    return np.stack([speed, turn], axis=1)


def score(envs, policies, seeds):
    """Returns of the first episode of each environment, and whether it ended with a hit."""
    ranges, _ = envs.reset(seed=seeds)
    returns, hits, going = np.zeros(envs.num_envs), np.zeros(envs.num_envs, bool), np.ones(envs.num_envs, bool)
    while going.any():
        ranges, rewards, terminated, truncated, _ = envs.step(drive(policies, ranges.astype(float)))
        returns += np.where(going, rewards, 0)
        hits |= going & terminated
        going &= ~(terminated | truncated)
    return returns, hits


def learn(envs, population, iterations, random):
    """The best guess after so many iterations."""
    mean, spread = np.zeros(PARAMETERS), np.ones(PARAMETERS)
    for iteration in range(iterations):
        candidates = mean + spread * random.standard_normal((population, PARAMETERS))
        starts = [int(seed) for seed in random.integers(2**31, size=STARTS)]
        returns, hits = score(envs, np.repeat(candidates, STARTS, axis=0), starts * population)
        worth = returns.reshape(population, STARTS).mean(axis=1)
        best = candidates[np.argsort(-worth, kind="stable")[: max(2, population // 4)]]
        # a spread of its own that fades keeps the guess from settling too early
        mean, spread = best.mean(axis=0), best.std(axis=0) + 0.5 * 0.85**iteration
        print(f"iteration {iteration + 1:2}: return {worth.mean():6.2f}, best {worth.max():6.2f}, "
              f"{hits.mean():4.0%} hit a wall", flush=True)
    return mean


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--iterations", type=int, default=20)
    parser.add_argument("--population", type=int, default=24, help="candidates that drive at once, each in two worlds")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--threads", type=int, help="as many as there are processors, unless it says otherwise")
    parser.add_argument("--output", help="a file for the policy")
    options = parser.parse_args()
    envs = gymnasium.make_vec("pongsim/WallAvoid-v0", num_envs=STARTS * options.population, threads=options.threads)
    policy = learn(envs, options.population, options.iterations, np.random.default_rng(options.seed))
    # from starts that it has not seen
    returns, hits = score(envs, np.tile(policy, (envs.num_envs, 1)), list(range(2**31, 2**31 + envs.num_envs)))
    envs.close()
    print(f"learnt: return {returns.mean():.2f}, {hits.sum()} of {len(hits)} hit a wall")
    print(f"policy: {hashlib.sha256(policy.tobytes()).hexdigest()[:16]}")
    if options.output:
        np.savez(options.output, policy=policy)


if __name__ == "__main__":
    main()
