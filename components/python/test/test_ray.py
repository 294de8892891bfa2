"""A sweep on a Ray cluster of two nodes, of which one is killed."""

import tempfile

import pytest
from sweeps import make, write

from pongsim import sweep

ray = pytest.importorskip("ray", reason="Ray is not installed")
cluster_utils = pytest.importorskip("ray.cluster_utils")

SEEDS = 250


#: Where a run was made: the node's name; nothing where it is no cluster.
WHERE = """
import sys
def where(sim, parameters):
    ray = sys.modules.get("ray")
    return ray.get_runtime_context().get_node_id() if ray is not None and ray.is_initialized() else ""
"""


@pytest.fixture
def cluster(monkeypatch):
    # no usage reports
    monkeypatch.setenv("RAY_USAGE_STATS_ENABLED", "0")
    # beside /tmp/ray, where a cluster of the user's would be; a short name, for sockets lie in it
    folder = tempfile.TemporaryDirectory(dir="/tmp", ignore_cleanup_errors=True)
    monkeypatch.setenv("RAY_TMPDIR", folder.name)
    # a lost node is noticed soon
    made = cluster_utils.Cluster(initialize_head=True, head_node_args={
        "num_cpus": 1, "include_dashboard": False, "object_store_memory": 80 * 2**20,
        "_system_config": {"health_check_initial_delay_ms": 1000, "health_check_period_ms": 500,
                           "health_check_failure_threshold": 4}})
    yield made
    ray.shutdown()
    made.shutdown()
    folder.cleanup()


def test_a_node_that_is_killed_costs_no_run_and_changes_no_bit(cluster, tmp_path, monkeypatch):
    def rows(**options):
        return make(tmp_path, seeds=SEEDS, options=options, measures={
            "z": {"topic": "/model/ball/odometry", "field": "pose.position.z"},
            "node": {"function": str(write(tmp_path, "judge.py", WHERE)) + ":where"}})

    alone = rows()
    assert len(alone) == 2 * SEEDS and not alone.failed
    add = sweep.runner.Journal.add
    nodes = []

    def come_and_go(journal, row):
        add(journal, row)
        # it comes behind the program that waits for the rows, which is joined to the first one so
        if not nodes:
            nodes.append(cluster.add_node(num_cpus=1, object_store_memory=80 * 2**20))
        seen = {each.measures["node"] for each in journal.rows.values()}
        if len(journal.rows) >= SEEDS and len(seen) == 2 and len(nodes) == 1:
            cluster.remove_node(nodes[0], allow_graceful=False)
            nodes.append(None)

    monkeypatch.setattr(sweep.runner.Journal, "add", come_and_go)
    spread = rows(ray=cluster.address, restart=True)
    assert len(nodes) == 2 and len(set(spread.column("node"))) == 2
    assert len(spread) == 2 * SEEDS and spread.column("status") == ["done"] * 2 * SEEDS
    assert spread.column("state_hash") == alone.column("state_hash")
    assert spread.column("z") == alone.column("z")


def test_a_run_that_ends_its_process_costs_itself_only(cluster, tmp_path, monkeypatch):
    # each time Ray starts a process again, which takes seconds
    monkeypatch.setattr("pongsim.sweep.ray_pool._RETRIES", 1)
    write(tmp_path, "judge.py", "import os\ndef score(sim, parameters):\n    if parameters['n'] == 20: os._exit(3)\n    return 1\n")
    rows = make(tmp_path, duration=0.01, parameters={"n": {"range": {"from": 0, "to": 39, "step": 1}}},
                measures={"m": {"function": str(tmp_path / "judge.py:score")}}, options={"ray": cluster.address}).rows
    assert [row.run for row in rows if not row.is_done] == [20]
    assert rows[20].reason.startswith("Ray lost it 2 times")


def test_a_cluster_that_is_not_there_is_told_and_nothing_is_forgotten(tmp_path):
    make(tmp_path)
    before = (tmp_path / "out/journal.jsonl").read_bytes()
    for address, message in (("127.0.0.1:1", "there is no Ray cluster at '127.0.0.1:1'"), ("here", "is not the address of a Ray"),
                             ("ray://127.0.0.1:1", "there is no Ray cluster"), ("local", "is not the address of a Ray")):
        with pytest.raises(sweep.SweepError, match=message):
            make(tmp_path, options={"ray": address, "restart": True})
    assert (tmp_path / "out/journal.jsonl").read_bytes() == before
