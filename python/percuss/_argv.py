"""Conversion of keywords to a command line, so that the same code checks both interfaces."""

from __future__ import annotations

import json
import numbers
import os
import sys
from collections.abc import Mapping
from typing import Any

import numpy as np

from . import _percuss
from ._columns import columns_of, columns_text
from ._errors import InputError, UsageError

# Options of the shell only: Python returns results, and save() writes them.
_SHELL_ONLY = {
    "help", "output", "json", "force", "quiet", "example", "example_table", "list", "frf", "modes_file",
}  # fmt: skip

# Options for files and folders that a command writes.
_WRITTEN = {"figures", "blind", "table"}

# Columns of coordinates, as in percuss.Record.
_GEOMETRY_COLUMNS = {2: ("position_m", "angle_deg"), 3: ("x_m", "y_m", "z_m")}

_SIMPLE_TYPES = (str, int, float)  # one value of them needs no conversion
_ENCODING, _ON_ERROR = sys.getfilesystemencoding(), sys.getfilesystemencodeerrors()  # as os.fsencode


class Option:
    """An option, as the command line declares it."""

    def __init__(self, declared: dict[str, Any]) -> None:
        self.flag = declared["name"]
        self.shown = declared["value"]
        self.help = declared["help"]
        self.group = declared["group"]
        self.initial = declared["initial"]
        self.choices = declared["choices"]
        self.requirement = declared["requirement"]
        self.required = declared["required"]
        self.list = declared["list"]
        self.repeatable = declared["repeatable"]
        self.id = self.flag.lstrip("-").replace("-", "_")
        self.keyword = self.id + "_" if self.id == "from" else self.id
        self.is_flag = not self.shown
        self.is_written = self.id in _WRITTEN
        self.is_file = self.shown in ("FILE", "FOLDER") and not self.is_written
        # Whether the option takes a range or, instead, a list: START:STEP:END|POSITION,...
        self.may_be_list = any(":" not in form and form.endswith(",...") for form in self.shown.split("|"))
        self._takes_text = not (self.is_flag or self.is_file or self.is_written)

    def words(self, value: Any, files: MemoryFiles) -> list[str]:
        """The command-line words that set this value; none for None, which means not given."""
        if value is None:
            return []
        if self._takes_text and type(value) in _SIMPLE_TYPES:  # most values: the general way takes several times as long
            return [f"{self.flag}={value!r}" if type(value) is float else f"{self.flag}={value}"]
        if self.is_flag:
            if not isinstance(value, (bool, np.bool_)):
                raise TypeError(f"{self.keyword} must be True or False, not {value!r}")
            return [self.flag] if value else []
        if self.is_written:
            if not isinstance(value, (str, bytes, os.PathLike)):
                raise TypeError(f"{self.keyword} must be the path of a file or folder to write, not {type(value).__name__}")
            return [f"{self.flag}={os.fsdecode(value)}"]
        if self.is_file:
            several = value if self.repeatable and isinstance(value, (list, tuple)) else [value]
            return [f"{self.flag}={files.path(one, self.keyword)}" for one in several]
        return [f"{self.flag}={text}" for text in self._value_texts(value)]

    def _value_texts(self, value: Any) -> list[str]:
        if isinstance(value, dict):
            return [f"{key}={_text(self.keyword, one)}" for key, one in value.items()]
        if isinstance(value, np.ndarray):
            value = value.tolist()
        if not isinstance(value, (list, tuple, range)):
            return [_text(self.keyword, value)]
        is_range = ":" in self.shown and (isinstance(value, tuple) or not self.may_be_list)
        if is_range:  # (60, 3200) becomes 60:3200; a list may hold several ranges
            parts = list(value)
            if self.repeatable and parts and all(isinstance(part, (list, tuple, str)) for part in parts):
                whole = [part if isinstance(part, str) else _joined(self.keyword, part, ":") for part in parts]
                return [",".join(whole)] if self.list else whole
            return [_joined(self.keyword, parts, ":")]
        if self.repeatable and not self.list:
            return [_text(self.keyword, one) for one in value]
        return [_joined(self.keyword, value, ",")] if len(value) else []


