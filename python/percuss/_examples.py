"""Example input files, and the presets of synth()."""

from __future__ import annotations

import json

from . import _percuss
from ._errors import UsageError


def example(name: str) -> str:
    """Return an example of an input file as text.

    Parameters
    ----------
    name : {'synth', 'survey', 'info', 'certify', 'abi', 'metrics', 'study'}
        A spec, a geometry, a channel set-up, a session, a log, a table of readings, a table of bats.

    Returns
    -------
    str
        The text that the command prints as its example.

    Raises
    ------
    UsageError
        Another name.

    Examples
    --------
    >>> import percuss
    >>> percuss.example("survey").splitlines()[0].startswith("#")
    True
    """
    known = ["synth", "survey", "info", "certify", "abi", "metrics", "study"]
    if name not in known:
        near = _percuss.nearest(name, known)
        raise UsageError(f"there is no example '{name}'", f"did you mean {near}?" if near else "give one of " + ", ".join(known))
    return _percuss.run([name.encode(), b"--example"], [], []).document


def presets() -> dict[str, str]:
    """Return the presets of `synth`.

    Returns
    -------
    dict
        A sentence that describes each preset, by its name. `percuss.example("synth")` returns a spec with every key explained.

    Examples
    --------
    >>> import percuss
    >>> "wood-bat" in percuss.presets()
    True
    """
    listed = json.loads(_percuss.run([b"synth", b"--list", b"--json"], [], []).document)
    return {one["name"]: one["description"] for one in listed["presets"]}
