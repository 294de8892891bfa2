"""Sweep files: the runs that they define, and messages for mistakes."""

import collections

import pytest
from sweeps import WORLD, ball, write

from pongsim import sweep
from pongsim.sweep.design import latin_hypercube
from pongsim.sweep.execute import world_of


def read(folder, text):
    write(folder, "w.sdf", WORLD)
    write(folder, "judge.py", "def score(sim, parameters):\n    return 1\n")
    return sweep.read(write(folder, "s.yaml", text))


HEAD = "world: w.sdf\nduration: 1\nmeasures: {m: {function: judge.py:score}}\n"


def values(made, *names):
    return [tuple(run.parameters[name] for name in names) for run in made.runs]


def test_a_grid_has_all_combinations_and_seeds_change_first(tmp_path):
    made = read(tmp_path, HEAD + "parameters: {a: {values: [1, 2]}, b: {values: [x, y]}}\nseeds: [5, 6]\n")
    assert [(run.number, *run.parameters.values(), run.seed) for run in made.runs] == [
        (0, 1, "x", 5), (1, 1, "x", 6), (2, 1, "y", 5), (3, 1, "y", 6),
        (4, 2, "x", 5), (5, 2, "x", 6), (6, 2, "y", 5), (7, 2, "y", 6)]


def test_zip_takes_values_side_by_side(tmp_path):
    made = read(tmp_path, HEAD + "combine: zip\nparameters: {a: {values: [1, 2]}, b: {values: [x, y]}}\nseeds: 2\n")
    assert values(made, "a", "b") == [(1, "x"), (1, "x"), (2, "y"), (2, "y")]
    assert [run.seed for run in made.runs] == [0, 1, 0, 1]


@pytest.mark.parametrize("text, expected", [
    ("{from: 1, to: 4, step: 1}", [1, 2, 3, 4]),
    ("{from: 0, to: 0.3, step: 0.1}", [0.0, 0.1, 0.2, 0.3]),
    ("{from: 1, to: 0, step: -0.4}", [1.0, 0.6, 0.2]),
    ("{from: 0, to: 1, count: 3}", [0.0, 0.5, 1.0]),
    ("{from: 1e-3, to: 1e-3, step: 1}", [0.001]),
])
def test_ranges(tmp_path, text, expected):
    made = read(tmp_path, HEAD + f"parameters: {{a: {{range: {text}}}}}\n")
    assert [run.parameters["a"] for run in made.runs] == expected


@pytest.mark.parametrize("text, seeds", [("3", [0, 1, 2]), ("{from: 7, count: 2}", [7, 8]), ("[4, 2]", [4, 2])])
def test_seeds(tmp_path, text, seeds):
    assert [run.seed for run in read(tmp_path, HEAD + f"seeds: {text}\n").runs] == seeds


def test_a_latin_hypercube_has_one_point_in_each_slice():
    points = latin_hypercube(50, 3, 7)
    for column in zip(*points):
        assert collections.Counter(int(each * 50) for each in column) == dict.fromkeys(range(50), 1)
    assert points == latin_hypercube(50, 3, 7) != latin_hypercube(50, 3, 8)
    # must never change: sweeps are resumed, and cited in papers
    assert [round(each, 6) for each in latin_hypercube(3, 2, 1)[0]] == FIRST_POINT


FIRST_POINT = [0.085023, 0.676116]


def test_what_is_drawn_is_within_its_bounds_and_goes_with_what_is_listed(tmp_path):
    made = read(tmp_path, HEAD + "parameters: {a: {between: [2, 4]}, b: {values: [1, 2]}}\n"
                "latin_hypercube: {samples: 10, seed: 3}\n")
    assert len(made.runs) == 20
    assert all(2 <= run.parameters["a"] < 4 for run in made.runs)
    assert [run.parameters["a"] for run in made.runs[:10]] == [run.parameters["a"] for run in made.runs[10:]]


