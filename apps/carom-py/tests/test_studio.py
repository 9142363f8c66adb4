"""The studio in a notebook: what it is given, what it gives back. `notebook.test.mjs` tries its other side in a browser."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import carom
import pytest
from carom import _studio

CASE = "examples/case_2.toml"
BRACKET = "examples/bracket.toml"
BODY = "examples/roll_body.toml"
IMPACT = {"body": {"mass": 1, "inertia": 0.4, "velocity": [0, -2]}, "contact": [{"point": [0, -1], "normal": [0, 1], "friction": 0.3}]}


def test_it_takes_scenes_impacts_and_rolls_as_all_calls_do() -> None:
    read = carom.studio(CASE)
    assert (read.name, read.text, read.files) == ("case_2.toml", Path(CASE).read_text(), {})
    changed = carom.studio(carom.Scene.read(BRACKET).set({"contact.friction": 0.1}), height=500)
    assert (changed.name, list(changed.files), changed.height) == ("bracket.toml", ["bracket.dxf"], 500)
    assert changed.scene["contact.friction"].value == 0.1
    text = carom.studio(Path(CASE).read_text())
    assert text.name == "scene.toml" and text.scene.plates == ["upper", "lower"]
    impact = carom.studio(IMPACT)
    assert carom.impact(impact.text) == carom.impact(IMPACT)
    with pytest.raises(carom.CaromError, match="body"):
        impact.scene


def test_files_that_are_no_text_come_back_byte_for_byte(tmp_path: Path) -> None:
    surface = bytes(range(256)) * 3
    (tmp_path / "part.STL").write_bytes(surface)
    (tmp_path / "throw.toml").write_text('[body]\nfile = "part.STL"\nmass = 1\n')
    studio = carom.studio(tmp_path / "throw.toml")
    assert {name: _studio.content_of(name, text) for name, text in studio.files.items()} == {"part.STL": surface}
    outline = Path("examples/bracket.dxf").read_bytes()
    given = carom.Scene(Path(BRACKET).read_text(), name="mine", files={"bracket.dxf": outline})
    again = carom.studio(given)
    assert again.name == "mine.toml" and again.scene == carom.Scene(given.text, name="mine.toml", files={"bracket.dxf": outline})


def test_text_with_problems_opens_too() -> None:
    for text in ("[part\nshape = 1", "[part]\nshape = 'none'"):
        studio = carom.studio(text)
        assert studio.text == text and studio.files == {}
        with pytest.raises(carom.CaromError):
            studio.scene


def test_another_file_is_shown_at_once() -> None:
    studio = carom.studio(CASE)
    heard: list[str] = []
    studio.observe(lambda change: heard.append(change["name"]), ["name", "text", "files", "height"])
    studio.observe(lambda _: heard.append(studio.scene.name), "text")
    studio.show(BRACKET)
    assert sorted(heard) == ["bracket", "files", "name", "text"]
    assert carom.run(studio.scene) == carom.run(BRACKET)


def test_each_view_that_asks_gets_the_page(monkeypatch: pytest.MonkeyPatch) -> None:
    studio = carom.studio(CASE)
    sent: list[tuple[Any, Any]] = []
    monkeypatch.setattr(studio, "send", lambda content, buffers=None: sent.append((content, buffers)))
    for message in ({"carom": "page"}, {"carom": "other"}, "page", {"carom": "page"}):
        studio._handle_custom_msg(message, [])
    assert [content for content, _ in sent] == [{"carom": "page"}] * 2
    [page] = sent[0][1]
    assert page == _studio.page() and b"carom-host" in page
    assert len(str(studio.get_state())) < 30_000, "the page is no part of a saved notebook"


def test_a_saved_notebook_shows_the_drawing() -> None:
    data, _ = carom.studio(CASE)._repr_mimebundle_()
    assert data["image/svg+xml"] == carom.Scene.read(CASE)._repr_svg_()
    assert data["text/plain"] == "carom.Studio('case_2.toml')"
    assert "image/svg+xml" not in carom.studio(IMPACT)._repr_mimebundle_()[0]


def test_what_is_wrong_is_said(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    wrong: list[tuple[dict[str, Any], str]] = [
        ({"file": "nowhere.toml"}, "there is no such file"),
        ({"file": 3}, "expected a file, a text or a dictionary"),
        ({"file": CASE, "height": 10}, "height: 10 is outside 200 to 4000"),
        ({"file": CASE, "height": "tall"}, "height: expected a whole number"),
    ]
    for given, message in wrong:
        with pytest.raises(carom.CaromError, match=message):
            carom.studio(**given)
    monkeypatch.setattr(_studio, "PAGE", "no-such-page.html")
    with pytest.raises(carom.CaromError, match="built without the studio: `cargo xtask python wheels`"):
        carom.studio(CASE)