def _joined(keyword: str, values: Any, between: str) -> str:
    return between.join(_text(keyword, one) for one in values)


def _text(keyword: str, value: Any) -> str:
    """A number with all its digits; a text unchanged."""
    if isinstance(value, str):
        return value
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    if isinstance(value, (bool, np.bool_)) or not isinstance(value, numbers.Real):
        raise TypeError(f"{keyword} cannot be {type(value).__name__}: give a number, a text or a sequence of them")
    return str(int(value)) if isinstance(value, numbers.Integral) else repr(float(value))


class MemoryFiles:
    """Temporary files in memory for dictionaries, tables and results; closed when the command has run."""

    def __init__(self) -> None:
        self._open: dict[str, tuple[int, str]] = {}
        self.names: dict[str, str] = {}

    def path(self, value: Any, name: str) -> str:
        if isinstance(value, (str, bytes, os.PathLike)):
            return os.fsdecode(value)
        path = self._memory_file(_file_text(value, name), name)
        self.names[path] = self._unique_name(_label(value, name))
        return path

    def _unique_name(self, label: str) -> str:
        """The label, with a number from its second use on."""
        taken = set(self.names.values())
        return label if label not in taken else next(one for i in range(2, len(taken) + 2) if (one := f"{label} ({i})") not in taken)

    def _memory_file(self, text: str, name: str) -> str:
        descriptor = os.memfd_create(f"percuss-{name}", os.MFD_CLOEXEC)
        with open(descriptor, "w", encoding="utf-8", closefd=False) as file:
            file.write(text)
        path = f"/proc/self/fd/{descriptor}"
        self._open[path] = (descriptor, name)
        return path

    def named(self, message: str) -> str:
        """The message with each temporary path replaced by the name of its keyword."""
        for path in sorted(self._open, key=len, reverse=True):
            message = message.replace(path, self._open[path][1])
        return message

    def close(self) -> None:
        for descriptor, _ in self._open.values():
            os.close(descriptor)
        self._open.clear()

    def __bool__(self) -> bool:
        return bool(self._open)


def _label(value: Any, name: str) -> str:
    """A display name for a document: the first file that was read for it, or the kind of result."""
    if not isinstance(value, Mapping):
        return name
    inputs = value.get("inputs")
    if isinstance(inputs, list) and inputs and isinstance(inputs[0], dict) and isinstance(inputs[0].get("path"), str):
        return inputs[0]["path"]
    schema = value.get("schema")
    return schema.split("/")[1].replace("-", " ") if isinstance(schema, str) and schema.count("/") == 2 else name


def _file_text(value: Any, name: str) -> str:
    document = getattr(value, "json", None)
    if isinstance(document, str):
        return document
    columns = columns_of(value, name)
    if columns is not None:
        return columns_text(columns, name)
    if isinstance(value, (dict, list)) and not _is_table(value):
        return json.dumps(value, default=_as_json)
    return _table_text(_table(value, name), name)


def _table(value: Any, name: str) -> np.ndarray:
    """A table of finite numbers."""
    kind = type(value)
    if kind.__module__.startswith("percuss"):
        raise TypeError(f"{name} cannot be a percuss.{kind.__name__}: give the result of percuss.analyze() or percuss.survey() for it")
    try:
        table = np.asarray(value, dtype=float)
    except (TypeError, ValueError):
        raise TypeError(f"{name} cannot be {kind.__name__}: give a path, a result, a dictionary or a table of numbers") from None
    if table.ndim != 2:
        raise TypeError(f"{name} cannot be an array of {table.ndim} dimensions: give a table, one row per line")
    wrong = np.argwhere(~np.isfinite(table))
    if wrong.size:
        row, column = wrong[0].tolist()
        raise InputError(f"a number that is not finite: {table[row, column]}", f"{name}[{row}, {column}]", "give finite numbers")
    return table


