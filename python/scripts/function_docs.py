"""Types and docstrings of the functions, from the declarations of the command line, in the layout of NumPy and SciPy."""

from __future__ import annotations

import re
import textwrap

from function_table import Function
from percuss._argv import Command, Option

WIDTH = 96
_UNITS = {
    "HZ": "Hz", "M": "m", "KG": "kg", "S": "s", "PA": "Pa", "NEWTON": "N", "DEG": "degrees", "DB": "dB", "MPH": "mph", "IN": "in",
    "OZ": "oz", "OZIN2": "oz·in²", "M/S": "m/s", "KG/M": "kg/m", "KG/M3": "kg/m³", "KG*M2": "kg·m²", "N*M2": "N·m²",
    "N*M/RAD": "N·m/rad", "N*S/M": "N·s/m", "N/M^1.5": "N/m^1.5", "RAD/S": "rad/s", "PERCENT": "%", "G": "g", "IN/S2": "in/s²",
    "mV/N": "mV/N", "mV/g": "mV/g", "mV/Pa": "mV/Pa",
}  # fmt: skip
_QUANTITY_UNITS = {"M", "KG", "M/S", "KG*M2"}  # a text may state another unit
# What may stand in place of a file: an array or a dict of columns for a table, a dict or a Result for a document.
_FILES = {
    "bats": "path, array, dict or Result", "compare": "path, dict or Result", "geometry": "path, array or dict",
    "hoop_curve": "path, dict or Result", "logo": "path", "profile": "path, array or dict", "setup": "path or dict",
}  # fmt: skip
# Texts of the command line that are not true in Python.
_IN_PYTHON = {
    " (repeatable)": "", "(repeatable, or a list)": "", " (on standard error, or in the JSON document)": "",
    "; on a terminal also a picture over time": "", "the options under Reading": "the keywords for reading files",
}  # fmt: skip


def _choices(option: Option) -> str:
    return "Literal[" + ", ".join(f'"{one}"' for one in option.choices) + "]"


def alias_of(option: Option) -> str:
    """The name of the type of a list of choices."""
    return "_" + "".join(word.capitalize() for word in option.keyword.split("_")) if option.choices and option.list else ""


def aliases(command: Command) -> list[str]:
    return [f"{alias_of(one)} = {_choices(one)}" for one in command.options.values() if alias_of(one)]


def _unit(option: Option) -> str:
    return option.shown.removesuffix(",...")


def annotation(option: Option) -> str:
    """The type of a keyword, apart from None for not given."""
    if option.is_flag:
        return "bool"
    if option.id == "logo" or option.is_written:
        return "Path"
    if option.is_file:
        return "File | Sequence[File]" if option.repeatable else "File"
    if option.choices:
        return f"{alias_of(option)} | Sequence[{alias_of(option)}]" if option.list else _choices(option)
    if option.requirement.startswith("whole numbers"):
        return "int | str | Sequence[int | str]"
    if option.requirement.startswith("a whole number"):
        return "int | Sequence[int]" if option.list else "int"
    if option.requirement.startswith("a number"):
        if _unit(option) in _QUANTITY_UNITS:
            return "Quantities" if option.list else "Quantity"
        return "Numbers" if option.list else "float"
    if option.shown == "LO:HI":
        return "Band"
    if option.id == "fs":
        return "Rate"
    if option.shown == "NAME":
        return "str | int"
    if "=" in option.shown:
        return "Assignments"
    return "Range" if ":" in option.shown else "Texts" if option.list else "str | Sequence[float]" if "," in option.shown else "str"


