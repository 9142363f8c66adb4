"""Writes the classes of answers, `python/carom/answers/*.py`, from the schemas: `python generate.py` writes, `python generate.py check` compares."""

from __future__ import annotations

import json
import keyword
import re
import sys
import textwrap
from pathlib import Path
from typing import Any

HERE = Path(__file__).parent
SCHEMAS = HERE.parent.parent / "schemas"
PLACE = HERE / "python/carom/answers"
#: Which schemas answer, and what their roots are called.
ANSWERS = {
    "run": {"carom run": "Run"},
    "space-run": {"carom run: in space": "SolidRun"},
    "impact": {"ImpactAnswerReport": "PlanarImpact", "SpatialImpactReport": "SpatialImpact"},
    "contact": {"carom contact": "Contact"},
    "roll": {"RollReport": "PlanarRoll", "SpatialRollReport": "SpatialRoll", "PoseReport": "Throws"},
    "yield": {"carom yield": "Yield"},
    "located": {"carom yield --locate": "Located"},
    "design": {"carom design": "Design"},
    "map": {"carom map": "Map"},
    "regions": {"carom regions": "Regions"},
    "feed": {"carom feed": "Feed"},
    "fit": {"carom fit": "Fit"},
    "sweep": {"carom sweep": "Sweep"},
}
#: The module of what several schemas define alike.
SHARED = "shared"
WIDTH = 110


def schema_of(name: str) -> dict[str, Any]:
    root: dict[str, Any] = json.loads((SCHEMAS / f"carom-{name}.schema.json").read_text())
    return root


def referred(node: Any) -> set[str]:
    """The definitions that a schema refers to."""
    if isinstance(node, list):
        return set().union(*map(referred, node))
    if not isinstance(node, dict):
        return set()
    own = {node["$ref"].rsplit("/", 1)[1]} if "$ref" in node else set()
    return own.union(*map(referred, node.values()))


def shared() -> dict[str, Any]:
    """Definitions that several answers have, all alike, and that refer to nothing else."""
    every = [schema_of(name).get("$defs", {}) for name in ANSWERS]
    roots = {root for of in ANSWERS.values() for root in of}
    found: dict[str, Any] = {}
    for name in sorted({name for of in every for name in of} - roots):
        having = [of[name] for of in every if name in of]
        if len(having) > 1 and all(one == having[0] for one in having):
            found[name] = having[0]
    while astray := {name for name, node in found.items() if not referred(node) <= set(found)}:
        found = {name: node for name, node in found.items() if name not in astray}
    return found


def name_of(schema: str, definition: str) -> str:
    """What a definition is called in Python."""
    return ANSWERS.get(schema, {}).get(definition) or definition.removesuffix("Report") or definition


def literal(words: list[Any]) -> str:
    return f"Literal[{', '.join(json.dumps(word, ensure_ascii=False) for word in words)}]"


def kind(schema: str, node: dict[str, Any]) -> str:
    """The Python type of a schema."""
    if "$ref" in node:
        return name_of(schema, node["$ref"].rsplit("/", 1)[1])
    if "const" in node:
        return literal([node["const"]])
    if "enum" in node:
        return " | ".join(filter(None, [literal([w for w in node["enum"] if w is not None]), "None" if None in node["enum"] else ""]))
    for several in ("oneOf", "anyOf"):
        if several in node:
            kinds = [kind(schema, one) for one in node[several]]
            if all(one.startswith("Literal[") for one in kinds):
                return literal(list(dict.fromkeys(word for one in kinds for word in json.loads(f"[{one[8:-1]}]"))))
            return " | ".join(dict.fromkeys(kinds))
    simple = {"string": "str", "integer": "int", "number": "float", "boolean": "bool", "null": "None"}
    types = node.get("type")
    if isinstance(types, list):
        return " | ".join(kind(schema, {**node, "type": one}) for one in types)
    if types == "array":
        return f"list[{kind(schema, node.get('items') or {})}]"
    if types == "object":
        return f"dict[str, {kind(schema, node.get('additionalProperties') or {})}]"
    return simple.get(str(types), "object")


def described(text: str, indent: str) -> list[str]:
    text = re.sub(r"\\", r"\\\\", text.strip())
    wrapped = textwrap.wrap(text, WIDTH - len(indent)) or ["."]
    if len(wrapped) == 1:
        return [f'{indent}"""{wrapped[0]}"""']
    return [f'{indent}"""{wrapped[0]}', *(indent + line for line in wrapped[1:]), f'{indent}"""']


def class_of(schema: str, name: str, node: dict[str, Any], base: str) -> list[str]:
    lines = ["@dataclass(frozen=True, kw_only=True)", f"class {name}{base}:", *described(node.get("description", name), "    "), ""]
    required = set(node.get("required", []))
    for key, value in node.get("properties", {}).items():
        field = key + "_" if keyword.iskeyword(key) else key
        type_ = kind(schema, value)
        if key not in required and "None" not in type_:
            type_ += " | None"
        default = "" if key in required else " = None"
        lines += [f"    {field}: {type_}{default}"]
        if "description" in value:
            lines += described(value["description"], "    ")
    return [*lines, "", ""]


def module(schema: str, common: dict[str, Any]) -> str:
    """The text of a module: of the answers of a command, or of what they share."""
    root = {"$defs": common} if schema == SHARED else schema_of(schema)
    roots = ANSWERS.get(schema, {})
    own = {name: node for name, node in root.get("$defs", {}).items() if schema == SHARED or name not in common}
    about = "What answers of several commands share. Written by `generate.py` from their schemas."
    if schema != SHARED:
        told = "`carom run` of a scene with a solid part" if schema == "space-run" else f"`carom {schema}`"
        about = f"Answers of {told}. Written by `generate.py` from its schema."
    lines = [f'"""{about}"""', "", "from __future__ import annotations", "", "from dataclasses import dataclass", "from typing import Literal", ""]
    if schema != SHARED:
        lines += ["from carom._answer import Answer"]
        outside = referred(own).union(referred(root.get("properties"))) & set(common)
        names = sorted(name_of(schema, name) for name in outside)
        if names:
            lines += [f"from carom.answers.{SHARED} import (", *(f"    {name}," for name in names), ")"]
    lines += ["", ""]
    several: list[str] = []
    for name, node in own.items():
        if "properties" in node:
            lines += class_of(schema, name_of(schema, name), node, "(Answer)" if name in roots else "")
            continue
        alias = [f"{name_of(schema, name)} = {kind(schema, node)}", *described(node.get("description", name), ""), "", ""]
        if kind(schema, node).startswith("Literal["):
            lines += alias
        else:
            # One of several classes: they are known below all of them.
            several += alias
    lines += several
    if "properties" in root:
        lines += class_of(schema, roots[root["title"]], root, "(Answer)")
    return "\n".join(lines).rstrip() + "\n"


def main() -> int:
    PLACE.mkdir(parents=True, exist_ok=True)
    wrong = []
    common = shared()
    for schema in [SHARED, *ANSWERS]:
        name = schema.replace("-", "_")
        place = PLACE / f"{name}_.py" if keyword.iskeyword(name) else PLACE / f"{name}.py"
        text = module(schema, common)
        if sys.argv[1:] == ["check"]:
            if not place.is_file() or place.read_text() != text:
                wrong.append(str(place))
        else:
            place.write_text(text)
    if wrong:
        print("not as the schemas say, run generate.py:", *wrong, sep="\n")
    return bool(wrong)


if __name__ == "__main__":
    sys.exit(main())
