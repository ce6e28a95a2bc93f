"""Writes records and FRFs."""

from __future__ import annotations

import os
from typing import Any

from . import _percuss
from ._errors import note_in_python
from ._frf import Frf
from ._records import Record
from ._results import Synthetic
from ._tests import TestResult


def write(path: str | bytes | os.PathLike[str], data: Record | Frf | Synthetic | TestResult, *, force: bool = False) -> list[str]:
    """Write a record or FRFs in the format of the path's extension.

    Parameters
    ----------
    path : path
        .h5, .hdf5, .csv, .mat, .uff, .unv; records also .wav, .rf64, .w64.
    data : Record, Frf, Synthetic, AveragedFrf, Analysis or Survey
        A Record or Frf is written unchanged. Of a Synthetic, the record is written; of an
        AveragedFrf, Analysis or Survey, the FRFs.
    force : bool, optional
        Overwrite an existing file.

    Returns
    -------
    list of str
        The information that the format cannot store, one line each.

    Raises
    ------
    InputError
        The file exists or cannot be written; then no part of it is left.
    TypeError
        Data of another type.
    UsageError
        An unknown extension.

    Examples
    --------
    >>> import os, tempfile, percuss
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     _ = percuss.write(os.path.join(folder, "bat.h5"), percuss.synth("wood-bat"))
    ...     percuss.read(os.path.join(folder, "bat.h5")).rows
    5
    """
    one: Any = data.record if isinstance(data, Synthetic) else data.frf() if isinstance(data, TestResult) else data
    if not isinstance(one, (Record, Frf)):
        raise TypeError(f"data cannot be {type(data).__name__}: give a Record, a Frf, a Synthetic or a result that holds FRFs")
    words = ["convert", "--quiet", f"--output={os.fsdecode(path)}"] + (["--force"] if force else [])
    return [note_in_python(note) for note in _percuss.run([os.fsencode(word) for word in words], [one._handle], []).notes]
