#!/usr/bin/env python3
"""Doxygen's input filter: prints a header with percuss's comments in Doxygen's form.

The first comment describes the file, and a comment beside a member describes that member. The labels errors, shapes,
units and source begin a new paragraph. A line that ends with an equation's number stays verbatim. Sphinx cannot parse
designated initialisers, so a default with them moves into the comment.
"""

import re
import sys

_LABEL = re.compile(r"(?:(?<=[.;:)] )|(?<=/// ))(errors|shapes|units|source)  +")
_EQUATION = re.compile(r"\s*///  +(\S.*\(\d+\))$")
_BESIDE = re.compile(r"^(\s*[^\s/].*?[;,{}])( +)// (.*)$")
_DESIGNATED = re.compile(r"(?m)^(?!\s*//)(\s+[^\n(){}]*\w)(?: = )?(\{[^;]*?\.\w+ = [^;]*\});(?: +// (.*))?$")


def _default_as_comment(found):
    default = "default: " + " ".join(found[2].split())
    return f"{found[1]};  // " + (f"{found[3]}; {default}" if found[3] else default)


def _comment(line, in_code):
    if in_code:
        return line
    equation = _EQUATION.match(line)
    if equation:
        return f"/// @verbatim\n/// {equation[1]}\n/// @endverbatim"
    return _LABEL.sub(lambda found: f"\n/// @par {found[1].capitalize()}\n/// ", line)


def filtered(text):
    out, in_code, described = [], False, False
    for line in _DESIGNATED.sub(_default_as_comment, text).splitlines():
        if line.lstrip().startswith("///"):
            if not described:
                out.append("/// @file")
            described = True
            in_code = "@code" in line or (in_code and "@endcode" not in line)
            out.append(_comment(line, in_code))
        else:
            described = described or line.startswith("namespace")
            beside = _BESIDE.match(line)
            out.append(f"{beside[1]}{beside[2]}///< {beside[3]}" if beside else line)
    return "\n".join(out) + "\n"


sys.stdout.write(filtered(open(sys.argv[1], encoding="utf-8").read()))
