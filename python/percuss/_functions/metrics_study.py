# Made by python/scripts/make_functions.py from the declarations of the command line. Do not edit.
from __future__ import annotations

from typing import Literal

from .._call import command_function, run_on_documents
from .._results import Result
from .._types import File, Path, Texts


@command_function("metrics.study", "study")
def study(
    *tables: Path,
    figures: Path | None = None,
    program: Texts | None = None,
    hoop_curve: File | None = None,
    blind: Path | None = None,
    table: Path | None = None,
    title: str | None = None,
    customer: str | None = None,
    operator: str | None = None,
    specimen: str | None = None,
    date: str | None = None,
    note: str | None = None,
    logo: Path | None = None,
    paper: Literal["a4", "letter"] | None = None,
    keep_formulas: bool = False,
) -> Result:
    """Correlate the properties of a population of bats with their performance.

    Joins tables of bats, results of percuss batch merge, and documents of percuss analyze and
    metrics with `bat_id`, of certify and of abi, by the id of the bat. Tests which properties
    correlate with performance: reports each hypothesis with verdict, p-value, and correlations with
    95 % intervals. `percuss.example("study")` prints a table with all known columns.

    Parameters
    ----------
    *tables : path
        Tables, or documents that name their bat (analyses and metrics with `bat_id`, certify, abi).
    figures : path, optional
        Write every figure as picture and table into this folder.
    program : str or list of str, optional
        Count the bats of these certification programs in statements, trends and correlations;
        default: besr and bats without a program; if there are none, the program with the most bats;
        all: every bat.
    hoop_curve : path, dict or Result, optional
        Draw this model over the hoop figures; a document of percuss model trampoline.
    blind : path, optional
        Replace the ids of the bats by neutral ones, and write the key to this file.
    table : path, optional
        Write the joined table.
    title : str, optional
        Set the title of the page (default: the name of the file).
    customer : str, optional
        State the customer on the page.
    operator : str, optional
        State on the page who did the test.
    specimen : str, optional
        State on the page what was tested.
    date : str, optional
        State on the page when the test was done (default: as the file states it).
    note : str, optional
        Put this text, or the text of a file, at the top of the page.
    logo : path, optional
        Put this picture at the top of the page (PNG, JPEG or SVG, at most 200 kB).
    paper : {'a4', 'letter'}, optional
        Set the paper on which the page is printed. Default: a4.
    keep_formulas : bool, optional
        Write texts such as =1+1 to CSV without the apostrophe that keeps a spreadsheet from
        computing them.

    Returns
    -------
    Result
        Every hypothesis with its statistics.

    Raises
    ------
    InputError
        Data that percuss cannot use.
    UsageError
        Invalid values, and keywords that exclude each other.
    TypeError
        Unknown keywords, and values of another type.

    Notes
    -----
    The keywords are the options of `percuss study`; docs/theory/performance.md has the equations.
    """
    return Result(run_on_documents("metrics.study", "study", tables, {
        "figures": figures, "program": program, "hoop_curve": hoop_curve, "blind": blind, "table": table,
        "title": title, "customer": customer, "operator": operator, "specimen": specimen, "date": date,
        "note": note, "logo": logo, "paper": paper, "keep_formulas": keep_formulas,
    }))
