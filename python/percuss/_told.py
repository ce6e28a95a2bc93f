"""Signatures and docstrings of the functions, from what the commands declare."""

from __future__ import annotations

import inspect
import textwrap
from typing import Any

from ._words import Command, Option

_DATA = """Data: paths (HDF5, MAT, UFF, LabVIEW, sound, CSV or text); or arrays, force and accel, with fs=, of the shapes
that percuss.Record tells; or Records. Arrays are read where they lie, without a copy: leave them alone until the
function returns, and with the result as long as it is asked for more. Python's lock is released meanwhile.
"""
READS_DATA = {"analyze", "frf", "survey", "nodes", "deflect", "calibrate"}


_VALUES = """Keywords are numbers or texts, in the unit that stands in brackets; LO:HI is a tuple, as band=(60, 3200), a list any
sequence, FILE a path or, where it holds numbers or JSON, an array, a dictionary or a result. None is as not given.
"""
_WIDTH = 100


def _wrapped(text: str) -> str:
    return textwrap.fill(" ".join(text.split()), _WIDTH)


def _default(option: Option) -> Any:
    return False if option.is_flag else None


def signature(command: Command, leading: list[inspect.Parameter]) -> inspect.Signature:
    keyword = inspect.Parameter.KEYWORD_ONLY
    options = sorted(command.options.values(), key=lambda one: not one.required)
    empty = inspect.Parameter.empty
    return inspect.Signature(
        leading + [inspect.Parameter(one.keyword, keyword, default=empty if one.required else _default(one)) for one in options]
    )


def _option_doc(option: Option) -> str:
    choices = ": " + ", ".join(option.choices) if option.choices and option.list else ""
    initial = f" (default: {option.initial})" if option.initial else ""
    shown = f" [{option.shown}]" if option.shown else ""
    return textwrap.fill(
        f"{option.keyword}{shown}  {option.help}{choices}{initial}", _WIDTH, initial_indent="    ", subsequent_indent=" " * 8
    )


def docstring(command: Command, intro: str, example: str) -> str:
    parts = [command.summary + ".", textwrap.fill(command.about, _WIDTH), _wrapped(intro)]
    if command.name in READS_DATA:
        parts.append(_wrapped(_DATA))
    groups: dict[str, list[str]] = {}
    for option in command.options.values():
        groups.setdefault(option.group or "Keywords", []).append(_option_doc(option))
    parts.append(_wrapped(_VALUES))
    parts += [f"{group}:\n" + "\n".join(lines) for group, lines in groups.items()]
    parts.append(
        _wrapped(
            "Raises InputError for unusable data, UsageError for values that cannot be, in the words of the command line; "
            "TypeError for keywords that do not exist."
        )
    )
    parts.append(f"Source: percuss {command.name}; docs/theory/theory.md has the equations.")
    if example:
        parts.append(example.strip())
    return "\n\n".join(part for part in parts if part)
