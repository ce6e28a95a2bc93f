"""Signatures and docstrings of the functions, from the declarations of the commands."""

from __future__ import annotations

import inspect
import re
import textwrap
from typing import Any

from ._argv import Command, Option

READS_DATA = {"analyze", "frf", "survey", "nodes", "deflect", "calibrate"}
_DATA = """Data: paths (HDF5, MAT, UFF, LabVIEW, sound, CSV or text); or arrays force and accel with fs=, in the shapes that
percuss.Record accepts; or Records. Arrays are not copied: do not change them before the function returns, or while the
result still computes. Python's lock is released during the call.
"""
_VALUES = """Keywords are numbers or texts, in the unit in brackets. LO:HI is a tuple, such as band=(60, 3200); a list is any
sequence; FILE is a path or, if it holds numbers or JSON, an array, a dictionary or a result. None means not given.
"""
_WIDTH = 100


def _wrapped(text: str) -> str:
    return textwrap.fill(" ".join(text.split()), _WIDTH)


def _in_keywords(text: str, command: Command) -> str:
    """The text in the words of Python: "band=" for "--band", "percuss.example('info')" for "percuss info --example"."""
    names = {option.flag: f"{option.keyword}=" for option in command.options.values()}
    names["--example"] = f"percuss.example('{command.name}')"
    text = re.sub(r"percuss ([a-z]+) --example", r"percuss.example('\1')", text)
    return re.sub(r"--[a-z][a-z0-9-]*", lambda match: names.get(match[0], match[0]), text)


def _default(option: Option) -> Any:
    return False if option.is_flag else None


def signature(command: Command, leading: list[inspect.Parameter]) -> inspect.Signature:
    """The signature of a command's function: `leading`, then its options as keywords."""
    keyword = inspect.Parameter.KEYWORD_ONLY
    options = sorted(command.options.values(), key=lambda one: not one.required)
    empty = inspect.Parameter.empty
    return inspect.Signature(
        leading + [inspect.Parameter(one.keyword, keyword, default=empty if one.required else _default(one)) for one in options]
    )


def _option_doc(option: Option, command: Command) -> str:
    choices = ": " + ", ".join(option.choices) if option.choices and option.list else ""
    initial = f" (default: {option.initial})" if option.initial else ""
    shown = f" [{option.shown}]" if option.shown else ""
    text = _in_keywords(f"{option.help}{choices}{initial}", command)
    return textwrap.fill(f"{option.keyword}{shown}  {text}", _WIDTH, initial_indent="    ", subsequent_indent=" " * 8)


def docstring(command: Command, intro: str, example: str) -> str:
    """The docstring of a command's function. `intro` describes its data and result."""
    parts = [_in_keywords(text, command) for text in (command.summary + ".", textwrap.fill(command.about, _WIDTH), _wrapped(intro))]
    if command.name in READS_DATA:
        parts.append(_wrapped(_DATA))
    groups: dict[str, list[str]] = {}
    for option in command.options.values():
        groups.setdefault(_in_keywords(option.group, command) or "Keywords", []).append(_option_doc(option, command))
    parts.append(_wrapped(_VALUES))
    parts += [f"{group}:\n" + "\n".join(lines) for group, lines in groups.items()]
    parts.append(
        _wrapped(
            "Raises InputError for unusable data, UsageError for invalid values and contradictory keywords, TypeError for "
            "unknown keywords and values of another type."
        )
    )
    parts.append(f"Source: percuss {command.name}; docs/theory/theory.md has the equations.")
    if example:
        parts.append(example.strip())
    return "\n\n".join(part for part in parts if part)
