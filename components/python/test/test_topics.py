"""Topics and services within the process."""

import collections
import queue

import pytest

import pongsim

TWIST = {"linear": {"x": 0.5, "y": 0.0, "z": 0.0}}


def test_a_dict_goes_round(court):
    heard = []
    subscription = court.subscribe("/a", heard.append)
    court.publish("/a", TWIST, type="Twist")
    assert heard == []
    court.step()
    assert heard == [TWIST]
    assert (subscription.received, subscription.dropped, subscription.topic) == (1, 0, "/a")
    subscription.close()
    assert not subscription.is_open
    court.publish("/a", TWIST, type="Twist")
    court.step()
    assert len(heard) == 1


def test_a_subscription_needs_no_holding(court):
    heard = []
    court.subscribe("/a", heard)
    court.publish("/a", {"data": "x"}, type="StringMsg")
    court.dispatch()
    assert heard == [{"data": "x"}]


def test_queues(court):
    small, row = queue.Queue(maxsize=2), collections.deque()
    court.subscribe("/a", small)
    court.subscribe("/a", row)
    for i in range(4):
        court.publish("/a", {"data": i}, type="Int32")
    court.step()
    assert [small.get_nowait()["data"] for _ in range(2)] == [2, 3]
    assert [each["data"] for each in row] == [0, 1, 2, 3]
    with pytest.raises(TypeError, match="function or a queue"):
        court.subscribe("/a", 3)


def test_the_oldest_of_too_many_is_lost(court):
    heard = []
    subscription = court.subscribe("/a", heard, length=2)
    for i in range(5):
        court.publish("/a", {"data": i}, type="Int32")
    court.step()
    assert [each["data"] for each in heard] == [3, 4]
    assert subscription.dropped == 3


def test_classes_of_messages(court):
    heard, raw = [], []
    court.subscribe("/a", heard, type=pongsim.messages.Twist)
    court.subscribe("/a", raw, type=bytes)
    message = pongsim.messages.Twist()
    message.linear.x = 0.25
    court.publish("/a", message)
    court.step()
    assert heard == [message] and raw == [message.SerializeToString()]
    assert message.DESCRIPTOR.full_name == "ignition.msgs.Twist"
    with pytest.raises(AttributeError):
        pongsim.messages.Twits
    with pytest.raises(TypeError):
        court.publish("/a", message, type="Pose")


def test_the_type_is_that_of_the_topic(court):
    before = court.model("pong_bot").pose.position
    assert court.topics["/cmd_vel"] == "ignition.msgs.Twist"
    court.publish("/cmd_vel", "linear: {x: 0.5}")
    court.run_until(1)
    assert court.model("pong_bot").pose.position != before
    with pytest.raises(ValueError, match="type is unknown"):
        court.publish("/nobody", {})


def test_all_kinds_of_fields(court):
    heard = []
    court.subscribe("/a", heard)
    any_message = {"type": "STRING", "string_value": "ä"}
    court.publish("/a", any_message, type="Any")
    court.publish("/b", {}, type="Empty")
    court.step()
    for key, value in any_message.items():
        assert heard[0][key] == value
    images = []
    court.subscribe("/i", images)
    image = {"width": 2, "height": 1, "data": b"\x00\xff", "pixel_format_type": "L_INT8",
             "header": {"stamp": {"sec": -3, "nsec": 5}, "data": [{"key": "k", "value": ["v", "w"]}]}}
    court.publish("/i", image, type="Image")
    court.step()
    for key, value in image.items():
        assert images[0][key] == value


@pytest.mark.parametrize(
    "type, data",
    [
        ("Int32", -(2**31)), ("UInt32", 2**32 - 1), ("Int64", -(2**63)), ("UInt64", 2**64 - 1), ("Double", 0.1),
        ("Float", 0.5), ("Boolean", True), ("StringMsg", "ä"), ("Bytes", b"\x00\xff"),
        ("Int32_V", [1, -2]), ("UInt32_V", [3, 2**32 - 1]), ("Int64_V", [-(2**63), 5]), ("UInt64_V", [2**64 - 1, 6]),
        ("Double_V", [0.1, -7.0]), ("Float_V", [0.5, -8.0]), ("StringMsg_V", ["a", "ä"]),
    ],
)
def test_each_kind_of_field_goes_round(court, type, data):
    heard = []
    court.subscribe("/a", heard)
    court.publish("/a", {"data": data}, type=type)
    court.step()
    assert heard[0]["data"] == data