def test_only_the_value_in_the_world_changes(tmp_path):
    write(tmp_path, "w.sdf", WORLD)
    made = sweep.read(write(tmp_path, "s.yaml", """
world: w.sdf
duration: 1
measures: {z: {topic: /model/ball/odometry, field: pose.position.z}}
parameters:
  m: {values: [7], xpath: "//mass"}
  n: {values: [a<b&"c"], xpath: "//model[@name='other']/@name"}
  s: {values: [true], xpath: "//model[@name='ground']/static"}
  p: {values: [4], xpath: "//geometry/plane", text: "x${p}y"}
"""))
    text = world_of(made.plan, made.runs[0])
    assert text == (WORLD.replace("<mass>2</mass>", "<mass>7</mass>")
                    .replace('name="other"', 'name="a&lt;b&amp;&quot;c&quot;"').replace("<plane/>", "<plane>x4y</plane>"))


MISTAKES = {
    "no key": ("world: w.sdf\n", r"s.yaml:1:1: error: a sweep has no 'measures'"),
    "unknown key": (HEAD + "seed: 3\n", r"s.yaml:4:7: error: a sweep has no 'seed' \(did you mean 'seeds'\?\)"),
    "no world": (HEAD.replace("w.sdf", "x.sdf"), r"s.yaml:1:8: error: there is no file .*x.sdf"),
    "bad yaml": (HEAD + "a: [1\nb: 2\n", r"s.yaml:5:2: error: "),
    "unquoted": (HEAD + "parameters: {a: {xpath: //b[@c='d']/e}}\n", r"s.yaml:4:28: error: .*put text with"),
    "twice": (HEAD + "seeds: 2\nseeds: 3\n", r"s.yaml:5:1: error: 'seeds' is given twice"),
    "alias": (HEAD + "parameters: {a: &x {values: [1]}, b: *x}\n", r"s.yaml:4:38: error: aliases"),
    "empty": ("", r"s.yaml:1:1: error: the file is empty"),
    "a list": ("- 1\n", r"s.yaml:1:1: error: a sweep must be a mapping"),
    "no values": (HEAD + "parameters: {a: {}}\n", r"s.yaml:4:14: error: parameter 'a' has no values \(give values"),
    "two kinds": (HEAD + "parameters: {a: {values: [1], between: [1, 2]}}\n", r"'a' has values and between"),
    "no step": (HEAD + "parameters: {a: {range: {from: 0, to: 1}}}\n", r"s.yaml:4:18: error: .* either step or count"),
    "no way": (HEAD + "parameters: {a: {range: {from: 0, to: 1, step: -1}}}\n", r"s.yaml:4:48: error: steps of -1"),
    "too many": (HEAD + "parameters: {a: {range: {from: 0, to: 1, step: 1e-9}}}\n", r"more than 1000000 values"),
    "too many runs": (HEAD + "seeds: 1000000\nparameters: {a: {values: [1, 2]}}\n", r"2000000 runs, more than"),
    "bounds": (HEAD + "parameters: {a: {between: [2, 1]}}\n", r"s.yaml:4:18: error: 'a'.between: 2 is not below 1"),
    "no samples": (HEAD + "parameters: {a: {between: [1, 2]}}\n", r"no 'latin_hypercube'"),
    "lengths": (HEAD + "combine: zip\nparameters: {a: {values: [1]}, b: {values: [1, 2]}}\n", r"same number .*a: 1, b: 2"),
    "no number": (HEAD.replace("duration: 1", "duration: long"), r"s.yaml:2:11: error: duration must be a number, not 'long'"),
    "no finite number": (HEAD.replace("duration: 1", "duration: 1" + 400 * "0"), r"s.yaml:2:11: error: duration must be a number"),
    "no end": (HEAD.replace("duration: 1\n", ""), r"either 'duration' or 'until'"),
    "endless": (HEAD.replace("duration: 1", "until: {topic: /a, field: b, above: 1}"), r"needs limits.simulated"),
    "take": (HEAD.replace("function: judge.py:score", "topic: /a, field: b, take: lats"), r"there is no 'lats' to take \(did you mean 'last'"),
    "no function": (HEAD.replace("score", "scor"), r"s.yaml:3:26: error: .*judge.py has no function 'scor' \(did you mean 'score'"),
    "nowhere": ("world: w.sdf\nduration: 1\nmeasures: {m: {topic: /a, field: b}}\nparameters: {a: {values: [1]}}\n",
                r"s.yaml:4:14: error: parameter 'a' is not used"),
    "reserved": (HEAD + "parameters: {status: {values: [1]}}\n", r"'status' can't be the name of a parameter"),
    "unknown name": (HEAD + "parameters: {a: {values: [1]}}\ncommands: [{topic: /t, message: {x: $b}}]\n",
                     r"s.yaml:5:24: error: \$b is not a parameter"),
    "nothing met": (HEAD + "parameters: {a: {values: [1], xpath: '//model/link/mass'}}\n",
                    r"s.yaml:4:38: error: '//model/link/mass' matches nothing in .*w.sdf \('//model/link' matches <link> at .*w.sdf:5, which contains: collision\)"),
    "two met": (HEAD + "parameters: {a: {values: [1], xpath: '//static'}}\n",
                r"s.yaml:4:38: error: '//static' matches 2 places: <static> at .*w.sdf:5, <static> at .*w.sdf:11"),
    "elements": (HEAD + "parameters: {a: {values: [1], xpath: '//inertial'}}\n", r"matches <inertial> at .*w.sdf:7, which contains elements \(.*: mass\)"),
    "no xpath": (HEAD + "parameters: {a: {values: [1], xpath: '//['}}\n", r"s.yaml:4:38: error: '//\[' is not an XPath"),
    "no character": (HEAD + 'parameters: {a: {values: [1], xpath: "//a\\0"}}\n', r"s.yaml:4:38: error: '//a\0' is not an XPath"),
    "a number": (HEAD + "parameters: {a: {values: [1], xpath: 'count(//mass)'}}\n", r"gives 1.0, not an element or attribute"),
    "same place": (HEAD + "parameters: {a: {values: [1], xpath: '//mass'}, b: {values: [1], xpath: '//inertial/mass'}}\n",
                   r"s.yaml:4:\d+: error: .* selects the same place as another parameter"),
}


