#!/usr/bin/env python3
"""The same drops through Carom, Rapier, Box2D and MuJoCo, in turn: `python3 bench/peers/run.py [--quick] [--boundary] [--hollows]`.

Builds the two Rust programs, installs the two Python packages into a folder of their own below `target/`, runs all engines
round after round, and writes the table to `bench/peers/RESULTS.md`. What cannot be had is named, and left out.
"""

import argparse
import csv
import json
import os
import shutil
import subprocess
import sys
import venv
from pathlib import Path

import hollow
import hollow_table
import inputs
import table

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent
WORK = ROOT / "target" / "peers"
REFERENCE = ROOT / "crates" / "carom-feeder" / "tests" / "reference"
PACKAGES = {"box2d": "Box2D==2.3.10", "mujoco": "mujoco==4.0.0"}

# Runs without which a profile is made: a drop takes as long as a hundred.
TOO_SLOW = {"fine"}

# engine, setting, part, its name in the table
RUNS = [
    ("carom", "rod-default", "rod", "Carom, default (tolerance 1e-11)"),
    ("carom", "rod-fast", "rod", "Carom, tolerance 1e-6"),
    ("carom", "rod-loose", "rod", "Carom, tolerance 1e-4"),
    ("carom", "box-default", "box", "Carom, default (tolerance 1e-11)"),
    ("carom", "box-fast", "box", "Carom, tolerance 1e-6"),
    ("carom", "box-loose", "box", "Carom, tolerance 1e-4"),
    ("rapier", "fast", "box", "Rapier f64, lengths ×100, no contact recycling, friction in the bias pass, 1 ms"),
    ("rapier", "fine", "box", "Rapier f64, the same, 0.1 ms"),
    ("rapier", "default", "box", "Rapier f64, vendor's defaults (1/60 s)"),
    ("box2d", "fast", "box", "Box2D, lengths ×100, 2 ms"),
    ("box2d", "fine", "box", "Box2D, lengths ×1000, 0.5 ms"),
    ("box2d", "default", "box", "Box2D, vendor's defaults (1/60 s)"),
    ("mujoco", "tuned", "box", "MuJoCo, stiff overdamped contacts, elliptic cone, 0.05 ms"),
    ("mujoco", "fine", "box", "MuJoCo, the same, 0.01 ms"),
    ("mujoco", "default", "box", "MuJoCo, vendor's defaults (2 ms)"),
]

# Runs of parts with hollows: engine, setting, its name in the table. The last of an engine is its finest.
HOLLOW_RUNS = [
    ("box2d", "1/1000", "Box2D, ×100, 1/1000 s"),
    ("box2d", "1/5000", "Box2D, ×100, 1/5000 s"),
    ("box2d", "1/20000", "Box2D, ×100, 1/20000 s"),
    ("box2d", "1/5000, ×1000", "Box2D, ×1000, 1/5000 s"),
    ("box2d", "1/20000, ×1000", "Box2D, ×1000, 1/20000 s"),
    ("box2d", "1/50000, ×1000", "Box2D, ×1000, 1/50000 s"),
    ("mujoco", "1/1000", "MuJoCo, 1/1000 s"),
    ("mujoco", "1/5000", "MuJoCo, 1/5000 s"),
    ("mujoco", "1/20000", "MuJoCo, 1/20000 s"),
    ("mujoco", "1/100000", "MuJoCo, 1/100000 s"),
]


