"""What the tool has to start from."""

from __future__ import annotations

import json

from . import _percuss


def example(name: str) -> str:
    """A text to start from.

    name  "synth" a spec, "survey" a geometry, "info" a channel set-up, "certify" a session,
          "abi" a log, "study" a table.

    Returns what the command prints with --example. Raises UsageError for other names.

    >>> import percuss
    >>> percuss.example("survey").splitlines()[0].startswith("#")
    True
    """
    known = ["synth", "survey", "info", "certify", "abi", "study"]
    if name not in known:
        near = _percuss.nearest(name, known)
        raise _percuss.UsageError(f"no example of '{name}'; " + (f"did you mean {near}?" if near else "give one of " + ", ".join(known)))
    return _percuss.run([name.encode(), b"--example"], []).document


def presets() -> dict[str, str]:
    """The names that synth() knows.

    Returns a dictionary: each name, and what is made by it in a sentence. percuss.example("synth") is a spec with every
    key, explained, to make others from. Raises nothing.

    >>> import percuss
    >>> "wood-bat" in percuss.presets()
    True
    """
    listed = json.loads(_percuss.run([b"synth", b"--list", b"--json"], []).document)
    return {one["name"]: one["description"] for one in listed["presets"]}
