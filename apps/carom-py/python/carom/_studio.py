"""The studio in a notebook."""

from __future__ import annotations

import os
import tomllib
from importlib.resources import files as packaged
from pathlib import Path
from typing import Any

import anywidget
import traitlets

from carom import _carom
from carom._given import FileLike, read, within
from carom.errors import CaromError, Problem
from carom.scene import Scene

#: The page, which `cargo xtask python wheels` puts into the package.
PAGE = "carom-studio.html"
#: Heights that a cell of a notebook may have [px].
LOWEST, HIGHEST = 200, 4000


def page() -> bytes:
    """The studio's page, one file."""
    file = packaged("carom") / PAGE
    try:
        return file.read_bytes()
    except FileNotFoundError:
        message = "this carom was built without the studio: `cargo xtask python wheels` in the sources builds a wheel that has it (Rust and Node.js)"
        raise CaromError(message, [Problem(message, kind="missing_package", value=PAGE)]) from None


def drawn_by(text: str, beside: Path) -> dict[str, str]:
    """The files that a text names, as the page takes them."""
    try:
        tables = tomllib.loads(text).values()
    except tomllib.TOMLDecodeError:
        # The page shows what is wrong with the text.
        return {}
    names = [table["file"] for table in tables if isinstance(table, dict) and isinstance(table.get("file"), str)]
    found = {name: beside / name for name in names}
    return {name: letters(name, file.read_bytes()) for name, file in found.items() if file.is_file()}


def coding(name: str) -> str:
    """How the page writes the bytes of a file as text: a surface is no text, and has a letter for each byte."""
    return "latin-1" if name.lower().endswith(".stl") else "utf-8"


def letters(name: str, content: bytes) -> str:
    """A file as the page takes it."""
    return content.decode(coding(name), "replace")


def content_of(name: str, text: str) -> bytes:
    """The file again."""
    return text.encode(coding(name), "replace")


def named(file: str) -> str:
    """The name of a file for the page, without its folder."""
    name = Path(file).name
    return name if name.endswith(".toml") else f"{name}.toml"


def taken(given: FileLike | Scene) -> dict[str, Any]:
    """What was given as the page takes it: name, text, and the files that the text names."""
    if isinstance(given, Scene):
        inner = given._inner
        beside = inner.files
        files = drawn_by(given.text, Path(inner.file).parent) if beside is None else {os.fspath(name): letters(os.fspath(name), content) for name, content in beside.items()}
        return {"name": named(inner.file), "text": given.text, "files": files}
    file, text, json = read(given, "scene")
    text = _carom.toml_of_json(file, text) if json else text
    return {"name": named(file), "text": text, "files": drawn_by(text, Path(file).parent)}


class Studio(anywidget.AnyWidget):
    """The studio in a cell of a notebook, with a file that both sides change: :func:`carom.studio` makes one."""

    _esm = Path(__file__).parent / "studio.js"

    name = traitlets.Unicode("scene.toml").tag(sync=True)
    """The name of the file."""
    text = traitlets.Unicode("").tag(sync=True)
    """Its text, as it is in the page now; a new one is shown there. ``observe(function, "text")`` hears of every change."""
    files = traitlets.Dict(value_trait=traitlets.Unicode(), key_trait=traitlets.Unicode()).tag(sync=True)
    """The files that the text names, as :meth:`show` read them. A text that names others needs :meth:`show`."""
    height = traitlets.Int(640, min=LOWEST, max=HIGHEST).tag(sync=True)
    """Its height [px]."""

    def __init__(self, file: FileLike | Scene, *, height: int = 640) -> None:
        self._page = page()
        super().__init__(**taken(file), height=within("height", height, LOWEST, HIGHEST))
        self.on_msg(self._asked)

    def _asked(self, _: object, message: object, buffers: object) -> None:
        if message == {"carom": "page"}:
            self.send({"carom": "page"}, buffers=[self._page])

    def show(self, file: FileLike | Scene) -> None:
        """Opens another file in it."""
        # Who observes one of the three sees all of them new, and the page gets one message.
        with self.hold_sync(), self.hold_trait_notifications():
            for key, value in taken(file).items():
                setattr(self, key, value)

    @property
    def scene(self) -> Scene:
        """The scene as it is in the page now, for :func:`carom.run` and the other studies.

        Raises :class:`CaromError` where the text is that of an impact or a roll, or has problems.
        """
        contents = {name: content_of(name, text) for name, text in self.files.items()}
        return Scene(self.text, name=self.name, files=contents or None)

    def __repr__(self) -> str:
        return f"carom.Studio({self.name!r})"

    def _repr_mimebundle_(self, **kwargs: Any) -> Any:
        """The widget; where none can be shown, a saved notebook say, the drawing of the scene."""
        bundle = super()._repr_mimebundle_(**kwargs)
        try:
            drawing = self.scene._repr_svg_()
        except CaromError:
            return bundle
        if bundle is not None:
            bundle[0]["image/svg+xml"] = drawing
        return bundle
