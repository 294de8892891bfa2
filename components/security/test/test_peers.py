"""Independent Fast DDS nodes with keystores made by pongsim and keystores as sros2 makes them."""

import pathlib
import unittest

import sros2
from secured import DOMAIN, FAST_PEER, Place, until

CLOCK = ("rt/clock", "rosgraph_msgs::msg::dds_::Clock_")
OWN_CLOCK = ("/clock", "ignition.msgs.Clock")


def enclave(keystore, name):
    return {"ROS_SECURITY_ENABLE": "true", "ROS_SECURITY_STRATEGY": "Enforce", "ROS_SECURITY_KEYSTORE": str(keystore),
            "ROS_SECURITY_ENCLAVE_OVERRIDE": name}


def heard(peer):
    return peer.output().count("read ")


@unittest.skipUnless(pathlib.Path(FAST_PEER).exists(), "there is no node of Fast DDS: it is built with ros2/")
class Peers(unittest.TestCase):
    def setUp(self):
        self.place = Place()
        self.addCleanup(self.place.close)

    def reader(self, topic, **environment):
        return self.place.start("read", *topic, "reliable", program=FAST_PEER, **environment)

    def only_the_secured_hears(self, topic, keystore, name, others=()):
        """Readers without permission are started first. They get no message, and one with permission gets 20."""
        silent = [self.reader(topic), *(self.reader(topic, **environment) for environment in others)]
        peer = self.reader(topic, **enclave(keystore, name))
        until(lambda: heard(peer) > 20, "messages")
        self.assertEqual([heard(each) for each in silent], [0] * len(silent))

    def test_topics_of_ours(self):
        self.place.world("--secure", "keys")
        self.place.run("security", "add", "deaf", "--keystore", "keys", "--allow-publish", "*")
        self.place.run("security", "init", "foreign")
        self.only_the_secured_hears(OWN_CLOCK, self.place.keys, "/pongsim",
                                    [enclave(self.place.keys, "/deaf"), enclave(self.place.path / "foreign", "/pongsim")])

    def test_nodes_of_ros_by_our_keystore(self):
        self.place.world("--ros2", "--secure", "keys")
        self.only_the_secured_hears(CLOCK, self.place.keys, "/pongsim")

    def test_nodes_of_ros_by_a_keystore_of_sros2(self):
        keystore = self.place.path / "sros2"
        sros2.make_keystore(keystore, DOMAIN)
        for name in ("/simulation", "/talker"):
            sros2.make_enclave(keystore, name, DOMAIN)
        listed = self.place.run("security", "list", keystore)
        self.assertIn("subject:     CN=/talker", listed)
        self.place.world("--ros2", **enclave(keystore, "/simulation"))
        self.only_the_secured_hears(CLOCK, keystore, "/talker")

    def test_a_keystore_of_sros2_takes_identities_of_ours(self):
        keystore = self.place.path / "sros2"
        sros2.make_keystore(keystore, DOMAIN)
        sros2.make_enclave(keystore, "/talker", DOMAIN)
        said = self.place.run("topic", "-l", "--secure", f"{keystore}/talker", code=1)
        self.assertIn("identity '/talker' may not publish topic 'pongsim/census'", said)
        self.place.run("security", "add", "pongsim", "--keystore", keystore)
        self.place.world("--secure", keystore)
        until(lambda: "/cmd_vel" in self.place.run("topic", "-l", "--secure", keystore), "a list with /cmd_vel")

    def test_a_key_that_others_can_read_is_refused(self):
        keystore = self.place.path / "sros2"
        sros2.make_keystore(keystore, DOMAIN)
        sros2.make_enclave(keystore, "/talker", DOMAIN)
        self.place.path.chmod(0o755)
        said = self.place.run("run", "--ros2", code=1, **enclave(keystore, "/talker"))
        self.assertIn("enclaves/talker/key.pem can be read by other users (mode 0644)", said)
        self.assertIn("chmod 600 ", said)
        sros2.close_keys(keystore)
        self.place.run("security", "list", keystore)

    def test_an_enclave_that_is_missing_ends_the_run(self):
        said = self.place.run("run", "--ros2", code=1, **enclave(self.place.keys, "/nobody"))
        self.assertIn("has no enclave '/nobody', but /pongsim", said)


if __name__ == "__main__":
    unittest.main(verbosity=2)
