"""Performance of bats, their certification, and comparison of mode shapes.

performance() computes every metric that the readings allow. certify(), abi() and study() follow the test protocols.
mac() compares mode shapes; it is percuss.mac.

>>> import percuss
>>> bat = percuss.metrics.performance(length_in=34, weight_oz=31)
>>> round(bat.drop, 9)
-3.0
"""

from __future__ import annotations

from ._functions.metrics_abi import abi
from ._functions.metrics_certify import certify
from ._functions.metrics_performance import performance
from ._functions.metrics_study import study
from ._mac import mac

__all__ = ["abi", "certify", "mac", "performance", "study"]
