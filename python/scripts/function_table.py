"""The functions of the package: their commands, positional parameters, results, and the parts of their docstrings that no
declaration of the command line holds."""

from __future__ import annotations

from dataclasses import dataclass

DATA = (
    "*data",
    "Data",
    "path, array, Record or Frf",
    "Files (HDF5, MAT, UFF, LabVIEW, sound, CSV or text); or two arrays, force in N and acceleration in m/s², with `fs`, in the "
    "shapes that `Record` takes; or records; or FRFs. Arrays are not copied: do not change them before the function returns, or "
    "while the result still computes.",
)
# For functions that need hits over time, and refuse FRFs.
RECORDS = (DATA[0], DATA[1], "path, array or Record", DATA[3].replace("; or records; or FRFs.", "; or records."))
# For the calibration, whose force has any unit.
UNCALIBRATED = (*RECORDS[:3], RECORDS[3].replace("force in N and acceleration in m/s²", "force as stored and acceleration in m/s² or in `unit`"))


@dataclass(frozen=True)
class Function:
    """`name` is the name of the function in percuss or in one of its modules; `parts` are the positional parameters (name, type, type in
    words, text); `imports` say where the type of the result is."""

    name: str
    command: str
    result: str
    returns: str
    parts: tuple[tuple[str, str, str, str], ...] = ()
    call: str = "run_on_documents"  # the function of _call.py that runs the command
    imports: tuple[str, ...] = ("from .._results import Result",)
    notes: str = ""
    example: str = ""
    see_also: tuple[tuple[str, str], ...] = ()


_MEASURED = {"parts": (DATA,), "call": "run_on_data"}
_RECORDED = {"parts": (RECORDS,), "call": "run_on_data"}

