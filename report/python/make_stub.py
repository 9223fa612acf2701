"""Writes luxgate/__init__.pyi: the types of everything that the module offers. Parts of results come from the JSON schema
of results, keywords from the option table, names of verdicts from theirs.

    make_stub.py FILE    with the module in PYTHONPATH
"""
import inspect
import json
import re
import sys

sys.path.pop(0)  # this folder, whose luxgate/ has no compiled half
import luxgate
from luxgate import _parts, _settings

SCHEMA = json.loads(luxgate.schema("result"))
# What classes have besides the keys of the file; keys of the same name are replaced by it.
EXTRA = {
    "Finding": {"project": ("str", "Path of the project."), "space": ("str", "Id."), "plane": ("str", "Id."),
                "words": ("str", "What is required of the plane, in words: 'average'."),
                "outcome": ("Outcome", "What it comes to: waived, nothing-asked where it does not count, or the verdict.")},
    "Aggregate": {"outcome": ("Outcome", "What it comes to, see Finding.")},
    "Project": {"outcome": ("Outcome", "What the project comes to.")},
    "Message": {"formatted": ("str", "One line: place, severity, id and text.")},
    "Plane": {"space": ("str", "Id."), "unit": ("str", "Of its values; '' where they have none.")},
}
PROPERTIES = {
    "Message": {"file": ("str", ""), "line": ("int", "From 1; 0: not known."), "column": ("int", "Likewise."),
                "text": ("str", "Without place, severity and id.")},
    "Plane": {"points": ("_Array", "(N, 3), m: x, y, z."), "normals": ("_Array", "(N, 3): where the points look."),
              "cells": ("_Array", "(N, 2): column and row of the grid."), "values": ("_Array", "(N,), maintained, in unit."),
              "low": ("_Array", "(N,): lower ends of the intervals; -inf: open."),
              "high": ("_Array", "(N,): upper ends; inf: open."),
              "direct_lx": ("_Array", "(N,), maintained, without reflections."),
              "indirect_lx": ("_Array", "(N,): the reflected part.")},
}
classes = {}


def quoted(words):
    return '"""' + words.replace("\\", "\\\\").replace('"', "'") + '"""'


def optional(name):
    return name if name.endswith("None") or name == "Any" else f"{name} | None"


def type_of(schema, name):
    """A type; objects without a name of their own become classes of this one."""
    if "$ref" in schema:
        definition = schema["$ref"].rsplit("/", 1)[1]
        found = SCHEMA["definitions"][definition]
        if found.get("type") == "object":
            return add_class(definition, found)
        return type_of(found, name)
    if "oneOf" in schema:
        kinds = [type_of(one, name) for one in schema["oneOf"] if one.get("type") != "null"]
        return optional(" | ".join(dict.fromkeys(kinds)))
    if "const" in schema:
        return type(schema["const"]).__name__
    if "enum" in schema:
        return of_choices(schema["enum"])
    kind = schema.get("type")
    if isinstance(kind, list):
        return optional(type_of({**schema, "type": next(one for one in kind if one != "null")}, name))
    if kind == "array":
        return of_list(schema, name)
    if kind == "object":
        return add_class(name, schema)
    return {"string": "str", "integer": "int", "number": "float", "boolean": "bool"}.get(kind, "Any")


def of_choices(choices):
    if any(isinstance(choice, list) for choice in choices):
        return "tuple[str, ...]"
    for cls in (luxgate.Verdict, luxgate.Outcome):
        if set(choices) == {member.value for member in cls}:
            return cls.__name__
    return "Literal[" + ", ".join(json.dumps(choice) for choice in choices) + "]"


def of_list(schema, name):
    items = schema["items"]
    if isinstance(items, list):
        return "tuple[" + ", ".join(type_of(item, name) for item in items) + "]"
    if schema.get("minItems") is not None and schema.get("minItems") == schema.get("maxItems"):
        return "tuple[" + ", ".join([type_of(items, name)] * schema["minItems"]) + "]"
    inner = items if "$ref" not in items else SCHEMA["definitions"][items["$ref"].rsplit("/", 1)[1]]
    of_inner = inner.get("items", {})
    is_pair = inner.get("minItems") == 2 and isinstance(of_inner, dict) and of_inner.get("type") == "number"
    is_table = name.endswith("_rows")
    if items.get("type") == "number" or is_pair or is_table:
        return "_Array"
    return f"tuple[{type_of(items, name)}, ...]"


