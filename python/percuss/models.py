"""Models of beams, bats and barrels, and of a ball that strikes them.

Each function takes the options of `percuss model NAME` as keywords, in SI units unless the name of a keyword states
another unit. It returns a Result with the keys of the document. The attribute table holds the columns of the command's
.csv.

>>> import percuss
>>> beam = percuss.models.beam(support="free", length=0.84, modes=4)
>>> beam.frequency_hz.shape
(4,)
"""

from __future__ import annotations

from ._functions.models_bat import bat
from ._functions.models_beam import beam
from ._functions.models_impact import impact
from ._functions.models_rigid import rigid
from ._functions.models_shell import shell
from ._functions.models_trampoline import trampoline

__all__ = ["bat", "beam", "impact", "rigid", "shell", "trampoline"]