def _table_text(table: np.ndarray, name: str) -> str:
    """The table as its reader takes it; a geometry of coordinates as in percuss.Record, its points from 0 up."""
    axes = _GEOMETRY_COLUMNS.get(table.shape[1]) if name == "geometry" else None
    if axes:
        lines = [",".join(("point", *axes))]
        lines += [",".join((str(i), *(repr(one) for one in row))) for i, row in enumerate(table.tolist())]
    else:
        lines = [" ".join(repr(one) for one in row) for row in table.tolist()]
    return "\n".join(lines) + "\n"


def _as_json(value: Any) -> Any:
    """A number or array of NumPy within a document, as JSON has it."""
    if isinstance(value, (np.ndarray, np.generic)):
        return value.tolist()
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    raise TypeError(f"a document cannot hold {type(value).__name__}: give numbers, texts, lists and dictionaries")


def _is_table(value: Any) -> bool:
    return isinstance(value, list) and bool(value) and all(isinstance(row, (list, tuple)) for row in value)


class Command:
    """A command of the tool, with its options by keyword."""

    def __init__(self, declared: dict[str, Any]) -> None:
        self.name = declared["name"]
        self.summary = declared["summary"]
        self.about = declared["about"]
        self.arguments = [word["name"] for word in declared["arguments"]]
        options = [Option(one) for one in declared["options"]]
        self.options = {one.keyword: one for one in options if one.keyword not in _SHELL_ONLY}
        self._required = [one for one in options if one.required]
        shell = {one.keyword for one in options}
        self._first = [word.encode() for word in self.name.split()]
        self._last = [f"--{one}".encode() for one in ("json", "quiet") if one in shell]

    def run(self, function: str, data: Any, inputs: list[Any], options: dict[str, Any]) -> _percuss.CommandResult:
        """Runs the command on paths and documents (`data`), or on records and FRFs in memory (`inputs`)."""
        files = MemoryFiles()
        try:
            words = [word for key, value in options.items() for word in self._option(function, key).words(value, files)]
            for option in self._required:
                if option.keyword not in options:
                    raise UsageError("is missing", f"give {option.shown}", [option.id])
            paths = [files.path(one, self._argument(i, len(data))) for i, one in enumerate(data)]
            given = [word.encode(_ENCODING, _ON_ERROR) for word in words]
            given_paths = [_path_word(path).encode(_ENCODING, _ON_ERROR) for path in paths]
            return _percuss.run([*self._first, *given, *self._last, *given_paths], inputs, list(files.names.items()))
        except InputError as error:
            if not files:
                raise
            raise type(error)(*(files.named(part) if isinstance(part, str) else part for part in error.args)) from None
        finally:
            files.close()

    def _argument(self, index: int, count: int) -> str:
        word = self.arguments[0].lower()
        return word if count == 1 else f"{word} {index + 1}"

    def _option(self, function: str, keyword: str) -> Option:
        if keyword not in self.options:
            raise self.unknown_keyword(function, keyword)
        return self.options[keyword]

    def unknown_keyword(self, function: str, keyword: str) -> TypeError:
        """The error for a keyword that the function does not have, which names the nearest one."""
        near = _percuss.nearest(keyword.replace("_", "-"), [one.flag for one in self.options.values()])
        meant = next((one.keyword for one in self.options.values() if one.flag == near), None)
        hint = f"did you mean {meant!r}?" if meant else f"help(percuss.{function}) lists the keywords"
        return TypeError(f"{function}() has no keyword {keyword!r}; {hint}")


def _path_word(path: str) -> str:
    """The path as a word of a command line that is not taken for an option."""
    return "./" + path if path.startswith("-") and path != "-" else path


def declared() -> dict[str, Command]:
    """All commands by name."""
    return {one["name"]: Command(one) for one in json.loads(_percuss.declared_commands())["commands"] if one["name"]}