def main():
    parser = argparse.ArgumentParser(description="The same drops through Carom and three physics engines.")
    parser.add_argument("--quick", action="store_true", help="2 rounds instead of 5")
    parser.add_argument("--boundary", action="store_true", help="make the list boundary.csv anew, and end")
    parser.add_argument("--hollows", action="store_true", help="only parts with hollows: their section is made anew")
    arguments = parser.parse_args()
    rounds = 2 if arguments.quick else 5

    WORK.mkdir(parents=True, exist_ok=True)
    page = HERE / "RESULTS.md"
    if arguments.hollows:
        before = page.read_text().split(hollow_table.HEADING)[0]
        commands = {"carom": [str(cargo("carom", "plain", []))]} | python_engines({})
        page.write_text(before + hollows(commands))
        return
    commands, missing = prepare()
    if arguments.boundary:
        made = subprocess.run(commands["carom"] + ["boundary"], check=True, stdout=subprocess.PIPE)
        (HERE / "boundary.csv").write_bytes(made.stdout)
        return
    lists = {"grid": WORK / "grid.csv", "boundary": HERE / "boundary.csv", "strikes": WORK / "strikes.csv"}
    inputs.write_grid(REFERENCE / "feeder_grid.csv", lists["grid"])
    inputs.write_strikes(REFERENCE / "feeder_exact.json", lists["strikes"])

    results = measure(commands, missing, lists, rounds)
    runs = [run for run in RUNS if run[:2] in results]
    exact = {part: inputs.exact_spins(REFERENCE / "feeder_exact.json", part) for part in ("rod", "box")}
    wanted = {name: verdicts(lists[name]) for name in ("grid", "boundary")}
    text = table.page(runs, results, wanted, exact, versions(commands), missing, rounds)
    if "carom" in commands:
        text += "\n" + hollows(commands)
    page.write_text(text)
    print(text)


def hollows(commands):
    """The section on parts with hollows, from every engine of the runs that can be had."""
    path = WORK / "hollow.csv"
    hollow.write_list(path)
    runs = [run for run in HOLLOW_RUNS if run[0] in commands]
    carom = ask(commands["carom"], "hollow", path)["drops"]
    engines = {}
    for engine, setting, name in runs:
        print(name, file=sys.stderr)
        engines[engine, setting] = ask(commands[engine], "hollow", setting, path)["drops"]
    shown = versions({engine: command for engine, command in commands.items() if engine != "rapier"})
    names = [text for name, text in shown.items() if name != "build"]
    return hollow_table.section(names, runs, carom, engines)


def prepare():
    """How each engine is called, and what is missing with the reason."""
    commands, missing = {}, {}
    for engine in ("carom", "rapier"):
        try:
            commands[engine] = [str(build(engine))]
        except (OSError, subprocess.CalledProcessError) as problem:
            missing[engine] = said(problem)
    commands |= python_engines(missing)
    for engine, reason in missing.items():
        print(f"{engine} is left out: {reason}", file=sys.stderr)
    return commands, missing


def python_engines(missing):
    """How the engines that are Python packages are called; what is missing is added with the reason."""
    commands = {}
    for engine, package in PACKAGES.items():
        try:
            commands[engine] = [str(install(package)), str(HERE / "worker.py"), engine]
        except (OSError, subprocess.CalledProcessError) as problem:
            missing[engine] = said(problem)
    return commands


def said(problem):
    """The last line of what a failed command said."""
    lines = (getattr(problem, "stderr", None) or str(problem)).strip().splitlines()
    return lines[-1] if lines else "it failed and said nothing"


def build(engine):
    """Builds an engine's Rust program for the processor at hand, where the tools are there guided by a profile of the list of 100."""
    print(f"building {engine}", file=sys.stderr)
    merge = profile_tool()
    if merge is None:
        return cargo(engine, "plain", [])
    profile = WORK / f"profile-{engine}"
    shutil.rmtree(profile, ignore_errors=True)
    watched = cargo(engine, "watched", [f"-Cprofile-generate={profile}"])
    for name, setting, *_ in RUNS:
        if name == engine and setting not in TOO_SLOW:
            ask([str(watched)], "drop", setting, HERE / "boundary.csv")
    merged = profile / "merged.profdata"
    subprocess.run([merge, "merge", "-o", merged, profile], check=True, stderr=subprocess.PIPE, text=True)
    return cargo(engine, "guided", [f"-Cprofile-use={merged}"])


def cargo(engine, kind, flags):
    """Builds an engine's Rust program with these flags into a folder of its own."""
    manifest = HERE / engine / "Cargo.toml"
    words = ["cargo", "build", "--release", "--manifest-path", manifest, "--target-dir", WORK / kind]
    own = os.environ | {"RUSTFLAGS": " ".join(["-C target-cpu=native", *flags])}
    subprocess.run(words, check=True, stderr=subprocess.PIPE, text=True, env=own)
    return WORK / kind / "release" / f"peers-{engine}"


