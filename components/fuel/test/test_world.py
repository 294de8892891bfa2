"""Worlds that include models by their Fuel addresses: pongsim run, view and sdf download what is missing."""

import json
import os
import shutil
import signal
import unittest

from fuel_server import PATIENCE, PONGSIM, Place, Server, model_files, until

NAO = model_files("Nao", body="".join(f"""
    <link name="{part}"><pose>0 0 {height} 0 0 0</pose>
      <inertial><mass>0.5</mass><inertia><ixx>0.01</ixx><iyy>0.01</iyy><izz>0.01</izz></inertia></inertial>
    </link>
    <joint name="{joint}" type="revolute"><parent>body</parent><child>{part}</child>
      <axis><xyz>0 0 1</xyz><limit><lower>-2</lower><upper>2</upper></limit></axis></joint>
    <plugin filename="ignition-gazebo-joint-position-controller-system"
            name="ignition::gazebo::systems::JointPositionController">
      <joint_name>{joint}</joint_name><p_gain>2</p_gain><i_gain>0</i_gain><d_gain>0.3</d_gain></plugin>"""
    for part, joint, height in (("head", "HeadYaw", 0.6), ("arm", "LShoulderPitch", 0.4))) + """
    <plugin filename="ignition-gazebo-joint-state-publisher-system"
            name="ignition::gazebo::systems::JointStatePublisher"/>""")