FUNCTIONS = (
    Function(
        "analyze", "analyze", "Analysis",
        "Natural frequencies, damping ratios and residues with their standard deviations, hits, warnings; `frf()` returns the FRFs.",
        imports=("from .._analyses import Analysis",), **_MEASURED,
        notes="Several tests in one call: `percuss.analyze(a, b, c, files=\"tests\", threads=4)`. The tests share the threads, and `runs` "
        "holds an Analysis for each.",
        see_also=(("survey", "mode shapes of a test of many points"), ("frf", "only the frequency responses")),
        example="""
>>> import percuss
>>> test = percuss.synth("wood-bat")
>>> found = percuss.analyze(test.record, band=(60, 3200))
>>> found.frequency_hz.round(1).tolist()
[165.0, 568.0, 1177.0]
>>> found.family[0], int(found.order[0])
('bending', 1)
""",
    ),
    Function(
        "frf", "frf", "AveragedFrf",
        "`frequency_hz` (lines,), `H`, `std` and `coherence` (points, channels, lines).",
        imports=("from .._tests import AveragedFrf",), **_MEASURED,
        see_also=(("analyze", "the modes too"), ("Frf", "FRFs from arrays")),
        example="""
>>> import percuss
>>> responses = percuss.frf(percuss.synth("wood-bat").record, band=(60, 3200))
>>> responses.H.shape == (1, 2, len(responses.frequency_hz))
True
""",
    ),
    Function(
        "survey", "survey", "Survey",
        "An Analysis with `shapes` (modes, places), `mac` (modes, modes) and `cmif` (lines, values).",
        imports=("from .._surveys import Survey",), **_MEASURED,
        notes="`geometry` may be an array (points, 3) in m.",
        see_also=(("mac", "compare the shapes of two surveys"),),
        example="""
>>> import percuss
>>> found = percuss.survey(percuss.synth("roving-barrel").record, band=(60, 3200), effort="quick")
>>> found.mac.shape == (len(found.frequency_hz),) * 2
True
""",
    ),
    Function(
        "nodes", "nodes", "Nodes", "Positions, and modes with `frequency_hz` and `nodes` (`position_m` and `std_m` in m).",
        imports=("from .._results import Nodes",), **_MEASURED,
    ),
    Function(
        "deflect", "deflect", "Deflection", "`hits` with `peak_m` (a magnitude, its sign in `direction`) and `peak_std_m` in m; `points` with their means, None where the hits differ in direction; `curves()` over time.",
        imports=("from .._results import Deflection",), **_RECORDED,
        notes="If no force was recorded, pass None as the force.",
        example="""
>>> import percuss
>>> seen = percuss.deflect(percuss.synth("wood-bat").record)
>>> seen.hits[0]["peak_m"] > 0
True
""",
    ),
    Function(
        "calibrate", "calibrate", "Result",
        "`force_scale` and `force_scale_std` in N per stored unit of the force channel, `n_per_unit` (without the sign), `hits`.",
        parts=(UNCALIBRATED,), call="run_on_data",
    ),
    Function(
        "synth", "synth", "Synthetic", "`record` is a Record; `to_dict()` the truth.",
        parts=(("spec", "File", "str, path or dict", "The name of a preset, a file, or a dictionary; docs/guides/synth.md describes its keys."),),
        imports=("from .._results import Synthetic",), call="synthesise_spec",
        see_also=(("presets", "the names of the presets"),),
        example="""
>>> import percuss
>>> test = percuss.synth("wood-bat", seed=7)
>>> test.record.channels, test.record.fs_hz
(2, 25600.0)
>>> test["f_hz"][:3].tolist()
[165.0, 568.0, 1177.0]
""",
    ),
    Function(
        "read", "read", "Measured", "A list if several files are named. A record's samples are read on demand.",
        parts=(("*paths", "Paths", "path", "HDF5, MAT, UFF, LabVIEW, sound, CSV or text."),), call="read_files",
        imports=(),
        see_also=(("info", "describe files without an exception"), ("write", "write records and FRFs")),
    ),
    Function(
        "info", "info", "Result",
        "`files` describes each file. A file that cannot be read is listed with its error, without an exception.",
        parts=(("*paths", "Path", "path", "Files of any kind that `read` accepts."),),
        example="""
>>> import os, tempfile, percuss
>>> with tempfile.TemporaryDirectory() as folder:
...     percuss.synth("wood-bat").save(os.path.join(folder, "bat.csv"))
...     percuss.info(os.path.join(folder, "bat.csv")).files[0]["kind"]
'CSV'
""",
    ),
    Function(
        "compare", "compare", "Result", "`pairs`, `unpaired_a` and `unpaired_b`.",
        parts=(("*documents", "File", "Result, dict or path", "Two or more results of `analyze`, `survey`, `deflect`, `models.beam`, `models.bat`, `models.impact` or `models.shell`, or their documents."),),
        see_also=(("mac", "the modal assurance criterion of two sets of shapes"),),
        example="""
>>> import percuss
>>> a = percuss.models.beam(support="free", length=0.84, modes=4)
>>> b = percuss.models.beam(support="free", length=0.85, modes=4)
>>> len(percuss.compare(a, b)["pairs"]) > 0
True
""",
    ),
    Function("models.beam", "model beam", "Result", "The keys of the document: `frequency_hz` (modes,), `lambda`, `node_m` …"),
    Function("models.impact", "model impact", "Result", "The keys of the document: `cor`, `contact_s`, `peak_force_n`, `sweep` …"),
    Function("models.rigid", "model rigid", "Result", "The keys of the document: `best`, `curve`."),
    Function("models.trampoline", "model trampoline", "Result", "The keys of the document: `wall_cor`, `peak`, `curve`."),
    Function(
        "models.bat", "model bat", "Result", "The keys of the document: `frequency_hz` (modes,), `node_m`, `mass_kg`, `curve` …",
        notes="`profile` may be an array (slices, 2): the position of each slice's far end, from the knob, and the diameter, in the "
        "units of `profile_unit`. A file with a line of names may hold walls and layers.",
    ),
    Function("models.shell", "model shell", "Result", "The keys of the document: `ring_hz`, `rayleigh_hz`, `love_hz`, `flugge_hz` (modes,)."),
    Function(
        "metrics.performance", "metrics", "Result",
        "`drop`, `moi_oz_in2`, `besr`, `bbs_mph`, `bbcor` … A metric that the readings do not allow is None. Of a table, `bats` has such a "
        "result per row.",
        parts=(("*table", "Path", "path, optional", "A table of readings, with a row per bat."),),
        example="""
>>> import percuss
>>> round(percuss.metrics.performance(length_in=34, weight_oz=31).drop, 9)
-3.0
""",
    ),
    Function(
        "metrics.certify", "certify", "Result",
        "Verdict, sweet spot, shots, `next`. `exit_code` is 5 if the bat exceeds its limit or is damaged.",
        parts=(("session", "File", "path or dict", "The session; `percuss.example(\"certify\")` shows its keys."),),
    ),
    Function(
        "metrics.abi", "abi", "Result", "The next step and the verdict. `exit_code` is 5 if the bat fails.",
        parts=(("log", "File", "path or dict", "The log; `percuss.example(\"abi\")` shows its keys."),),
    ),
    Function(
        "metrics.study", "study", "Result", "Every hypothesis with its statistics.",
        parts=(("*tables", "Path", "path", "Tables, or documents that name their bat (analyses and metrics with `bat_id`, certify, abi)."),),
    ),
)  # fmt: skip
