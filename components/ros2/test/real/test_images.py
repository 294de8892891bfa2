"""Images reach a best-effort subscriber as those of a real publisher do."""

import pathlib
import subprocess
import sys

import ros
import simulation
from rclpy.qos import qos_profile_sensor_data
from sensor_msgs.msg import Image

PUBLISHER = pathlib.Path(__file__).with_name("image_publisher.py")
WORLD = """<sdf version="1.9"><world name="studio">
<physics name="10ms" type="ignored"><max_step_size>0.01</max_step_size><real_time_factor>1</real_time_factor></physics>
<plugin filename="gz-sim-sensors-system" name="gz::sim::systems::Sensors"/>
<model name="tripod"><static>true</static><link name="link"><sensor name="camera" type="camera"><topic>image</topic>
<update_rate>30</update_rate><camera><image><width>640</width><height>480</height></image></camera></sensor></link></model>
</world></sdf>"""
FRAMES = 90


def share(stamps):
    """How many of the images of a time came, from the first to the last."""
    return len(stamps) / (30 * (stamps[-1] - stamps[0]) + 1)


def test_a_camera_of_vga_at_30_hz(tmp_path):
    world = tmp_path / "studio.sdf"
    world.write_text(WORLD)
    stamps = {"/image": [], "/real": []}
    publisher = subprocess.Popen([sys.executable, PUBLISHER])
    try:
        with simulation.running(world, "--ros2"), ros.node() as tester:
            for topic, times in stamps.items():
                def take(image, times=times):
                    assert len(image.data) == 640 * 480 * 3
                    times.append(image.header.stamp.sec + 1e-9 * image.header.stamp.nanosec)

                tester.create_subscription(Image, topic, take, qos_profile_sensor_data)
            simulation.until(lambda: all(len(times) >= FRAMES for times in stamps.values()), f"{FRAMES} images of each")
    finally:
        publisher.kill()
        publisher.wait()
    ours, real = share(stamps["/image"]), share(stamps["/real"])
    assert ours > 0.9 * real, f"of ours {ours:.0%} came, of a real publisher's {real:.0%}"
