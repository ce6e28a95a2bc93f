"""Example input files, and the presets of synth()."""

from __future__ import annotations

import json

from . import _percuss
from ._errors import UsageError


def example(name: str) -> str:
    """Return an example of an input file as text.

    name  "synth": a spec; "survey": a geometry; "info": a channel set-up; "certify": a session; "abi": a log;
          "metrics": a table of readings; "study": a table.

    Returns the text that the command prints with --example. Raises UsageError for other names.

    >>> import percuss
    >>> percuss.example("survey").splitlines()[0].startswith("#")
    True
    """
    known = ["synth", "survey", "info", "certify", "abi", "metrics", "study"]
    if name not in known:
        near = _percuss.nearest(name, known)
        raise UsageError(f"there is no example '{name}'", f"did you mean {near}?" if near else "give one of " + ", ".join(known))
    return _percuss.run([name.encode(), b"--example"], []).document


def presets() -> dict[str, str]:
    """Return the presets of synth().

    Returns a dictionary from each preset's name to a sentence that describes it. percuss.example("synth") returns a spec
    with every key explained. Raises nothing.

    >>> import percuss
    >>> "wood-bat" in percuss.presets()
    True
    """
    listed = json.loads(_percuss.run([b"synth", b"--list", b"--json"], []).document)
    return {one["name"]: one["description"] for one in listed["presets"]}
