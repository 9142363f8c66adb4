"""Scenes: a part in the plane or a solid, plates and walls, and where the part starts."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, TypeAlias

from carom import _carom
from carom.errors import CaromError
from carom._given import Values, as_json, as_text, is_path, mapping


@dataclass(frozen=True)
class Quantity:
    """A quantity of a scene."""

    path: str
    """Its name: ``plate.lower.slope``."""
    label: str
    """Its name for people."""
    value: float
    """Its value, SI; the middle of its tolerance."""
    unit: str
    """The SI unit; empty of a plain number."""
    usual_unit: str
    """The unit that drawings use."""
    low: float | None
    """The smallest value that is allowed, SI; None where there is none."""
    high: float | None
    """The largest one."""
    written: bool
    """True where the scene writes it; False for a default."""


class Scene:
    """A scene that was read and checked.

    >>> import carom
    >>> scene = carom.Scene.read("examples/case_2.toml")
    >>> steeper = scene.set({"plate.upper.slope": "12 deg", "contact.friction": 0.1})
    >>> steeper["contact.friction"].value
    0.1
    """

    def __init__(self, text: str | Mapping[str, Any], *, name: str = "scene", files: Mapping[str, bytes] | Mapping[Path, bytes] | None = None) -> None:
        """Reads a scene: its text, or a dictionary with the keys of the file.

        ``files`` holds the files that it names (an outline); without it they are looked for on the disk.

        Raises :class:`CaromError` with every problem of the scene.
        """
        beside = None if files is None else dict(files)
        if isinstance(text, str):
            if is_path(text) and text.endswith(".toml"):
                raise CaromError(f"{text} is the name of a file: Scene.read reads it")
            self._inner = _carom.Scene(text, name, False, beside)
        elif not isinstance(text, Mapping):
            raise CaromError(f"a scene is a text or a dictionary, not {type(text).__name__}: Scene.read reads a file")
        else:
            self._inner = _carom.Scene(as_json(text), name, True, beside)

    @classmethod
    def read(cls, path: str | os.PathLike[str]) -> Scene:
        """Reads a scene's file. Raises :class:`CaromError` with every problem."""
        return cls._of(_carom.Scene.read(os.fspath(path)))

    @classmethod
    def _of(cls, inner: _carom.Scene) -> Scene:
        made = cls.__new__(cls)
        made._inner = inner
        return made

    def set(self, values: Values) -> Scene:
        """The same scene with other values: numbers are SI, text has a unit and may have a tolerance, ``"12 ± 0.5 deg"``.

        All values are written first and checked together then. A number takes a tolerance that was written away.

        Raises :class:`CaromError` with every problem; lines are those of :attr:`text` with the values in it.
        """
        units = {quantity.path: quantity.unit for quantity in self.quantities}
        written = [(path, as_text(path, value, units.get(self._inner.canonical(path), ""))) for path, value in mapping(values, "set").items()]
        return self._of(self._inner.writing(written))

    @property
    def name(self) -> str:
        """Its name: the file's, without folder and ending."""
        return self._inner.name

    @property
    def text(self) -> str:
        """Its text, TOML."""
        return self._inner.text

    @property
    def is_solid(self) -> bool:
        """True where its part is a solid, which moves in space. :func:`carom.feed`, :func:`carom.fit`, :meth:`simulators` and :attr:`layout` are for parts in the plane."""
        return self._inner.is_solid

    @property
    def plates(self) -> list[str]:
        """The names of its plates."""
        return self._inner.plates

    @property
    def quantities(self) -> list[Quantity]:
        """Every quantity, defaults included, in the order of the scene."""
        return [Quantity(**one) for one in json.loads(self._inner.quantities())]

    def __getitem__(self, path: str) -> Quantity:
        known = self._inner.canonical(path)
        found = next((quantity for quantity in self.quantities if quantity.path == known), None)
        if found is None:
            raise KeyError(f"{path} is none of {', '.join(quantity.path for quantity in self.quantities)}")
        return found

    def simulators(self) -> dict[str, str]:
        """The scene for other engines, as texts by the names of their files: ``scene.mjcf.xml`` for MuJoCo, ``part.urdf``, ``plates.urdf`` and the
        meshes of the part for Bullet, Drake and others. What differs from the scene is said at the head of each file.

        >>> import carom
        >>> sorted(carom.Scene.read("examples/case_2_box.toml").simulators())
        ['part-0.obj', 'part.urdf', 'plates.urdf', 'scene.mjcf.xml']
        """
        return self._inner.simulators()

    def __reduce__(self) -> tuple[Any, ...]:
        return (_again, (self.text, self._inner.file, self._inner.files))

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Scene):
            return NotImplemented
        return (self.text, self.name, self._inner.files) == (other.text, other.name, other._inner.files)

    def __hash__(self) -> int:
        return hash((self.text, self.name))

    def __repr__(self) -> str:
        return f"carom.Scene({self.name!r})"

    def _repr_svg_(self) -> str:
        return self._inner.layout()


def _again(text: str, file: str, files: dict[Path, bytes] | None) -> Scene:
    return Scene(text, name=file, files=files)


#: A scene, or what it can be read from: a file, a text, a dictionary with the keys of the file.
SceneLike: TypeAlias = Scene | str | os.PathLike[str] | Mapping[str, Any]


def scene_of(given: SceneLike, values: Values | None = None) -> _carom.Scene:
    """The scene that was given, with other values."""
    if isinstance(given, Scene):
        scene = given
    elif isinstance(given, Mapping):
        scene = Scene(given)
    elif not isinstance(given, str | os.PathLike):
        raise CaromError(f"a scene is a Scene, a file, a text or a dictionary, not {type(given).__name__}")
    elif is_path(given):
        scene = Scene.read(given)
    else:
        scene = Scene(os.fspath(given))
    return (scene.set(values) if values else scene)._inner
