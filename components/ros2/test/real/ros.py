"""A real node for tests: rclpy, spun on a thread."""

import contextlib
import os
import pathlib
import sys
import threading

import pytest
import rclpy
from rclpy.executors import SingleThreadedExecutor

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
import simulation  # noqa: E402

NO_TOOLS = pathlib.Path(sys.prefix) / "no_tools"
needs_tools = pytest.mark.skipif(NO_TOOLS.exists(), reason=NO_TOOLS.read_text() if NO_TOOLS.exists() else "")
DISTRO = os.environ["ROS_DISTRO_OF_TEST"]
WORLD = simulation.ROOT / "components/ros2/test/drive.sdf"


@contextlib.contextmanager
def node(name="tester"):
    """A node whose callbacks run while the test goes on."""
    context = rclpy.Context()
    rclpy.init(context=context)
    tester = rclpy.create_node(name, context=context)
    executor = SingleThreadedExecutor(context=context)
    executor.add_node(tester)
    thread = threading.Thread(target=executor.spin)
    thread.start()
    try:
        yield tester
    finally:
        executor.shutdown()
        thread.join()
        tester.destroy_node()
        rclpy.shutdown(context=context)


def on_its_thread(tester, function, *arguments):
    """What a function returns on the thread that spins the node. Goals are sent there: Jazzy's ActionClient notes a request
    only after it has sent it, and drops an answer that another thread has read before."""
    task = tester.executor.create_task(function, *arguments)
    simulation.until(task.done, "the executor")
    return task.result()


def call(tester, kind, service, request):
    """The response of a service, which must come."""
    client = tester.create_client(kind, service)
    assert client.wait_for_service(simulation.PATIENCE), f"no service {service}"
    future = client.call_async(request)
    simulation.until(future.done, f"an answer of {service}")
    tester.destroy_client(client)
    return future.result()
