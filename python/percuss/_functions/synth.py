# Made by python/scripts/make_functions.py from the declarations of the command line. Do not edit.
from __future__ import annotations

from .._call import command_function, synthesise_spec
from .._results import Synthetic
from .._types import File


@command_function("synth", "synth")
def synth(
    spec: File,
    /,
    *,
    seed: int | None = None,
    threads: int | None = None,
) -> Synthetic:
    """Make synthetic test records with exactly known truth.

    Makes hammer tests of structures with exactly known modes, with noise and the faults of real
    tests, for learning and for tests of software. Each record that is written has its truth beside
    it, as JSON. docs/guides/synth.md describes the spec.

    Parameters
    ----------
    spec : str, path or dict
        The name of a preset, a file, or a dictionary; docs/guides/synth.md describes its keys.
    seed : int, optional
        Use this seed for noise and hits, in place of the spec's.
    threads : int, optional
        Use this many threads (0: all; the samples are the same).

    Returns
    -------
    Synthetic
        `record` is a Record; `to_dict()` the truth.

    Raises
    ------
    InputError
        Data that percuss cannot use.
    UsageError
        Invalid values, and keywords that exclude each other.
    TypeError
        Unknown keywords, and values of another type.

    See Also
    --------
    presets : the names of the presets

    Notes
    -----
    The keywords are the options of `percuss synth`; docs/theory/theory.md has the equations.

    Examples
    --------
    >>> import percuss
    >>> test = percuss.synth("wood-bat", seed=7)
    >>> test.record.channels, test.record.fs_hz
    (2, 25600.0)
    >>> test["f_hz"][:3].tolist()
    [165.0, 568.0, 1177.0]
    """
    return synthesise_spec("synth", "synth", (spec,), {
        "seed": seed, "threads": threads,
    })