@pytest.mark.parametrize(
    "type, data, error, said",
    [
        ("UInt32", 2**32, ValueError, "it goes from 0 to 4294967295"),
        ("UInt64", -1, ValueError, "it goes from 0 to 18446744073709551615"),
        ("UInt64", "1", TypeError, "a whole number, not str"),
        ("Boolean", "yes", TypeError, "True or False, not str"),
        ("Bytes", "text", TypeError, "bytes, not str"),
        ("StringMsg_V", "ab", TypeError, "a list, not str"),
        ("Int32_V", 5, TypeError, "a list, not int"),
        ("Double_V", [1.0, "x"], TypeError, r"data\[1\]' must be a number"),
    ],
)
def test_what_does_not_fit_a_kind_of_field_is_told(court, type, data, error, said):
    with pytest.raises(error, match=said):
        court.publish("/a", {"data": data}, type=type)


@pytest.mark.parametrize(
    "message, error, said",
    [
        ({"linar": {}}, ValueError, "did you mean 'linear'"),
        ({"linear": {"x": "fast"}}, TypeError, "'linear.x' must be a number, not str"),
        ({"linear": 3}, TypeError, "linear"),
        ({"header": {"stamp": {"nsec": 2**40}}}, ValueError, "out of range"),
        ({"header": {"stamp": {"sec": 1.5}}}, TypeError, "whole number"),
        ({"header": {"data": [{"key": 1}]}}, TypeError, r"header.data\[0\].key"),
        ({3: 4}, TypeError, "strings"),
        ("linear: {x: }", ValueError, "1:"),
        (7, TypeError, "must be a dict"),
    ],
)
def test_what_is_wrong_with_a_message_is_told(court, message, error, said):
    with pytest.raises(error, match=said):
        court.publish("/a", message, type="Twist")


def test_wrong_types_and_names(court):
    with pytest.raises(ValueError, match="did you mean 'ignition.msgs.Twist'"):
        court.publish("/a", {}, type="Twits")
    with pytest.raises(ValueError):
        court.subscribe("a b", print)
    with pytest.raises(ValueError):
        court.subscribe("/a", print, length=0)
    with pytest.raises(ValueError, match="no value"):
        court.publish("/a", {"type": "NUMBER"}, type="Any")


def test_what_a_callback_raises_the_step_raises(court):
    def fail(message):
        raise LookupError("as it must")

    subscription = court.subscribe("/a", fail)
    court.publish("/a", TWIST, type="Twist")
    with pytest.raises(LookupError, match="as it must"):
        court.step(100)
    assert court.iterations == 1
    subscription.close()
    court.step()


def test_callbacks_can_close_and_publish_but_not_step(court):
    heard = []

    def once(message):
        heard.append(message)
        subscription.close()
        court.publish("/b", {"data": 1}, type="Int32")
        with pytest.raises(pongsim.Busy, match="within"):
            court.step()
        with pytest.raises(pongsim.Busy):
            court.insert("<sdf version='1.9'><model name='x'><link name='l'/></model></sdf>")
        with pytest.raises(pongsim.Busy):
            court.close()

    subscription = court.subscribe("/a", once)
    later = []
    court.subscribe("/b", later)
    court.publish("/a", TWIST, type="Twist")
    court.publish("/a", TWIST, type="Twist")
    court.step(2)
    assert len(heard) == 1 and len(later) == 1


def test_services_of_the_world(court):
    box = "<sdf version='1.9'><model name='crate'><link name='l'/></model></sdf>"
    answer = court.request("/world/pong_world/create", {"sdf": box, "pose": {"position": {"z": 2.0}}}, type="EntityFactory")
    assert answer == {"data": True}
    assert court.model("crate").pose.position == (0, 0, 2)
    reply = court.request("/world/pong_world/remove", "name: 'crate', type: MODEL", type="Entity",
                          reply=pongsim.messages.Boolean)
    assert reply.data is True
    assert "crate" not in court.model_names


def test_services_that_refuse_or_are_not_there(court):
    with pytest.raises(pongsim.ServiceError, match="nobody"):
        court.request("/world/pong_world/remove", {"name": "nobody", "type": "MODEL"}, type="Entity")
    with pytest.raises(pongsim.ServiceError, match="has no service '/no'"):
        court.request("/no", {}, type="Empty")
    with pytest.raises(ValueError, match="give it"):
        court.request("/no", {})
    with pytest.raises(ValueError, match="timeout"):
        court.request("/no", {}, type="Empty", timeout=-1)
