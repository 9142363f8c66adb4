"""How the package behaves: threads, forks, signals, copies."""

from __future__ import annotations

import multiprocessing
import os
import pickle
import signal
import threading
import time
from concurrent.futures import ThreadPoolExecutor

import carom
import numpy as np
import pytest

CASE = "examples/case_2.toml"


def dropped(friction: float) -> float:
    return float(carom.drops(CASE, {"contact.friction": [friction] * 100})["end_s"][99])


@pytest.mark.parametrize(
    "work",
    [
        lambda: carom.drops(CASE, {"contact.friction": np.full(10_000_000, 0.15)}),
        lambda: carom.yield_("examples/designer.toml", samples=1 << 24),
        lambda: carom.design("examples/design_turn_once.toml", samples=1 << 28),
        lambda: carom.map(CASE, "contact.friction=0..0.3:1000", "plate.upper.slope=9..25 deg:1000", accuracy=1e-12, depth=8),
        lambda: carom.regions("stool", "tilt=1..80 deg:1000", "direction=40..140 deg:1000"),
        lambda: carom.feed("examples/feed_closely.toml", parts=20, intervals=4000),
        lambda: carom.fit("examples/measured.toml", "examples/measured.csv", samples=1 << 20, nodes=1 << 20),
    ],
    ids=["drops", "yield", "design", "map", "regions", "feed", "fit"],
)
def test_ctrl_c_stops_long_work(work: object) -> None:
    begun = 0.0

    def press() -> None:
        nonlocal begun
        begun = time.monotonic()
        os.kill(os.getpid(), signal.SIGINT)

    # Who runs in the background of a shell is told to ignore ctrl-C.
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    threading.Timer(0.5, press).start()
    # Each of them would take minutes.
    try:
        with pytest.raises(KeyboardInterrupt):
            work()  # type: ignore[operator]
    finally:
        signal.signal(signal.SIGINT, before)
    print(f"measured: stopped {1e3 * (time.monotonic() - begun):.0f} ms after ctrl-C")
    # And the next call works.
    assert dropped(0.15) > 0


def test_an_error_of_progress_stops_the_work() -> None:
    def hear(done: int, pieces: int | None) -> None:
        raise RuntimeError(f"heard {pieces}")

    with pytest.raises(RuntimeError, match="heard 1000000"):
        carom.drops(CASE, {"contact.friction": np.full(1_000_000, 0.15)}, progress=hear)


def test_progress_is_told() -> None:
    heard: list[tuple[int, int | None]] = []
    carom.drops(CASE, {"contact.friction": np.full(20_000, 0.15)}, progress=lambda done, pieces: heard.append((done, pieces)))
    assert all(pieces == 20_000 for _, pieces in heard) and heard == sorted(heard)
    assert heard[-1] == (20_000, 20_000), "the end is told"
    with pytest.raises(TypeError, match="progress"):
        carom.drops(CASE, {"contact.friction": 0.15}, progress="x")  # type: ignore[arg-type]


def test_the_line_of_progress_is_taken_away(capfd: pytest.CaptureFixture[str]) -> None:
    carom.drops(CASE, {"contact.friction": np.full(20_000, 0.15)}, progress=True)
    said = capfd.readouterr().err
    assert "of 20000" in said and said.endswith("\r")


def test_threads_get_the_same() -> None:
    frictions = np.linspace(0.01, 0.17, 32).tolist()
    alone = [dropped(friction) for friction in frictions]
    with ThreadPoolExecutor(8) as pool:
        assert list(pool.map(dropped, frictions)) == alone


def test_other_threads_run_while_it_works() -> None:
    counted = 0
    over = threading.Event()

    def count() -> None:
        nonlocal counted
        while not over.is_set():
            counted += 1
            time.sleep(0.001)

    thread = threading.Thread(target=count)
    thread.start()
    before = counted
    carom.drops(CASE, {"contact.friction": np.full(50_000, 0.15)})
    during = counted - before
    over.set()
    thread.join()
    assert during > 10, "the lock of the interpreter is given up"


@pytest.mark.parametrize("way", ["fork", "spawn"])
def test_processes_get_the_same(way: str) -> None:
    frictions = [{"contact.friction": [0.05] * 100}, {"contact.friction": [0.15] * 100}]
    alone = [carom.drops(CASE, columns).counts() for columns in frictions]
    with multiprocessing.get_context(way).Pool(2) as pool:
        # A function of the package: another process knows no tests.
        found = pool.starmap_async(carom.drops, [(CASE, columns) for columns in frictions]).get(timeout=120)
        assert [table.counts() for table in found] == alone


def test_what_is_sent_to_another_process_is_the_same() -> None:
    scene = carom.Scene.read(CASE).set({"contact.friction": 0.1})
    again = pickle.loads(pickle.dumps(scene))
    assert again.text == scene.text and again.name == "case_2"
    run = carom.run(scene)
    assert pickle.loads(pickle.dumps(run)) == run
    with pytest.raises(carom.CaromError) as caught:
        carom.Scene({"part": {}})
    error = pickle.loads(pickle.dumps(caught.value))
    assert error.problems == caught.value.problems and str(error) == str(caught.value)


def test_a_change_of_an_array_meanwhile_does_no_harm() -> None:
    values = np.full(200_000, 0.15)
    over = threading.Event()

    def change() -> None:
        while not over.is_set():
            values[:] = np.nan
            values[:] = 0.15

    thread = threading.Thread(target=change)
    thread.start()
    try:
        carom.drops(CASE, {"contact.friction": values})
    except carom.CaromError:
        pass  # It was read at a bad moment, and that is told.
    over.set()
    thread.join()
