"""Readings as arrays, in the memory written by the sensor."""

import ctypes.util

import numpy as np
import pytest
from conftest import LIDAR, PROJECT

import pongsim

# a box of 1 m stands 2 m ahead of the lidar and the cameras
SEEN = """<?xml version="1.0"?>
<sdf version="1.9"><world name="w">
  <plugin filename="ignition-gazebo-physics-system" name="ignition::gazebo::systems::Physics"/>
  <plugin filename="ignition-gazebo-sensors-system" name="ignition::gazebo::systems::Sensors"/>
  <light name="sun" type="directional"><direction>1 0 -1</direction></light>
  <model name="box"><static>true</static><pose>2.5 0 0 0 0 0</pose><link name="l"><visual name="v"><geometry><box>
    <size>1 1 1</size></box></geometry></visual></link></model>
  <model name="eye"><static>true</static><link name="l">%s</link></model>
</world></sdf>"""
LASER = """<sensor name="laser" type="gpu_lidar"><update_rate>100</update_rate><lidar><scan>
  <horizontal><samples>5</samples><min_angle>-0.2</min_angle><max_angle>0.2</max_angle></horizontal>
  <vertical><samples>%d</samples><min_angle>-0.1</min_angle><max_angle>0.1</max_angle></vertical></scan>
  <range><min>0.1</min><max>10</max></range></lidar></sensor>"""
CAMERA = """<sensor name="camera" type="%s"><update_rate>100</update_rate><camera><horizontal_fov>1</horizontal_fov>
  <image><width>8</width><height>6</height><format>%s</format></image><clip><near>0.1</near><far>10</far></clip></camera></sensor>"""


def address(array):
    return array.__array_interface__["data"][0]


def seen(sensors):
    return pongsim.Simulation(SEEN % sensors)


def test_ranges_are_where_they_were_written():
    with seen(LASER % 1) as sim:
        assert sim.sensor_names == ["eye::l::laser"]
        laser = sim.sensor("laser")
        with pytest.raises(pongsim.NoReading, match="next"):
            laser.ranges
        sim.step(20)
        ranges = laser.ranges
        assert ranges.shape == (5,) and ranges.dtype == np.float64
        # the single row is the lowest one
        assert ranges[2] == pytest.approx(2.0 / np.cos(0.1), rel=1e-5)
        assert address(ranges) == laser.written_at()
        assert laser.ranges is ranges
        assert not ranges.flags.writeable and not ranges.flags.owndata
        sim.model("box").move((3.5, 0, 0))
        sim.step(20)
        # in place: it is the same array
        assert ranges[2] == pytest.approx(3.0 / np.cos(0.1), rel=1e-5)
        assert address(laser.ranges) == address(ranges) == laser.written_at()
        assert laser.intensities.shape == (5,)
        assert laser.count() >= 2
        assert 0 < laser.time() <= sim.time
    # the memory is kept by the array, too
    assert ranges[2] == pytest.approx(3.0 / np.cos(0.1), rel=1e-5)


def test_points_and_rows():
    with seen(LASER % 3) as sim:
        laser = sim.sensor("eye::l::laser", "ranges", "points")
        sim.step(20)
        assert laser.ranges.shape == (3, 5)
        points = laser.points
        assert points.shape == (3, 5, 3) and points.dtype == np.float32
        assert points[1, 2] == pytest.approx([2, 0, 0], abs=1e-6)
        assert np.linalg.norm(points, axis=2) == pytest.approx(laser.ranges, rel=1e-5)
        assert address(points) == laser.written_at("points")


needs_osmesa = pytest.mark.skipif(ctypes.util.find_library("OSMesa") is None, reason="libosmesa6 is not installed")


@needs_osmesa
@pytest.mark.parametrize("pixels, shape, kind", [("R8G8B8", (6, 8, 3), np.uint8), ("L8", (6, 8), np.uint8),
                                                 ("L16", (6, 8), np.uint16)])
def test_images(pixels, shape, kind):
    with seen(CAMERA % ("camera", pixels)) as sim:
        camera = sim.sensor("camera")
        sim.step(20)
        image = camera.image
        assert image.shape == shape and image.dtype == kind
        assert address(image) == camera.written_at()
        # the box in the middle differs from what is beside it
        assert np.any(image[3, 4] != image[3, 0])


LABELLED = """<plugin filename="ignition-gazebo-label-system" name="ignition::gazebo::systems::Label"><label>7</label>
  </plugin></model><model name="eye">"""


@needs_osmesa
def test_labels():
    world = (SEEN % (CAMERA % ("segmentation_camera", "R8G8B8"))).replace('</model>\n  <model name="eye">', LABELLED)
    with pongsim.Simulation(world) as sim:
        camera = sim.sensor("camera", "image", "labels")
        assert camera.kinds == ["image", "labels"]
        sim.step(20)
        assert camera.labels.shape == (6, 8, 3) and camera.labels.dtype == np.uint8
        assert camera.labels[3, 4].tolist() == [7, 7, 7]
        assert camera.labels[3, 0].tolist() == [0, 0, 0]
        assert np.any(camera.image[3, 4] != 0) and not np.any(camera.image[3, 0])


@needs_osmesa
def test_temperatures_and_boxes():
    with seen(CAMERA % ("thermal_camera", "L16")) as sim:
        camera = sim.sensor("camera")
        sim.step(20)
        assert camera.image.shape == (6, 8) and camera.image.dtype == np.uint16
        assert camera.image[3, 0] == pytest.approx(28815, abs=20)
    with seen(CAMERA % ("boundingbox_camera", "R8G8B8")) as sim:
        camera = sim.sensor("camera", "message", "image")
        assert camera.kinds == ["message", "image"]
        sim.step(20)
        # nothing has a label
        assert camera.message().get("annotated_box", []) == []
        assert camera.image.shape == (6, 8, 3)


