"""Tables for pandas and notebooks."""

from __future__ import annotations

import html
import importlib
from typing import Any

import numpy as np

_MAX_ROWS = 20  # of a table in a notebook
STYLE = (
    "<style>.percuss table{border-collapse:collapse;font-variant-numeric:tabular-nums}"
    ".percuss th,.percuss td{padding:.2rem .9rem .2rem 0;text-align:left;vertical-align:top;white-space:nowrap}"
    ".percuss td:last-child{white-space:normal;min-width:12rem}"
    ".percuss .right{text-align:right}.percuss th{font-weight:600;border-bottom:1px solid #c9d1d9}"
    ".percuss .warnings{list-style:none;margin:1rem 0;padding:0}"
    ".percuss .warnings li{background:#fff4e5;color:#7a3e00;border-left:4px solid;padding:.4rem .8rem;margin:.4rem 0}</style>"
)


def optional_module(name: str, use: str) -> Any:
    """A module that percuss does not need otherwise. Raises ImportError with the package to install."""
    package = name.partition(".")[0]
    try:
        return importlib.import_module(name)
    except ImportError:
        raise ImportError(f"{use} needs {package}; install python3-{package} (apt-get) or {package} (pip)", name=package) from None


def table_frame(table: dict[str, np.ndarray]) -> Any:
    pandas = optional_module("pandas", "to_dataframe()")
    if not table:
        raise TypeError("this result has no table; its numbers are in to_dict()")
    return pandas.DataFrame(dict(table))


def rows_frame(rows: list[dict[str, Any]]) -> Any:
    return optional_module("pandas", "to_dataframe()").DataFrame(rows)


def frf_frame(frf: Any) -> Any:
    pandas = optional_module("pandas", "to_dataframe()")
    points, channels = frf.points.tolist(), range(frf.H.shape[1])
    columns = pandas.MultiIndex.from_product([points, channels], names=["point", "channel"])
    values = frf.H.reshape(-1, frf.H.shape[2]).T
    return pandas.DataFrame(values, index=pandas.Index(frf.frequency_hz, name="frequency_hz"), columns=columns)


def html_table(head: list[str], rows: list[list[str]]) -> str:
    """A table of plain texts, with its style."""
    cells = lambda tag, row: "".join(f"<{tag}>{html.escape(one)}</{tag}>" for one in row)  # noqa: E731
    body = "".join(f"<tr>{cells('td', row)}</tr>" for row in rows[:_MAX_ROWS])
    more = f"<p>and {len(rows) - _MAX_ROWS} more</p>" if len(rows) > _MAX_ROWS else ""
    return f'{STYLE}<div class="percuss"><table><tr>{cells("th", head)}</tr>{body}</table>{more}</div>'


def frf_html(frf: Any) -> str:
    rows = []
    for p, point in enumerate(frf.points.tolist()):
        for channel, name in enumerate(frf.names):
            size = np.abs(frf.H[p, channel])
            peak = int(np.argmax(size))
            rows.append([str(point), name, f"{size[peak]:.4g} {frf.unit}", f"{frf.frequency_hz[peak]:.6g} Hz"])
    return html_table(["point", "channel", f"largest {frf.kind}", "at"], rows)