def _in_words(option: Option) -> str:
    """The type as the docstring states it."""
    unit = f" in {_UNITS[_unit(option)]}" if _unit(option) in _UNITS else ""
    if option.choices:
        named = "{" + ", ".join(f"'{one}'" for one in option.choices) + "}"
        return f"{named} or a list of them" if option.list else named
    if option.is_file:
        return _FILES[option.id] + (", or a list of them" if option.repeatable else "")
    kind = annotation(option)
    words = {
        "bool": "bool", "Path": "path",
        "int": "int", "int | Sequence[int]": "int or list of int",
        "int | str | Sequence[int | str]": "int, str, or a list of them", "float": "float", "Numbers": "float or list of float", "Quantity": "float",
        "Quantities": "float or list of float", "Band": "(low, high)", "Rate": "float or str", "Assignments": "dict or str", "str": "str", "str | int": "str or int",
        "Texts": "str or list of str", "str | Sequence[float]": "str, float or list of float",
    }  # fmt: skip
    if kind == "Range":
        form = option.shown.removesuffix(",...").split("|")[0].lower().replace("_", " ")
        parts = re.sub(r"\[[a-z]*\]", "", form)  # a unit; Python takes SI units
        several = " or a list of them" if option.repeatable or option.list else " or a list" if option.may_be_list else ""
        return "(" + parts.replace("[:", "[, ").replace(":", ", ") + ")" + several
    return words[kind] + unit


def in_keywords(text: str, command: Command) -> str:
    """The text in the words of Python: `band` for "--band", `percuss.example("info")` for "percuss info --example"."""
    names = {option.flag: f"`{option.keyword}`" for option in command.options.values()}
    names["--example"] = f'`percuss.example("{command.name}")`'
    text = re.sub(r"percuss ([a-z]+) --example", r'`percuss.example("\1")`', text)
    text = re.sub(r" (with )?--json\b", "", text)
    for shown, in_python in _IN_PYTHON.items():
        text = text.replace(shown, in_python)
    return re.sub(r"--[a-z][a-z0-9-]*", lambda match: names.get(match[0], f"`{match[0][2:].replace('-', '_')}`"), text).strip()


def _sentence(text: str) -> str:
    text = " ".join(text.split())
    return text if not text or text.endswith((".", "…")) else text + "."


def _filled(text: str, indent: str = "") -> list[str]:
    return textwrap.wrap(" ".join(text.split()), WIDTH, initial_indent=indent, subsequent_indent=indent, break_long_words=False)


def _entry(name: str, words: str, text: str) -> list[str]:
    return [f"{name} : {words}" if words else name, *_filled(_sentence(text), "    ")]


def _option_entry(option: Option, command: Command) -> list[str]:
    initial = f" Default: {option.initial}." if option.initial else ""
    words = _in_words(option) + ("" if option.required else ", optional")
    return _entry(option.keyword, words, _sentence(in_keywords(option.help, command)) + initial)


def _section(title: str, lines: list[str]) -> list[str]:
    return ["", title, "-" * len(title), *lines] if lines else []


def docstring(function: Function, command: Command) -> list[str]:
    """The lines of the docstring."""
    own: list[str] = []
    for name, _, words, text in function.parts:
        own += _entry(name, words, text)
    reading: list[str] = []
    for option in sorted(command.options.values(), key=lambda one: not one.required):
        into = reading if option.group == "Reading" and function.call == "run_on_data" and option.id != "fs" else own
        into += _option_entry(option, command)
    lines = _filled(_sentence(in_keywords(command.summary, command)))
    about = in_keywords(command.about, command)
    lines += ["", *_filled(about)] if about else []
    lines += _section("Parameters", own)
    lines += _section("Returns", _entry(_RESULTS.get(function.result, function.result), "", function.returns))
    lines += _section("Other Parameters", reading)
    lines += _section("Raises", _entry("InputError", "", "Data that percuss cannot use.") + _entry("UsageError", "", "Invalid values, and keywords that exclude each other.") + _entry("TypeError", "", "Unknown keywords, and values of another type."))  # fmt: skip
    lines += _section("See Also", [f"{name} : {text}" for name, text in function.see_also])
    page = "performance" if command.name.split()[0] in ("metrics", "certify", "abi", "study") else "theory"
    equations = "" if command.name == "info" else f"; docs/theory/{page}.md has the equations"
    source = f"The keywords are the options of `percuss {command.name}`{equations}."
    notes = ([*_filled(function.notes), ""] if function.notes else []) + _filled(
        source if command.name != "read" else "The keywords are the options under Reading of `percuss analyze`."
    )
    lines += _section("Notes", notes)
    return lines + _section("Examples", function.example.strip().splitlines())


_RESULTS = {"Measured": "Record, Frf, or a list of them"}
