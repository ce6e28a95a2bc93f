# Made by python/scripts/make_functions.py from the declarations of the command line. Do not edit.
from __future__ import annotations

from typing import Literal, Sequence

from .._call import command_function, run_on_data
from .._surveys import Survey
from .._types import Band, Data, File, Numbers, Path, Quantities, Range, Rate, Texts

_Picture = Literal["shapes", "indicator", "magnitude", "phase", "coherence", "force", "response", "spectrum", "decay", "stabilisation", "movement"]


@command_function("survey", "survey")
def survey(
    *data: Data,
    fs: Rate | None = None,
    df: float | None = None,
    force_channel: str | int | None = None,
    accel_channel: Texts | None = None,
    unit: str | None = None,
    force_unit: str | None = None,
    force_scale: Numbers | None = None,
    accel_scale: Numbers | None = None,
    force_sensitivity: float | None = None,
    accel_sensitivity: Numbers | None = None,
    pressure_sensitivity: Numbers | None = None,
    angle: Numbers | None = None,
    position: Quantities | None = None,
    frf_kind: Literal["accelerance", "mobility", "receptance"] | None = None,
    averages: int | None = None,
    setup: File | None = None,
    files: Literal["hits", "points", "tests"] | None = None,
    trust_input: bool = False,
    band: Band | None = None,
    effort: Literal["quick", "standard", "best"] | None = None,
    estimator: Literal["h1", "h2", "hv"] | None = None,
    accept_hit: int | str | Sequence[int | str] | None = None,
    reject_hit: int | str | Sequence[int | str] | None = None,
    modes: int | None = None,
    start: Numbers | None = None,
    trigger: float | None = None,
    pretrigger: float | None = None,
    length: float | None = None,
    from_: float | None = None,
    to: float | None = None,
    force_window: Literal["auto", "off"] | None = None,
    exponential: float | None = None,
    delay: str | Sequence[float] | None = None,
    overlay_db: float | None = None,
    object: Literal["auto", "tube", "other"] | None = None,
    threads: int | None = None,
    budget: Numbers | None = None,
    title: str | None = None,
    customer: str | None = None,
    operator: str | None = None,
    specimen: str | None = None,
    date: str | None = None,
    note: str | None = None,
    logo: Path | None = None,
    paper: Literal["a4", "letter"] | None = None,
    geometry: File | None = None,
    roving: Literal["hammer", "sensor"] | None = None,
    driving_point: Range | None = None,
    picture: _Picture | Sequence[_Picture] | None = None,
    hits: bool = False,
    trace: bool = False,
) -> Survey:
    """Identify mode shapes from a test of many points: MAC, modal mass, orders.

    Analyses a test of many points: mode shapes, their MAC, modal masses if a driving point is
    known, and bending or hoop with the circumferential order from the shapes. A file holds all
    points, one point (P1, P2, ...) or hits of one point (P1_1, P1_2, ...). A geometry file gives
    their coordinates; `percuss.example("survey")` prints one.

    Parameters
    ----------
    *data : path, array, Record or Frf
        Files (HDF5, MAT, UFF, LabVIEW, sound, CSV or text); or two arrays, force in N and
        acceleration in m/s², with `fs`, in the shapes that `Record` takes; or records; or FRFs.
        Arrays are not copied: do not change them before the function returns, or while the result
        still computes.
    fs : float or str in Hz, optional
        Set the sampling rate in place of the file's: a number, or for a MAT file the name of a
        variable.
    band : (low, high), optional
        Analyse this frequency band in Hz, such as 60:3200 (default: from 1 % to 100 % of the
        highest frequency that the hammer excites).
    effort : {'quick', 'standard', 'best'}, optional
        Choose the effort. quick: fit modes with a peak, each over its own spectral lines; standard:
        also modes without a peak; best: all modes together, as precisely as the noise permits.
        Default: best.
    estimator : {'h1', 'h2', 'hv'}, optional
        Estimate FRFs with h1, h2 or hv. Default: h1.
    accept_hit : int, str, or a list of them, optional
        Accept these hits despite their findings: numbers as in the table of hits, ranges, or all;
        such as 1-5,8. A hit without a pulse of the force gives no FRF and stays rejected.
    reject_hit : int, str, or a list of them, optional
        Reject these hits, written as for `accept_hit`.
    modes : int, optional
        Report this many modes, the clearest ones.
    start : float or list of float in Hz, optional
        List modes near these frequencies and no others.
    trigger : float in N, optional
        Detect a hit above this force (default: from the noise).
    pretrigger : float in s, optional
        Keep this time before the peak of each hit of a long record.
    length : float in s, optional
        Keep this time of each hit, pre-trigger included.
    from_ : float in s, optional
        Use each row from this time on.
    to : float in s, optional
        Use each row up to this time.
    force_window : {'auto', 'off'}, optional
        Window the force. auto: only the pulse enters the FRF; off: the whole force record. Default:
        auto.
    exponential : float, optional
        Apply an exponential window that falls to this fraction at the end of each hit, such as
        0.01; damping is corrected exactly. For FRFs: the window with which they were computed.
    delay : str, float or list of float, optional
        Remove the delay of each accelerometer against the force. auto: estimate it from the phases
        of the modes; off: only warn about it; or give it in seconds, one for all or one per
        channel, negative if the channel is early. Default: off.
    overlay_db : float in dB, optional
        Treat two FRFs as overlaid if they differ by at most this much at a peak. Default: 1.
    object : {'auto', 'tube', 'other'}, optional
        State what was struck. Bending and hoop are judged on a tube only; modes of other objects
        are numbered. auto: a tube if angles are given, or if the modes fit two accelerometers at 0°
        and 90°. Default: auto.
    threads : int, optional
        Use this many threads (default: all; the result is the same).
    budget : float or list of float, optional
        Stop an analysis that takes more than this time in seconds or memory in GB (default: 120 s
        plus 2 s per MB of input; 2.1 GB plus 16 times the input).
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
    geometry : path, array or dict, optional
        Read the geometry from this file, a CSV as `percuss.example("survey")` prints it; further
        columns, dx, dy and dz or direction (+x ... -z), state where the blow or the roving sensor
        points (default: from the record).
    roving : {'hammer', 'sensor'}, optional
        Choose what moved from point to point (default: as the file states, else hammer).
    driving_point : (point, channel) or a list of them, optional
        Name driving points: a point struck beside the sensor of a channel, by the point's number
        and the channel's, which counts from 0 as in JSON; 1:0 is point 1 and the first channel.
        Where each file is a point, POINT is the file's name (P7:0) or a number. The number is the
        one in the file's name, else of a geometry that counts from 1, else of the record (default:
        points at the position of a sensor).
    picture : {'shapes', 'indicator', 'magnitude', 'phase', 'coherence', 'force', 'response', 'spectrum', 'decay', 'stabilisation', 'movement'} or a list of them, optional
        Draw these pictures in a .svg file.
    hits : bool, optional
        Add the table of hits.
    trace : bool, optional
        Report the stages that ran: calls and seconds.

    Returns
    -------
    Survey
        An Analysis with `shapes` (modes, places), `mac` (modes, modes) and `cmif` (lines, values).

    Other Parameters
    ----------------
    df : float in Hz, optional
        Set the frequency spacing of FRFs, for files that round frequencies or state none (MAT).
    force_channel : str or int, optional
        Select the force by column name or number, counted from 1.
    accel_channel : str or list of str, optional
        Select the accelerations, in this order, by name or number.
    unit : str, optional
        Set the unit of the stored accelerations: m/s^2, g, cm/s^2, V, ...; without a force also Pa.
    force_unit : str, optional
        Set the unit of the stored forces: N, lbf, V, ...
    force_scale : float or list of float, optional
        Set the force in N per stored unit; one value, or one per file.
    accel_scale : float or list of float, optional
        Set the acceleration in m/s^2 per stored unit; one value, or one per channel.
    force_sensitivity : float in mV/N, optional
        Set the sensitivity of the hammer, for forces stored in volts.
    accel_sensitivity : float or list of float in mV/g, optional
        Set the sensitivity of the accelerometers, for accelerations stored in volts; one value, or
        one per channel.
    pressure_sensitivity : float or list of float in mV/Pa, optional
        Set the sensitivity of the microphones, for sound pressures stored in volts, without a
        force; one value, or one per channel.
    angle : float or list of float in degrees, optional
        Set the angle of each accelerometer around the barrel.
    position : float or list of float in m, optional
        Set the distance of each accelerometer from the end of the barrel.
    frf_kind : {'accelerance', 'mobility', 'receptance'}, optional
        Set the kind of the FRFs, in place of the file's.
    averages : int, optional
        Set the number of averages of the FRFs, for files that do not state it: with a coherence, it
        gives their standard deviation.
    setup : path or dict, optional
        Read the channel set-up from this file (JSON; `percuss.example("info")` prints one).
    files : {'hits', 'points', 'tests'}, optional
        Group several files: as hits of one test, as points of one test, or as separate tests
        (default: hits if rates and channels agree).
    trust_input : bool, optional
        Read MAT, HDF5 and sound files in this process, without a sandbox.

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
    mac : compare the shapes of two surveys

    Notes
    -----
    `geometry` may be an array (points, 3) in m.

    The keywords are the options of `percuss survey`; docs/theory/theory.md has the equations.

    Examples
    --------
    >>> import percuss
    >>> found = percuss.survey(percuss.synth("roving-barrel").record, band=(60, 3200), effort="quick")
    >>> found.mac.shape == (len(found.frequency_hz),) * 2
    True
    """
    return Survey(run_on_data("survey", "survey", data, {
        "fs": fs, "df": df, "force_channel": force_channel, "accel_channel": accel_channel, "unit": unit,
        "force_unit": force_unit, "force_scale": force_scale, "accel_scale": accel_scale,
        "force_sensitivity": force_sensitivity, "accel_sensitivity": accel_sensitivity,
        "pressure_sensitivity": pressure_sensitivity, "angle": angle, "position": position,
        "frf_kind": frf_kind, "averages": averages, "setup": setup, "files": files, "trust_input": trust_input,
        "band": band, "effort": effort, "estimator": estimator, "accept_hit": accept_hit,
        "reject_hit": reject_hit, "modes": modes, "start": start, "trigger": trigger, "pretrigger": pretrigger,
        "length": length, "from_": from_, "to": to, "force_window": force_window, "exponential": exponential,
        "delay": delay, "overlay_db": overlay_db, "object": object, "threads": threads, "budget": budget,
        "title": title, "customer": customer, "operator": operator, "specimen": specimen, "date": date,
        "note": note, "logo": logo, "paper": paper, "geometry": geometry, "roving": roving,
        "driving_point": driving_point, "picture": picture, "hits": hits, "trace": trace,
    }))
