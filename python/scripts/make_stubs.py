#!/usr/bin/env python3
"""Writes type stubs for the functions that are made from the declarations of the commands, for editors.

make_stubs.py [FOLDER]: writes to the folder, by default python/percuss. The tests compare the stubs with the module.
"""

from __future__ import annotations

import inspect
import pathlib
import sys

import percuss
from percuss import _commands, metrics, models
from percuss._argv import Option

_HEAD = """# Made by python/scripts/make_stubs.py from the declarations of the command line.
from os import PathLike
from typing import Any, Literal, Sequence

import numpy as np

_Path = str | PathLike[str]
_File = _Path | dict[str, Any] | Sequence[Any] | np.ndarray | Result
_Text = str | float | tuple[float | str, ...] | Sequence[Any] | dict[str, Any]
_Numbers = float | Sequence[float] | np.ndarray
"""


def type_of(option: Option) -> str:
    """The type of a keyword, apart from None for not given."""
    if option.is_flag:
        return "bool"
    if option.is_file:
        return "_File | list[_File]" if option.repeatable else "_File"
    if option.choices:
        choices = "Literal[" + ", ".join(repr(one) for one in option.choices) + "]"
        return f"{choices} | Sequence[{choices}]" if option.list else choices
    if option.requirement.startswith("a whole number"):
        return "int | Sequence[int]" if option.list else "int"
    if option.requirement.startswith("a number"):
        return "_Numbers" if option.list else "float"
    return "_Text"


def stub(name: str, function: object, command: str, result: str) -> str:
    options = _commands.COMMANDS[command].options
    parts: list[str] = []
    leading = [one for one in inspect.signature(function).parameters.values() if one.name not in options]  # type: ignore[arg-type]
    for one in leading:
        several = one.kind is one.VAR_POSITIONAL
        parts.append(f"*{one.name}: Any" if several else f"{one.name}: _File")
        if not several:
            parts.append("/")
    if not any(part.startswith("*") for part in parts):
        parts.append("*")
    for option in sorted(options.values(), key=lambda one: not one.required):
        kind = type_of(option)
        default = "" if option.required else " = ..."
        parts.append(f"{option.keyword}: {kind if option.required or option.is_flag else kind + ' | None'}{default}")
    return f"def {name}(\n    " + ",\n    ".join(parts) + f",\n) -> {result}: ...\n"


def package_stub() -> str:
    analyses, classes = ["Analysis", "Survey"], ["Deflection", "Nodes", "Result", "Synthetic"]
    text = _HEAD.replace("\n_Path", "\nfrom . import metrics as metrics\nfrom . import models as models\n\n_Path", 1)
    text = text.replace("\nimport numpy as np\n", "\nimport numpy as np\n\nfrom ._commands import compare as compare, "
                        "info as info, write as write\n"
                        "from ._frf import Frf as Frf\n"
                        "from ._examples import example as example, presets as presets\n"
                        "from ._errors import InputError as InputError, NoHitError as NoHitError, UsageError as UsageError\n"
                        "from ._measured import MeasuredFrf as MeasuredFrf\n"
                        "from ._records import Record as Record\n"
                        f"from ._analyses import {', '.join(f'{one} as {one}' for one in analyses)}\n"
                        f"from ._results import {', '.join(f'{one} as {one}' for one in classes)}\n", 1)
    text += "\n__version__: str\n\n"
    text += "\n".join(stub(name, getattr(percuss, name), command, made[1].__name__)
                      for name, made in _commands._SETTINGS.items() for command in [made[0]])
    return text + "\n" + stub("read", percuss.read, "read", "Record | MeasuredFrf | list[Record | MeasuredFrf]")


def module_stub(module: object, commands: dict[str, str]) -> str:
    text = _HEAD.replace("\nimport numpy as np\n", "\nimport numpy as np\n\nfrom ._results import Result\n", 1) + "\n"
    return text + "\n".join(stub(name, getattr(module, name), command, "Result") for name, command in commands.items())


def stubs() -> dict[str, str]:
    """All stubs by file name."""
    return {
        "__init__.pyi": package_stub(),
        "models.pyi": module_stub(models, {name: f"model {name}" for name in models.__all__}),
        "metrics.pyi": module_stub(metrics, {"performance": "metrics", "certify": "certify", "abi": "abi", "study": "study"})
        + "\ndef mac(a: Any, b: Any = ...) -> np.ndarray: ...\n",
    }


if __name__ == "__main__":
    folder = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else pathlib.Path(__file__).parent.parent / "percuss"
    for file_name, content in stubs().items():
        (folder / file_name).write_text(content, encoding="utf-8")
