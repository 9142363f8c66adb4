"""Public data of measured impacts and tosses: where they are, and how they are read.

The data stay the user's copy: :func:`fetch` brings them from where their authors keep them, at one state, and checks every byte.
"""

from __future__ import annotations

import hashlib
import io
import os
import pickle
import struct
import tarfile
import urllib.request
import zlib
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any, BinaryIO, Literal

import numpy as np

from carom.errors import CaromError
from carom.measured.impacts import MeasuredImpacts
from carom.measured.profile import Array
from carom.measured.tosses import MeasuredTosses


@dataclass(frozen=True)
class DataSet:
    """A set of public data."""

    about: str
    """What was measured."""
    source: str
    """Who published it, and where."""
    licence: str
    """Under which terms; where none is stated nothing but reading your own copy is safe."""
    archive: str
    """The archive, at one state."""
    prefix: str
    """What is taken of it."""
    sha256: str
    """Of all files that are taken, in the order of their names: name, length and bytes of each."""


#: The sets that are known.
SETS: dict[str, DataSet] = {
    "cube-tosses": DataSet(
        "570 tosses of an acrylic cube of 104.8 mm, filmed at 148 Hz",
        "Pfrommer, Halm and Posa, ContactNets, CoRL 2020, https://github.com/DAIRLab/contact-nets",
        "BSD-3-Clause",
        "https://codeload.github.com/DAIRLab/contact-nets/tar.gz/c3dc21c94577ff4ed99123f0b00bfe57bb2d1d90",
        "data/",
        "b10ead393c9e27781c94513a5d99f1ee2f5a0cbfe9c89ffcfb1870d3b22e3dd8",
    ),
    "planar-ellipse": DataSet(
        "1718 impacts of an ellipse of 70 by 50 mm that falls in the plane, filmed at 250 Hz",
        "Fazeli, Donlon, Drumwright and Rodriguez, ICRA 2017, https://github.com/mcubelab/planar-impact-dataset",
        "none stated",
        "https://codeload.github.com/mcubelab/planar-impact-dataset/tar.gz/f24a7e3b31ad0b53652d6b2a6b26a702cc4362da",
        "processed_data/data_ellipse.mat",
        "f0e8e4ba6c5bbedcc737321a88b5f3d60b48c79ece1bc9d53b99ab971c0a3331",
    ),
}

#: Half of the cube's width [m]; lengths in the files are in units of it.
HALF_CUBE = 0.0524
#: The rate of the film [1/s].
CUBE_RATE = 148.0


def _taken(name: str, prefix: str) -> bool:
    """Of a set whose prefix is a folder all that is in it, else the one file."""
    return name.startswith(prefix) if prefix.endswith("/") else name == prefix


def digest(folder: Path, prefix: str) -> str:
    """The SHA-256 of all files of a folder whose names begin so: name, length and bytes of each, in the order of their names."""
    found = hashlib.sha256()
    names = sorted(path.relative_to(folder).as_posix() for path in folder.rglob("*") if path.is_file())
    for name in (name for name in names if _taken(name, prefix)):
        content = (folder / name).read_bytes()
        found.update(f"{name}\0{len(content)}\0".encode() + content)
    return found.hexdigest()


def fetch(name: Literal["cube-tosses", "planar-ellipse"], folder: str | os.PathLike[str], *, archive: str | os.PathLike[str] | None = None) -> Path:
    """Brings a set of data into ``folder/name``, unless it is there whole; returns where it is.

    ``archive`` is a copy of the archive (``.tar.gz``) that you have; without it the archive is downloaded from :attr:`DataSet.archive`.

    Raises :class:`CaromError` where there is no such set, the archive cannot be had, or its bytes are not those that were published.
    """
    if name not in SETS:
        raise CaromError(f"{name!r} is none of {', '.join(SETS)}")
    known, place = SETS[name], Path(folder) / name
    if digest(place, known.prefix) == known.sha256:
        return place
    try:
        content = Path(archive).read_bytes() if archive is not None else _downloaded(known.archive)
        with tarfile.open(fileobj=io.BytesIO(content)) as files:
            for member in files.getmembers():
                # The first folder of the archive is named after its state.
                inside = member.name.split("/", 1)[-1]
                if member.isfile() and _taken(inside, known.prefix) and ".." not in inside.split("/"):
                    (place / inside).parent.mkdir(parents=True, exist_ok=True)
                    (place / inside).write_bytes(_content(files, member))
    except (OSError, EOFError, zlib.error, tarfile.TarError) as error:
        raise CaromError(f"{name}: cannot be brought from {archive or known.archive}: {error}") from error
    if digest(place, known.prefix) != known.sha256:
        raise CaromError(f"{name}: what is in {place} is not what was published; remove it and fetch it again")
    return place