@needs_osmesa
def test_depths():
    with seen(CAMERA % ("rgbd_camera", "R8G8B8")) as sim:
        camera = sim.sensor("camera", "image", "depth", "points")
        assert camera.kinds == ["image", "depth", "points"]
        sim.step(20)
        depth = camera.depth
        assert depth.shape == (6, 8) and depth.dtype == np.float32
        assert depth[3, 4] == pytest.approx(2.0, rel=1e-4)
        assert address(depth) == camera.written_at("depth")
        assert camera.points.shape == (6, 8, 3)
        assert camera.points[3, 4, 0] == pytest.approx(2.0, rel=1e-4)


def test_the_tutorials_robot():
    with pongsim.Simulation(LIDAR) as sim:
        kinds = {name: sim.sensor(name).type for name in sim.sensor_names}
        assert {"gpu_lidar", "imu"} <= set(kinds.values())
        laser = sim.sensor(next(name for name, kind in kinds.items() if kind == "gpu_lidar"))
        imu = sim.sensor(next(name for name, kind in kinds.items() if kind == "imu"))
        sim.run_until(0.5)
        assert np.isfinite(laser.ranges).any()
        assert imu.message()["linear_acceleration"]["z"] == pytest.approx(9.8, abs=0.5)
        assert imu.message(pongsim.messages.IMU).linear_acceleration.z == pytest.approx(9.8, abs=0.5)


@pytest.mark.parametrize(
    ("world", "field", "value"),
    [
        ("air-speed/air_speed.sdf", "diff_pressure", 1.225 / 2 * 25**2),
        ("dvl/dvl.sdf", "velocity.mean.x", 1.5),
        ("environment-preload/environment_preload.sdf", "data", 14.9),
        ("environmental-sensor/environmental_sensor.sdf", "x", -1.5),
    ],
)
def test_sensors_of_later_releases(world, field, value):
    with pongsim.Simulation(PROJECT / "plugins/sensors" / world) as sim:
        sensor = sim.sensor(sim.sensor_names[0])
        sim.run_until(1)
        reading = sensor.message()
        for name in field.split("."):
            reading = reading[name]
        assert reading == pytest.approx(value, rel=0.01)


def test_what_a_sensor_does_not_have():
    with seen(LASER % 1) as sim:
        with pytest.raises(ValueError, match="has no image; it has ranges, points"):
            sim.sensor("laser", "image")
        with pytest.raises(ValueError):
            sim.sensor("laser").depth
        with pytest.raises(KeyError, match="did you mean 'eye::l::laser'"):
            sim.sensor("eye::l::lasr")


def test_a_sensor_that_no_system_of_the_world_supports():
    with seen('<sensor name="inertia" type="imu"/>') as sim:
        inertia = sim.sensor("inertia")
        assert inertia.kinds == []
        with pytest.raises(ValueError, match="has no message: no system of the world supports its type"):
            inertia.message()


def test_a_sensor_goes_with_its_model():
    with pongsim.Simulation(LIDAR) as sim:
        laser = sim.sensor(next(name for name in sim.sensor_names if "lidar" in name or "laser" in name))
        sim.run_until(0.3)
        ranges = laser.ranges
        sim.remove(sim.model(laser.scoped_name.split("::")[0]))
        before = ranges.copy()
        sim.step(300)
        assert np.array_equal(ranges, before)
        assert not laser.exists
        for ask in (lambda: laser.ranges, lambda: laser.pose, lambda: laser.name):
            with pytest.raises(pongsim.Gone):
                ask()
    with pytest.raises(pongsim.Gone):
        laser.ranges


def test_all_objects_for_a_sensor_share_its_readings():
    with seen(LASER % 1) as sim:
        for _ in range(20):
            try:
                ranges = sim.sensor("laser").ranges
                break
            except pongsim.NoReading as error:
                assert "100 per second" in str(error) and "step" in str(error)
                sim.step(10)
        assert ranges[2] == pytest.approx(2.0 / np.cos(0.1), rel=1e-5)
        first, second = sim.sensor("laser"), sim.sensor("eye::l::laser")
        assert address(first.ranges) == address(second.ranges) and first.count() == second.count() > 0
        second.switch_off()
        with pytest.raises(pongsim.NoReading):
            first.ranges
        assert ranges[2] == pytest.approx(2.0 / np.cos(0.1), rel=1e-5)


def test_a_sensor_that_was_removed_and_another_of_its_name_are_two():
    with seen(LASER % 1) as sim:
        first = sim.sensor("laser")
        sim.step(20)
        near = first.ranges[2]
        text = (SEEN % (LASER % 1)).partition('<model name="eye">')[2].partition("</model>")[0]
        sim.remove(sim.model("eye"))
        sim.insert(f'<sdf version="1.9"><model name="eye">{text}</model></sdf>', pose=(1, 0, 0))
        with pytest.raises(pongsim.Gone):
            first.ranges
        with pytest.raises(pongsim.NoReading):
            sim.sensor("laser").ranges
        sim.step(20)
        assert sim.sensor("laser").ranges[2] < near


def test_sensors_of_removed_models_leave_nothing():
    with seen(LASER % 1) as sim:
        text = (SEEN % (LASER % 1)).partition('<model name="eye">')[2].partition("</model>")[0]
        before = set(sim.topics)
        for i in range(20):
            eye = sim.insert(f'<sdf version="1.9"><model name="other{i}">{text}</model></sdf>')
            sim.sensor(f"other{i}::l::laser")
            sim.remove(eye)
        sim.sensor("laser")
        assert len(set(sim.topics) - before) < 3
