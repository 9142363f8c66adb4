"""The referee: the same cases as the command, a judge that refuses what is no answer, and engines that are asked where they are installed."""

import json
import subprocess
import sys
from pathlib import Path

import pytest

import carom
from carom import referee
from carom.referee.engines.question import Patience, Question

CASES = referee.cases()
#: An engine in a few lines: frictionless balls by Newton's law, everything else refused.
PROGRAM = """
import json, sys
for line in sys.stdin:
    case = json.loads(line)
    answer = {"case": case["case"], "refused": "only balls without friction"}
    if case["group"] == "ball" and case["impact"]["contact"][0]["friction"] == 0:
        body, contact = case["impact"]["body"], case["impact"]["contact"][0]
        x, y = body["velocity"]
        answer = {"case": case["case"], "velocity_m_s": [x, -contact["restitution"] * y], "spin_rad_s": body["spin"]}
    print(json.dumps(answer))
"""


def test_cases_are_the_commands(command: Path) -> None:
    said = subprocess.run([command, "cases", "--format", "json"], capture_output=True, text=True, check=True).stdout
    assert [json.loads(line) for line in said.splitlines()] == CASES


def test_the_judge_is_the_commands(command: Path, tmp_path: Path) -> None:
    answers = [{"case": case["case"], "bodies": case["expected"]["answers"][-1]["bodies"]} for case in CASES if "impact" in case]
    file = tmp_path / "mine.jsonl"
    file.write_text("".join(json.dumps(answer) + "\n" for answer in answers))
    said = subprocess.run([command, "judge", str(file), "--format", "json"], capture_output=True, text=True, check=True).stdout
    judged = referee.judge([file])
    assert judged.json == said
    assert judged.engines[0].all.agree == len(answers)
    assert "mine: " in str(judged)


@pytest.mark.parametrize(
    ("answer", "told"),
    [
        ({"case": "nobody/001", "verdict": "turned"}, "no case"),
        ({"case": "ball/001", "velocity_m_s": [0.0, float("nan")], "spin_rad_s": 0.0}, "finite number"),
        ({"case": "ball/001", "bodies": []}, "is asked"),
        ({"case": "ball/001", "velocity_m_s": "fast", "spin_rad_s": 0}, "line 1"),
        ({"case": "drop/001", "verdict": 3}, "line 1"),
    ],
)
def test_what_is_no_answer_is_refused(answer: dict[str, object], told: str) -> None:
    with pytest.raises(carom.CaromError, match=told):
        referee.judge({"mine": [answer]})


def test_bad_calls_are_told() -> None:
    with pytest.raises(carom.CaromError, match="no answer to judge"):
        referee.judge({"mine": []})
    with pytest.raises(carom.CaromError, match="a list of answers is asked"):
        referee.judge({"mine": "all"})
    with pytest.raises(carom.CaromError, match="each is a dictionary"):
        referee.judge({"mine": ["all"]})
    with pytest.raises(carom.CaromError, match="two files answer"):
        referee.judge({name: [{"case": "drop/001", "engine": "one", "verdict": "same"}] for name in ("a", "b")})
    with pytest.raises(carom.CaromError, match="cannot read nowhere"):
        referee.judge("nowhere.jsonl")
    with pytest.raises(carom.CaromError, match="cannot read"):
        referee.judge(["nowhere.jsonl"])
    with pytest.raises(carom.CaromError, match="share from 0 to 1"):
        referee.judge({"mine": [{"case": "drop/001", "verdict": "same"}]}, within=2.0)
    with pytest.raises(carom.CaromError, match="ended with 3"):
        referee.ask(f"mine={sys.executable} -c 'raise SystemExit(3)'", CASES[:1])
    with pytest.raises(carom.CaromError, match="line 1 of its answers"):
        referee.ask(f"""mine={sys.executable} -c "import sys; sys.stdout.buffer.write(bytes([255, 10]))" """, CASES[:1])
    with pytest.raises(carom.CaromError, match="line 1 of its answers"):
        referee.ask(f"mine={sys.executable} -c 'print(1, 2)'", CASES[:1])


def test_a_program_of_ones_own_is_asked(tmp_path: Path) -> None:
    program = tmp_path / "engine.py"
    program.write_text(PROGRAM)
    answers = referee.ask(f"balls={sys.executable} {program}", CASES)
    judged = referee.judge({"balls": answers}).engines[0]
    ball = next(group for group in judged.groups if group.group == "ball")
    assert judged.engine == "balls"
    assert (ball.agree, ball.differ) == (11, 0)
    assert judged.all.refused == len(CASES) - 11


def test_a_question_has_the_motion_that_the_case_writes() -> None:
    row = Question.of(next(case for case in CASES if case["group"] == "row of balls")["impact"])
    before = [body.twist for body in row.bodies]
    assert row.in_plane
    assert row.approach(row.contacts[0], before) < 0 == row.approach(row.contacts[1], before)
    space = Question.of(next(case for case in CASES if case["group"] == "one contact in space")["impact"])
    assert not space.in_plane
    assert set(space.written(space.bodies[0].twist)) == {"velocity_m_s", "spin_rad_s"}
    assert Patience(space, 1).sees([body.twist for body in space.bodies]) is None, "it still closes"


def test_engines_are_here_to_be_asked() -> None:
    assert {"box2d", "mujoco", "pymunk"} <= set(referee.installed()), "what the tests bring along"


@pytest.mark.parametrize("engine", referee.installed())
def test_engines_answer_balls_and_drops_nearly_right(engine: str) -> None:
    """Balls without restitution within a tenth of the motion; drops on the right side."""
    asked = [case for case in CASES if case["group"] == "ball" and case["impact"]["contact"][0]["restitution"] == 0]
    asked += [case for case in CASES if case["group"] == "drop"][:4]
    judged = referee.judge({engine: referee.ask(engine, asked)}, asked, within=0.1).engines[0]
    assert judged.all.agree + judged.all.refused == len(asked)
    assert judged.all.agree >= 4


def test_the_module_prints_a_table(tmp_path: Path) -> None:
    program = tmp_path / "engine.py"
    program.write_text(PROGRAM)
    words = [sys.executable, "-m", "carom.referee", "--engine", f"balls={sys.executable} {program}", "--group", "ball", "--out", str(tmp_path / "kept")]
    said = subprocess.run(words, capture_output=True, text=True, check=False)
    assert said.returncode == 0, said.stderr
    assert "balls: 11 of 11 answers agree" in said.stdout
    assert len((tmp_path / "kept" / "balls.jsonl").read_text().splitlines()) == len(referee.cases("ball"))
