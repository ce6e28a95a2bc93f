"""How keywords become the words of a command line, so that both are understood by the same code."""

from __future__ import annotations

import json
import numbers
import os
import re
from collections.abc import Mapping
from typing import Any

import numpy as np

from . import _percuss

# What a shell needs and Python does not: results are returned, and saved when asked for.
_SHELL_ONLY = {"help", "output", "json", "force", "quiet", "example", "example_table", "list"}


class Option:
    """An option as it was declared for the command line."""

    def __init__(self, declared: dict[str, Any]) -> None:
        self.flag = declared["name"]
        self.shown = declared["value"]
        self.help = declared["help"]
        self.group = declared["group"]
        self.initial = declared["initial"]
        self.choices = declared["choices"]
        self.wanted = declared["wanted"]
        self.required = declared["required"]
        self.list = declared["list"]
        self.repeatable = declared["repeatable"]
        keyword = self.flag.lstrip("-").replace("-", "_")
        self.keyword = keyword + "_" if keyword in ("from", "lambda") else keyword

    @property
    def is_flag(self) -> bool:
        return not self.shown

    @property
    def is_file(self) -> bool:
        return self.shown in ("FILE", "FOLDER")

    def words(self, value: Any, files: MemoryFiles) -> list[str]:
        """The words that give it this value; none for None, which stands for not given."""
        if value is None:
            return []
        if self.is_flag:
            if not isinstance(value, (bool, np.bool_)):
                raise TypeError(f"{self.keyword} is on or off: give True or False, not {value!r}")
            return [self.flag] if value else []
        if self.is_file:
            several = value if self.repeatable and isinstance(value, (list, tuple)) else [value]
            return [f"{self.flag}={files.path(one, self.keyword)}" for one in several]
        return [f"{self.flag}={text}" for text in self._texts(value)]

    def _texts(self, value: Any) -> list[str]:
        if isinstance(value, dict):
            return [f"{key}={_text(self.keyword, one)}" for key, one in value.items()]
        if isinstance(value, np.ndarray):
            value = value.tolist()
        if not isinstance(value, (list, tuple, range)):
            return [_text(self.keyword, value)]
        if ":" in self.shown:  # (60, 3200) is 60:3200, and a list holds several such
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
    """A number with all its digits; a text as it stands."""
    if isinstance(value, str):
        return value
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    if isinstance(value, (bool, np.bool_)) or not isinstance(value, numbers.Real):
        raise TypeError(f"{keyword} cannot be {type(value).__name__}: give a number, a text or a sequence of them")
    return str(int(value)) if isinstance(value, numbers.Integral) else repr(float(value))


def in_python_terms(error: Exception) -> Exception:
    """The error with keywords where the remedy names options that save(), write() and Record() have as such."""
    problem, semicolon, remedy = str(error).rpartition("; ")
    for option, keyword in {"--force": "force=True", "--fs": "fs="}.items():
        remedy = re.sub(option + r"(?![\w-])", keyword, remedy)
    return type(error)(problem + semicolon + remedy)


class MemoryFiles:
    """Dictionaries, tables and results where the command line has files; gone when the command has run."""

    def __init__(self) -> None:
        self._open: dict[str, tuple[int, str]] = {}
        self.names: dict[str, str] = {}

    def path(self, value: Any, name: str) -> str:
        if isinstance(value, (str, bytes, os.PathLike)):
            return os.fsdecode(value)
        path = self._kept(_file_text(value, name), name)
        self.names[path] = self._named_as(_label(value, name))
        return path

    def _named_as(self, label: str) -> str:
        """The label, numbered from the second of its kind on."""
        taken = set(self.names.values())
        return label if label not in taken else next(one for i in range(2, len(taken) + 2) if (one := f"{label} ({i})") not in taken)

    def _kept(self, text: str, name: str) -> str:
        descriptor = os.memfd_create(f"percuss-{name}", os.MFD_CLOEXEC)
        with open(descriptor, "w", encoding="utf-8", closefd=False) as file:
            file.write(text)
        path = f"/proc/self/fd/{descriptor}"
        self._open[path] = (descriptor, name)
        return path

    def named(self, message: str) -> str:
        """A message with the keyword's name where it has a path that nobody has seen."""
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
    """What a document in memory is of: the first file that was read for it, else the kind of result."""
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
    if isinstance(value, (dict, list)) and not _is_table(value):
        return json.dumps(value)
    try:
        table = np.asarray(value, dtype=float)
    except (TypeError, ValueError):
        raise TypeError(f"{name} cannot be {type(value).__name__}: give a path, a dictionary or a table of numbers") from None
    if table.ndim != 2:
        raise TypeError(f"{name} cannot be an array of {table.ndim} dimensions: give a table, one row per line")
    if name == "geometry" and table.shape[1] == 3:
        lines = ["point,x_m,y_m,z_m"]
        lines += [f"{i},{x!r},{y!r},{z!r}" for i, (x, y, z) in enumerate(table.tolist())]
    else:
        lines = [" ".join(repr(one) for one in row) for row in table.tolist()]
    return "\n".join(lines) + "\n"


def _is_table(value: Any) -> bool:
    return isinstance(value, list) and bool(value) and all(isinstance(row, (list, tuple)) for row in value)


class Command:
    """A command of the tool and its options by keyword."""

    def __init__(self, declared: dict[str, Any]) -> None:
        self.name = declared["name"]
        self.summary = declared["summary"]
        self.about = declared["about"]
        self.words = [word["name"] for word in declared["words"]]
        options = [Option(one) for one in declared["options"]]
        self.options = {one.keyword: one for one in options if one.keyword not in _SHELL_ONLY}
        self._shell = {one.keyword for one in options}

    def run(self, function: str, data: Any, inputs: list[Any], options: dict[str, Any]) -> _percuss.CommandResult:
        """Runs it on files (`data`) or on what is in memory (`inputs`)."""
        files = MemoryFiles()
        try:
            words = self.name.split()
            words += [word for key, value in options.items() for word in self._option(function, key).words(value, files)]
            words += [flag for flag in ("--json", "--quiet") if flag[2:] in self._shell]
            for i, one in enumerate(data):
                word = self.words[0].lower()
                words.append(_word(files.path(one, word if len(data) == 1 else f"{word} {i + 1}")))
            return _percuss.run([os.fsencode(word) for word in words], inputs, files.names)
        except _percuss.InputError as error:
            if not files:
                raise
            raise type(error)(files.named(str(error))) from None
        finally:
            files.close()

    def _option(self, function: str, keyword: str) -> Option:
        found = self.options.get(keyword)
        if found is not None:
            return found
        near = _percuss.nearest(keyword.replace("_", "-"), [one.flag for one in self.options.values()])
        meant = next((one.keyword for one in self.options.values() if one.flag == near), None)
        hint = f"did you mean {meant!r}?" if meant else f"help(percuss.{function}) lists them"
        raise TypeError(f"{function}() has no keyword {keyword!r}; {hint}")


def _word(path: str) -> str:
    return "./" + path if path.startswith("-") and path != "-" else path


def declared() -> dict[str, Command]:
    """Every command, by its name."""
    return {one["name"]: Command(one) for one in json.loads(_percuss.declared_commands())["commands"] if one["name"]}