class World(unittest.TestCase):
    def setUp(self):
        self.server = self._enter(Server())
        self.place = self._enter(Place(self.server))

    def _enter(self, manager):
        self.addCleanup(manager.__exit__, None, None, None)
        return manager.__enter__()

    def write(self, body, name="world.sdf"):
        file = self.place.home / name
        file.write_text(f"<sdf version='1.9'>\n<world name='w'>\n{body}\n</world>\n</sdf>\n")
        return file

    def run_steps(self, world, *words, **more):
        return self.place.run(PONGSIM, "run", world, "-z", "0", "--iterations", "10", *words, **more)

    def test_what_is_missing_is_asked_for_at_once(self):
        wheel = self.server.add("o", "wheel", model_files("wheel"))
        axle = self.server.add("o", "axle", model_files("axle", f"<include><uri>{wheel}</uri></include>"))
        car = self.server.add("o", "Big Car", model_files("car"), 4)
        for name in ("axle", "Big Car"):
            self.server.fault(f"{name}.zip", "stall", 1)
        world = self.write(f"<include><uri>{axle}</uri></include>\n<include><uri>{car}/4</uri><pose>0 0 5 0 0 0</pose></include>")
        process = self.place.start(PONGSIM, "run", world, "-z", "0", "--iterations", "10")
        # both downloads are in progress at the same time
        until(lambda: len(self.server.zips()) == 2, "two requests")
        self.server.stall.set()
        _, error = process.communicate(timeout=PATIENCE)
        self.assertEqual(process.returncode, 0, error)
        self.assertIn("pongsim: downloading o/axle", error)
        self.assertIn("world 'w': 2 models", error)
        self.assertEqual(len(self.server.zips()), 3)
        # once the models are in the cache, there are no further requests
        count = len(self.server.requests)
        self.assertEqual(self.run_steps(world).returncode, 0)
        self.assertEqual(len(self.server.requests), count)

    def test_meshes_and_textures_of_other_models_are_downloaded(self):
        box = self.server.add("o", "box", model_files("box"), 2)
        mesh = f"<mesh><uri>{box}/2/files/meshes/box.obj</uri></mesh>"
        world = self.write(f"""<model name="m"><static>true</static><link name="l">
            <collision name="c"><geometry>{mesh}</geometry></collision></link></model>""")
        result = self.run_steps(world, "--strict")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(len(self.server.zips()), 1)
        text = world.read_text().replace("box.obj", "none.obj")
        world.write_text(text)
        result = self.run_steps(world)
        self.assertIn("none.obj' is not found", result.stderr)
        self.assertIn("hint: there is no 'meshes/none.obj' in " + str(self.place.cache), result.stderr)
        self.assertEqual(len(self.server.zips()), 1)

    def test_the_rewritten_mesh_of_a_model_is_found(self):
        url = self.server.add("o", "My Box", model_files("My Box"))
        printed = self.place.run(PONGSIM, "sdf", "-p", self.write(f"<include><uri>{url}</uri></include>"))
        self.assertEqual(printed.returncode, 0, printed.stderr)
        self.assertNotIn("box.obj", printed.stderr)
        self.assertIn("model://elsewhere/a.obj' is not found", printed.stderr)

    def test_a_model_that_can_not_be_had_is_said_with_its_line(self):
        world = self.write("<include><uri>https://fuel.gazebosim.org/1.0/o/models/none</uri></include>\n"
                           "<include><uri>https://fuel.gazebosim.org/1.0/o/models/none/2</uri></include>")
        result = self.run_steps(world)
        self.assertEqual(result.returncode, 1)
        self.assertIn(f"{world}:3:10: error: 'https://fuel.gazebosim.org/1.0/o/models/none' can't be downloaded: the server "
                      "fuel.gazebosim.org does not have it (status 404)", result.stderr)
        self.assertIn(f"{world}:4:10: error: ", result.stderr)
        self.assertIn("2 errors", result.stderr)

    def test_who_wants_to_hear_nothing_hears_nothing(self):
        url = self.server.add("o", "m", model_files("m"))
        result = self.run_steps(self.write(f"<include><uri>{url}</uri></include>"), "-v", "1")
        self.assertEqual((result.returncode, result.stdout), (0, ""))
        self.assertNotIn("download", result.stderr)

    def test_offline_only_the_cache_counts(self):
        url = self.server.add("o", "m", model_files("m"))
        world = self.write(f"<include><uri>{url}</uri></include>")
        for words, environment in ((["--offline"], {}), ([], {"PONGSIM_OFFLINE": "1"})):
            result = self.run_steps(world, *words, **environment)
            self.assertEqual(result.returncode, 1)
            self.assertIn(f"'{url}' is not in the local Fuel cache", result.stderr)
            self.assertIn("hint: downloads are off: PONGSIM_OFFLINE or --offline is set", result.stderr)
        for words in (["sdf", "-k", world, "--offline"], ["view", world, "--offline"]):
            self.assertIn("is not in the local Fuel cache", self.place.run(PONGSIM, *words).stderr)
        self.assertEqual(self.server.connects, [])
        self.assertEqual(self.place.fuel("download", url).returncode, 0)
        self.assertEqual(self.run_steps(world, "--offline").returncode, 0)

    def test_a_world_runs_by_its_address(self):
        files = {"metadata.pbtxt": 'name: "Court"\nworld {\n  file_format { name: "sdf" }\n  file: "court.sdf"\n}\n',
                 "a.sdf": "<sdf", "court.sdf": "<sdf version='1.9'><world name='court'/></sdf>"}
        url = self.server.add("Anna", "The Court", files, 2, kind="worlds")
        result = self.run_steps(url)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("world 'court'", result.stderr)
        checked = self.place.run(PONGSIM, "sdf", "-k", url + "/2", "--offline")
        self.assertEqual(checked.stdout, "Valid.\n", checked.stderr)
        model = self.server.add("o", "m", model_files("m"))
        self.assertIn("2 models", self.run_steps(model).stderr)
        self.assertEqual(self.run_steps(url + "x").returncode, 1)

    def test_the_program_of_the_package_is_asked_for_where_it_is_not_installed(self):
        # an installation without the optional package: the program and its dependencies in another folder
        place = self.place.home / "install"
        for name in ("bin", "lib", "share"):
            (place / name).mkdir(parents=True)
        build = PONGSIM.parents[1]
        shutil.copy(PONGSIM, place / "bin")
        for library in (build / "lib").glob("libpongsim*.so*"):
            shutil.copy(library, place / "lib", follow_symlinks=False)
        url = self.server.add("o", "m", model_files("m"))
        result = self.place.run(place / "bin/pongsim", "run", self.write(f"<include><uri>{url}</uri></include>"))
        self.assertEqual(result.returncode, 1)
        self.assertIn("hint: install pongsim-fuel to download it: apt-get install pongsim-fuel", result.stderr)

    def test_an_interrupted_download_ends_the_run(self):
        url = self.server.add("o", "m", model_files("m"))
        self.server.fault("m.zip", "stall", 1)
        process = self.place.start(PONGSIM, "run", self.write(f"<include><uri>{url}</uri></include>"), prefix=["setsid"])
        until(lambda: self.server.zips(), "a request")
        os.killpg(process.pid, signal.SIGINT)
        _, error = process.communicate(timeout=PATIENCE)
        self.assertEqual(process.returncode, 1)
        self.assertIn("can't be downloaded: it was interrupted", error)

    def test_two_naos_move_their_joints(self):
        # an exercise of a course with two Nao robots, with a smaller model in their place
        url = self.server.add("OpenRobotics", "Nao with Ignition position controller", NAO, 2)
        url = url.replace(" ", "%20").replace("gazebosim.org", "ignitionrobotics.org")
        world = self.write("".join(f"""
            <include><name>nao_{i}</name><uri>{url}/2</uri><pose>{i} 0 0 0 0 0</pose></include>
            <joint name="stand_{i}" type="fixed"><parent>world</parent><child>nao_{i}::body</child></joint>""" for i in (1, 2)))
        process = self.place.start(PONGSIM, "run", world)
        self.addCleanup(process.communicate)
        self.addCleanup(process.kill)
        while line := process.stderr.readline():
            if "world 'w': 2 models" in line:
                break
        self.assertTrue(line)
        self.assertEqual(len(self.server.zips()), 1)

        def position(model, joint):
            result = self.place.run(PONGSIM, "topic", "-e", "-n", "1", "--json-output", "-t", f"/world/w/model/{model}/joint_state")
            message = json.loads(result.stdout)
            return {each["name"]: each.get("axis1", {}).get("position", 0.0) for each in message["joint"]}[joint]

        for model, joint, angle in (("nao_1", "HeadYaw", 0.5), ("nao_2", "LShoulderPitch", -0.7)):
            topic = f"/model/{model}/joint/{joint}/0/cmd_pos"
            sent = self.place.run(PONGSIM, "topic", "-t", topic, "-m", "ignition.msgs.Double", "-p", f"data: {angle}",
                                  "--timeout", "60")
            self.assertEqual(sent.returncode, 0, sent.stderr)
            until(lambda m=model, j=joint, a=angle: abs(position(m, j) - a) <= 0.05, f"{joint} of {model} at {angle}")
        self.assertLess(abs(position("nao_2", "HeadYaw")), 0.05)
        self.assertLess(abs(position("nao_1", "LShoulderPitch")), 0.05)
        process.send_signal(signal.SIGINT)
        self.assertEqual(process.wait(PATIENCE), 0)


if __name__ == "__main__":
    unittest.main()
