"""What accuracy costs: run by tools/bench engines --accuracy.

Each engine simulates the same time with steps of many lengths. For the error that pongsim and that MuJoCo make at 1 ms, the
least processor time of a simulated second is found among the steps of each engine whose errors are not larger.
"""

import statistics
import time

STEPS = (0.00025, 0.0005, 0.001, 0.002, 0.004, 0.008, 0.016)
USUAL = 0.001
#: What is timed begins and ends there [s].
BEGIN, END = 0.3, 0.8


def cost(engine, case, step):
    """Processor time of a simulated second [ms]."""
    made = engine(case.scene(), step)
    made.step(round(BEGIN / step))
    count = round((END - BEGIN) / step)
    begin = time.process_time()
    made.step(count)
    taken = time.process_time() - begin
    made.close()
    return 1e3 * taken / (count * step)


def compare(case, engines, rounds):
    """Prints costs and errors at all steps, and costs at the same errors. `engines`: classes by name, ours first."""
    errors = {(name, step): case.error(engine, step) for name, engine in engines.items() for step in STEPS}
    times = {key: [] for key in errors}
    for _ in range(rounds):
        for name, step in errors:
            times[name, step].append(cost(engines[name], case, step))
    costs = {key: statistics.median(found) for key, found in times.items()}
    for name in engines:
        told = "  ".join(f"{1e3 * step:g} ms: {costs[name, step]:.2f} {errors[name, step]:.1e}" for step in STEPS)
        print(f"{case.name:<22} {name:<22} {told}", flush=True)
    for name in list(engines)[:2]:
        show(case, errors[name, USUAL], name, engines, errors, costs)


def show(case, error, whose, engines, errors, costs):
    told = []
    for name in engines:
        # an error that is not a number is larger than any
        enough = [(costs[name, step], step) for step in STEPS if errors[name, step] <= error]
        least = min(enough, default=None)
        told.append(f"{name}: " + (f"{least[0]:.2f} at {1e3 * least[1]:g} ms" if least else "at no step"))
    size = f"{error:.1e} {case.unit}".strip()
    print(f"{case.name:<22} at the error of {whose} ({size}): {', '.join(told)}", flush=True)
