# Made by python/scripts/make_functions.py from the declarations of the command line. Do not edit.
from __future__ import annotations

from typing import Literal, Sequence

from .._call import command_function, run_on_data
from .._results import Deflection
from .._types import Assignments, Band, Data, File, Numbers, Path, Quantities, Quantity, Range, Rate, Texts


@command_function("deflect", "deflect")
def deflect(
    *data: Data,
    method: Literal["auto", "small-interval", "drift-free", "frequency", "modal"] | None = None,
    highpass_corner: float | None = None,
    lowest: float | None = None,
    free_body: bool = False,
    effective_mass: Quantity | None = None,
    positions: Range | None = None,
    beam_distance: Quantity | None = None,
    beam_time: float | None = None,
    compare: File | Sequence[File] | None = None,
    beam: Assignments | None = None,
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
) -> Deflection:
    """Compute the deflection under an impact from the acceleration at the struck point.

    Integrates the acceleration of the struck point twice, without the drift of plain sums. Reports
    the largest deflection of each hit in m with its standard deviation. Files (.csv, .h5) hold the
    curves over time.

    Parameters
    ----------
    *data : path, array or Record
        Files (HDF5, MAT, UFF, LabVIEW, sound, CSV or text); or two arrays, force in N and
        acceleration in m/s², with `fs`, in the shapes that `Record` takes; or records. Arrays are
        not copied: do not change them before the function returns, or while the result still
        computes.
    method : {'auto', 'small-interval', 'drift-free', 'frequency', 'modal'}, optional
        Choose the method. auto: integrate without drift if the record shows the structure at rest
        before the impact, otherwise use modes and force if they are known. Default: auto.
    highpass_corner : float in Hz, optional
        Undo the first-order high-pass of the charge amplifier with this corner frequency; 0: none.
    lowest : float in Hz, optional
        Omit frequencies below this; for `method` frequency.
    free_body : bool, optional
        State that the structure may move away from its rest position: it hangs on rubber bands or
        strings, or nothing holds it.
    effective_mass : float in kg, optional
        State that nothing pulls the structure back within the record, and its effective mass at the
        struck point: 1/(1/m + d^2/J), with the mass m, the moment of inertia J about the centre of
        mass, and the distance d of the blow from it. Its rigid-body motion then follows from the
        force.
    positions : (lo, step, hi), optional
        Set the positions of the points along the structure in m, in order.
    beam_distance : float in m, optional
        Set the distance from the light beam to the structure; gives the speed of the ball.
    beam_time : float in s, optional
        Set the time at which the ball crosses the light beam, from the start of the record.
    compare : path, dict or Result, or a list of them, optional
        Compare modes and deflections with this document, which analyze or model wrote.
    beam : dict or str, optional
        Compare modes and deflections with this beam of percuss model: ei, rho_a, torsion, length,
        support, ball_mass, speed, hertz.
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

    Returns
    -------
    Deflection
        `hits` with `peak_m` (a magnitude, its sign in `direction`) and `peak_std_m` in m; `points`
        with their means, None where the hits differ in direction; `curves()` over time.

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

    Notes
    -----
    If no force was recorded, pass None as the force.

    The keywords are the options of `percuss deflect`; docs/theory/theory.md has the equations.

    Examples
    --------
    >>> import percuss
    >>> seen = percuss.deflect(percuss.synth("wood-bat").record)
    >>> seen.hits[0]["peak_m"] > 0
    True
    """
    return Deflection(run_on_data("deflect", "deflect", data, {
        "method": method, "highpass_corner": highpass_corner, "lowest": lowest, "free_body": free_body,
        "effective_mass": effective_mass, "positions": positions, "beam_distance": beam_distance,
        "beam_time": beam_time, "compare": compare, "beam": beam, "fs": fs, "df": df,
        "force_channel": force_channel, "accel_channel": accel_channel, "unit": unit, "force_unit": force_unit,
        "force_scale": force_scale, "accel_scale": accel_scale, "force_sensitivity": force_sensitivity,
        "accel_sensitivity": accel_sensitivity, "pressure_sensitivity": pressure_sensitivity, "angle": angle,
        "position": position, "frf_kind": frf_kind, "averages": averages, "setup": setup, "files": files,
        "trust_input": trust_input, "band": band, "effort": effort, "estimator": estimator,
        "accept_hit": accept_hit, "reject_hit": reject_hit, "modes": modes, "start": start, "trigger": trigger,
        "pretrigger": pretrigger, "length": length, "from_": from_, "to": to, "force_window": force_window,
        "exponential": exponential, "delay": delay, "overlay_db": overlay_db, "object": object,
        "threads": threads, "budget": budget, "title": title, "customer": customer, "operator": operator,
        "specimen": specimen, "date": date, "note": note, "logo": logo, "paper": paper,
    }))
