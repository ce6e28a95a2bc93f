#!/usr/bin/env python3
"""Writes the functions of the package from the declarations of the command line: python/percuss/_functions.

make_functions.py [FOLDER]: writes to the folder, by default python/percuss/_functions. The tests compare the files with the
declarations.
"""

from __future__ import annotations

import importlib.util
import pathlib
import re
import sys
import textwrap
import types

if "percuss" not in sys.modules:  # imports the declarations alone, since the functions may be missing or out of date
    _found = importlib.util.find_spec("percuss")
    sys.modules["percuss"] = types.ModuleType("percuss")
    sys.modules["percuss"].__path__ = _found.submodule_search_locations

from function_docs import aliases, annotation, docstring
from function_table import FUNCTIONS, Function
from percuss._argv import Command, declared

_HEAD = "# Made by python/scripts/make_functions.py from the declarations of the command line. Do not edit.\n"
_TYPES = ("Assignments", "Band", "Data", "File", "Measured", "Numbers", "Path", "Paths", "Quantities", "Quantity", "Range", "Rate", "Texts")
_WIDTH = 120


def module_name(function: Function) -> str:
    return function.name.replace(".", "_")


def _parameters(function: Function, command: Command) -> list[str]:
    parts = [f"{name}: {kind}" for name, kind, _, _ in function.parts]
    if not any(part.startswith("*") for part in parts):
        parts += ["/", "*"] if parts else ["*"]
    for option in sorted(command.options.values(), key=lambda one: not one.required):
        kind = annotation(option)
        parts.append(f"{option.keyword}: {kind} = False" if option.is_flag else
                     f"{option.keyword}: {kind}" if option.required else f"{option.keyword}: {kind} | None = None")  # fmt: skip
    return parts


def _call(function: Function, command: Command) -> str:
    names = [name.lstrip("*") for name, _, _, _ in function.parts]
    variadic = any(name.startswith("*") for name, _, _, _ in function.parts)
    given = names[0] if variadic else "(" + "".join(f"{name}, " for name in names).strip() + ")"
    pairs = " ".join(f'"{one.keyword}":\xa0{one.keyword},' for one in command.options.values())
    keywords = "\n".join(textwrap.wrap(pairs, _WIDTH - 8, initial_indent=" " * 8, subsequent_indent=" " * 8)).replace("\xa0", " ")
    made = f'{function.call}("{function.name}", "{function.command}", {given}, {{\n{keywords}\n    }})'
    if function.call in ("read_files", "synthesise_spec"):  # these functions make the result themselves
        return made
    return f"{function.result}({made}{', kind=kind' if function.name == 'frf' else ''})"


def module_text(function: Function, command: Command) -> str:
    """The source of a function."""
    body = "\n".join(f"    {line}".rstrip() for line in docstring(function, command))
    parameters = "".join(f"    {one},\n" for one in _parameters(function, command))
    name = function.name.rpartition(".")[2]
    code = (
        f'@command_function("{function.name}", "{function.command}")\n'
        f'def {name}(\n{parameters}) -> {function.result}:\n    """{body.lstrip()}\n    """\n    return {_call(function, command)}\n'
    )
    signature = code.partition('"""')[0]
    types = [one for one in _TYPES if re.search(rf"\b{one}\b", signature)]
    typing = [one for one in ("Literal", "Sequence") if one in signature or one == "Literal" and aliases(command)]
    imports = sorted([f"from .._call import command_function, {function.call}", *function.imports]
                     + ([f"from .._types import {', '.join(types)}"] if types else []))  # fmt: skip
    text = _HEAD + "from __future__ import annotations\n\n"
    text += f"from typing import {', '.join(typing)}\n\n" if typing else ""
    text += "\n".join(imports) + "\n\n"
    text += "".join(f"{one}\n" for one in aliases(command)) + ("\n" if aliases(command) else "")
    return text + "\n" + code


def modules() -> dict[str, str]:
    """All sources by file name."""
    commands = declared()
    made = {f"{module_name(one)}.py": module_text(one, commands[one.command]) for one in FUNCTIONS}
    made["__init__.py"] = _HEAD + '"""The functions of the package, a file for each."""\n'
    return made


if __name__ == "__main__":
    folder = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else pathlib.Path(__file__).parent.parent / "percuss" / "_functions"
    folder.mkdir(exist_ok=True)
    for file_name, content in modules().items():
        (folder / file_name).write_text(content, encoding="utf-8")