def add_class(name, schema):
    title = _parts.class_name(name)
    if title in classes:
        return title
    classes[title] = ""  # it is being made: parts may hold their like
    required = set(schema.get("required", []))
    either = {key for option in schema.get("anyOf", []) for key in option.get("required", [])}
    then = set(schema.get("then", {}).get("required", []))
    own = {}
    for key, one in schema.get("properties", {}).items():
        kind = type_of(one, f"{name}_{key}")
        is_mark = one.get("const") is True
        if is_mark:
            kind = "bool"
        is_list = kind == "_Array" or kind.startswith("tuple[") and kind.endswith(", ...]")
        # Also what results of earlier versions lack: the schema does not tell these apart.
        if key not in required | either | then and not is_list and not is_mark:
            kind = optional(kind)
        own[_parts.attribute_name(key)] = (kind, one.get("description", ""))
    own.update(EXTRA.get(title, {}))
    lines = [f"class {title}(Part):"]
    if schema.get("description"):
        lines.append("    " + quoted(schema["description"]))
    for key, (kind, words) in {**own, **PROPERTIES.get(title, {})}.items():
        lines.append(f"    @property\n    def {key}(self) -> {kind}: " + (quoted(words) if words else "..."))
    if title == "Plane":
        lines.append("    def image(self, values: Any = ...) -> _Array:\n        "
                     + quoted("Values, or others of the points, as (rows, columns), the first row at the smallest v; "
                              "nan where there is no point."))
    if len(lines) == 1:
        lines.append("    ...")
    classes[title] = "\n".join(lines)
    return title


def enum(cls):
    members = "\n".join(f"    {member.name} = {json.dumps(member.value)}" for member in cls)
    return f"class {cls.__name__}(str, enum.Enum):\n    {quoted(cls.__doc__)}\n{members}\n"


def keywords(use):
    kinds = []
    for keyword, (_, value_name, _, is_flag, may_have_value, repeats) in _settings.offered(use).items():
        one = "str | float | os.PathLike[str]"
        kind = ("bool" if is_flag else "bool | str | Iterable[str]" if may_have_value
                else f"{one} | Iterable[{one}] | Mapping[str, {one} | bool]" if repeats else one)
        kinds.append(f"{keyword}: {kind} | None = ...")
    return ",\n    ".join(kinds)


def result_class():
    types = {"verdict": "Outcome", "exit_code": "int", "project": "Project", "projects": "tuple[Project, ...]",
             "provenance": "Provenance", "counts": "Counts", "spaces": "tuple[Space, ...]", "planes": "tuple[Plane, ...]",
             "findings": "tuple[Finding, ...]", "aggregates": "tuple[Aggregate, ...]",
             "luminaires": "tuple[Luminaire, ...]", "messages": "tuple[Message, ...]"}
    lines = [f"class Result:\n    {quoted(luxgate.Result.__doc__)}"]
    for key, kind in types.items():
        lines.append(f"    @property\n    def {key}(self) -> {kind}: {quoted(getattr(luxgate.Result, key).__doc__)}")
    named = {name for name, value in vars(luxgate.Result).items() if isinstance(value, property)} - {"_all"}
    if named != set(types):
        sys.exit(f"make_stub.py: types of {named ^ set(types)} are needed")
    style = re.sub(r"\n    ", "\n        ", keywords("write"))
    formats = "Literal[" + ", ".join(json.dumps(name) for name in luxgate.formats()) + "]"
    lines.append(f"    def render(self, format: {formats}, *,\n        {style}) -> str: ...")
    lines.append(f"    def write(self, format: {formats}, path: str | os.PathLike[str], *,\n        {style}) -> None: ...")
    lines.append("    def to_json(self) -> str: ...")
    lines.append("    def __bool__(self) -> NoReturn: ...")
    return "\n".join(lines) + "\n"


def main():
    add_class("document", SCHEMA)
    path = "path: str | os.PathLike[str], *,\n    "
    parts = [
        "# Written by make_stub.py.\n" + "import enum\nimport os\n"
        "from collections.abc import Iterable, Mapping\nfrom typing import Any, Literal, NoReturn\n\n"
        "import numpy\nimport numpy.typing\n\n_Array = numpy.typing.NDArray[Any]\n"
        "version: str\n__version__: str\nnumbers_version: int\n",
        enum(luxgate.Verdict), enum(luxgate.Outcome),
        f"class Part:\n    {quoted(luxgate.Part.__doc__)}\n    def to_dict(self) -> dict[str, Any]: ...\n",
        *(text + "\n" for text in classes.values()),
        f"class Error(Exception):\n    {quoted(luxgate.Error.__doc__)}\n",
        f"class SettingError(Error, ValueError):\n    {quoted(luxgate.SettingError.__doc__)}\n",
        f"class CheckError(Error):\n    {quoted(luxgate.CheckError.__doc__)}\n    messages: tuple[Message, ...]\n"
        "    result: Result | None\n",
        result_class(),
        f"def check({path}{keywords('check')}) -> Result: ...\n",
        f"def validate({path}{keywords('validate')}) -> tuple[Message, ...]: ...\n",
        "def read(path: str | os.PathLike[str]) -> Result: ...\n",
        "def formats() -> tuple[str, ...]: ...\n",
        'def schema(of: Literal["project", "result"] = ...) -> str: ...\n',
    ]
    with open(sys.argv[1], "w", encoding="utf-8") as file:
        file.write("\n".join(parts))


if __name__ == "__main__":
    main()