def profile_tool():
    """The tool that merges profiles, which `rustup component add llvm-tools` brings; None where it is not there."""
    root = subprocess.run(["rustc", "--print", "sysroot"], check=True, stdout=subprocess.PIPE, text=True).stdout.strip()
    return next(Path(root).glob("lib/rustlib/*/bin/llvm-profdata*"), None)


def install(package):
    """Installs a Python package into the folder of the Python engines, and returns the Python to call."""
    print(f"installing {package}", file=sys.stderr)
    folder = WORK / "python"
    python = folder / ("Scripts/python.exe" if os.name == "nt" else "bin/python")
    if not python.exists():
        venv.create(folder, with_pip=True)
    words = [python, "-m", "pip", "install", "--quiet", "--disable-pip-version-check", package]
    subprocess.run(words, check=True, stderr=subprocess.PIPE, text=True)
    return python


def verdicts(path):
    """The exact verdicts of a list, for each part."""
    with open(path, newline="") as file:
        rows = list(csv.DictReader(file))
    return {part: [row[f"verdict_{name}"] for row in rows] for part, name in (("rod", "rod"), ("box", "box_1mm"))}


def ask(command, *words):
    """What an engine answers."""
    environment = {**os.environ, "OMP_NUM_THREADS": "1", "RAYON_NUM_THREADS": "1"}
    command = command + [str(word) for word in words]
    answer = subprocess.run(command, check=True, capture_output=True, text=True, env=environment)
    return json.loads(answer.stdout)


def measure(commands, missing, lists, rounds):
    """Every run's verdicts and spins once, and the seconds of the grid once a round, all engines in turn.

    An engine that fails is taken out of `commands` and named in `missing`.
    """
    results = {}
    for n in range(rounds):
        print(f"round {n + 1} of {rounds}", file=sys.stderr)
        for engine, setting, *_ in RUNS:
            if engine not in commands:
                continue
            try:
                result = results.setdefault((engine, setting), {"seconds": []})
                advance(result, commands[engine], setting, lists)
                if engine == "carom":
                    result.setdefault("maps", []).append(ask(commands[engine], "map", setting))
            except (OSError, ValueError, subprocess.CalledProcessError) as problem:
                missing[engine] = said(problem)
                print(f"{engine} is left out: {missing[engine]}", file=sys.stderr)
                del commands[engine]
    return {run: result for run, result in results.items() if run[0] in commands}


def advance(result, command, setting, lists):
    """One round of one run; the first one asks for what is needed once as well."""
    if not result["seconds"]:
        result["boundary"] = ask(command, "drop", setting, lists["boundary"])["verdicts"]
        result["spins"] = ask(command, "impact", setting, lists["strikes"])["spins"]
    answer = ask(command, "drop", setting, lists["grid"])
    if result.setdefault("grid", answer["verdicts"]) != answer["verdicts"]:
        raise ValueError(f"other verdicts at {setting} than in the round before")
    result["seconds"].append(answer["seconds"])


def versions(commands):
    """The engines' versions, and the compiler's."""
    found = {}
    for engine in ("carom", "rapier"):
        if engine in commands:
            name = {"carom": "carom-feeder", "rapier": "rapier2d-f64"}[engine]
            found[engine] = f"{name} {locked(HERE / engine / 'Cargo.lock', name)}"
    for engine in PACKAGES:
        if engine in commands:
            found[engine] = f"{PACKAGES[engine].split('==')[0]} {ask(commands[engine], 'version')['version']}"
    found["python"] = "Python " + sys.version.split()[0]
    found["rust"] = subprocess.run(["rustc", "--version"], stdout=subprocess.PIPE, text=True).stdout.strip()
    guided = "guided by profiles of the second list" if profile_tool() else "without profiles"
    found["build"] = f"both Rust programs built for the processor at hand, {guided}"
    return found


def locked(path, name):
    """The version of a package in a lock file."""
    lines = path.read_text().splitlines()
    return lines[lines.index(f'name = "{name}"') + 1].split('"')[1]


if __name__ == "__main__":
    main()