@pytest.mark.parametrize("text, message", MISTAKES.values(), ids=MISTAKES.keys())
def test_mistakes_are_told_with_their_place(tmp_path, text, message):
    with pytest.raises(sweep.SweepError, match=message):
        read(tmp_path, text)


def test_a_world_that_is_no_xml_is_told_with_its_place(tmp_path):
    write(tmp_path, "w.sdf", "<sdf>\n<world>\n</sdf>\n")
    write(tmp_path, "s.yaml", "world: w.sdf\nduration: 1\nmeasures: {m: {topic: /a, field: b}}\n"
          "parameters: {a: {values: [1], xpath: //b}}\n")
    with pytest.raises(sweep.SweepError, match=r"w.sdf:3:7: error: it is not XML"):
        sweep.read(tmp_path / "s.yaml")


def test_a_judge_that_is_no_python_is_told_with_its_place(tmp_path):
    write(tmp_path, "w.sdf", WORLD)
    write(tmp_path, "judge.py", "x = 1\ndef score(:\n")
    with pytest.raises(sweep.SweepError, match=r"judge.py:2: error: "):
        sweep.read(write(tmp_path, "s.yaml", HEAD))


def test_mistakes_in_a_dict_are_told_with_the_way_to_them(tmp_path):
    write(tmp_path, "w.sdf", WORLD)
    with pytest.raises(sweep.SweepError, match=r"sweep.duration: error: duration must be a number, not 'long'"):
        sweep.read(ball(world=str(tmp_path / "w.sdf"), duration="long"))