def _content(files: tarfile.TarFile, member: tarfile.TarInfo) -> bytes:
    opened = files.extractfile(member)
    return b"" if opened is None else opened.read()


def _downloaded(address: str) -> bytes:
    with urllib.request.urlopen(address, timeout=120) as answer:
        content: bytes = answer.read()
    return content


def cube_tosses(folder: str | os.PathLike[str]) -> MeasuredTosses:
    """The tosses of the cube in a folder that :func:`fetch` returned: mass, inertia and size as published."""
    place = Path(folder) / "data/tosses_processed"
    files = sorted((path for path in place.glob("*.pt") if path.stem.isdigit()), key=lambda path: int(path.stem))
    if not files:
        raise CaromError(f"{place}: there are no tosses")
    states = [_si(_tensor(file)) for file in files]
    # The published moment of inertia, 0.81·10⁻³ kg m², is that of the frame of the cube, not of a full one.
    body = {"box": [2 * HALF_CUBE] * 3, "mass": 0.37, "inertia": [0.00081] * 3}
    return MeasuredTosses(body, 2 * HALF_CUBE, 1 / CUBE_RATE, states)


def _si(rows: Array) -> Array:
    """Poses and velocities in SI: lengths in the files are in half-widths of the cube."""
    states = rows.reshape(-1, rows.shape[-1])[:, :13].copy()
    states[:, :3] *= HALF_CUBE
    states[:, 7:10] *= HALF_CUBE
    return states


class _Reader(pickle.Unpickler):
    """Reads the description of a tensor, and calls nothing that a file names but what is known here."""

    def find_class(self, module: str, name: str) -> Any:
        known: dict[tuple[str, str], Callable[..., Any]] = {
            ("torch._utils", "_rebuild_tensor_v2"): lambda storage, offset, shape, stride, *_: (storage, offset, shape, stride),
            ("collections", "OrderedDict"): dict,
            ("torch", "DoubleStorage"): float,
        }
        if (module, name) not in known:
            raise pickle.UnpicklingError(f"names {module}.{name}")
        return known[module, name]

    def persistent_load(self, pid: Any) -> Any:
        return pid


def _tensor(path: Path) -> Array:
    """The one tensor of a file of PyTorch's old format, of doubles in order."""
    with path.open("rb") as file:
        try:
            return _numbers(file)
        except (pickle.UnpicklingError, EOFError, ValueError, KeyError, IndexError, TypeError, AttributeError, OverflowError, MemoryError, struct.error) as error:
            raise CaromError(f"{path}: is no tensor of doubles: {error}") from error


def _numbers(file: BinaryIO) -> Array:
    # A magic number, the version of the format, the machine; what is stored; the names of the storages; then each, its length before it.
    for _ in range(3):
        _Reader(file).load()
    _, offset, shape, _ = _Reader(file).load()
    _Reader(file).load()
    (length,) = struct.unpack("<q", file.read(8))
    numbers = np.frombuffer(file.read(8 * length), dtype="<f8")
    count = int(np.prod(shape))
    return numbers[offset : offset + count].reshape(shape).astype(np.float64)


def planar_ellipse(folder: str | os.PathLike[str]) -> MeasuredImpacts:
    """The impacts of the ellipse in a folder that :func:`fetch` returned.

    The tangent's lever in the files has the sign opposite to that of the motion that was measured: with it any impulse at the contact leaves 29 % of the motion
    unexplained, with the sign turned round 2.6 % (:meth:`MeasuredImpacts.unexplained`). It is turned round here. Mass and radius of gyration are the published ones. Needs SciPy.
    """
    from carom.measured.profile import optimizer

    optimizer()
    from scipy.io import loadmat

    path = Path(folder) / "processed_data/data_ellipse.mat"
    if not path.is_file():
        raise CaromError(f"{path}: there is no such file")
    try:
        data = loadmat(path)["data"][0, 0]
    except (OSError, KeyError, ValueError) as error:
        raise CaromError(f"{path}: {error}") from error
    before, after, normal, tangent = (np.asarray(data[name], dtype=float) for name in ("states_i", "states_f", "n", "d"))
    mass, gyration = 0.0364, 0.0192
    return MeasuredImpacts(
        mass, mass * gyration**2, np.column_stack([normal[:, 2], tangent[:, 2]]), before[:, 3:5], before[:, 5], after[:, 3:5], after[:, 5], normal[:, :2]
    )
