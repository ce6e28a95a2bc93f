# Made by python/scripts/make_functions.py from the declarations of the command line. Do not edit.
from __future__ import annotations

from typing import Literal

from .._call import command_function, run_on_documents
from .._results import Result
from .._types import Assignments, Numbers, Path


@command_function("metrics.performance", "metrics")
def performance(
    *table: Path,
    bat_id: str | None = None,
    bat: Assignments | None = None,
    length_in: float | None = None,
    weight_oz: float | None = None,
    cg_in: float | None = None,
    period_s: Numbers | None = None,
    gate_times_s: Numbers | None = None,
    crossings_per_period: int | None = None,
    moi_oz_in2: float | None = None,
    ball_g: float | None = None,
    z_in: float | None = None,
    v_in_mph: float | None = None,
    v_out_mph: float | None = None,
    besr: float | None = None,
    bbcor: float | None = None,
    v_swing_mph: float | None = None,
    diameter_in: Numbers | None = None,
    handle_diameter_in: float | None = None,
    length_resolution_in: float | None = None,
    weight_resolution_oz: float | None = None,
    cg_resolution_in: float | None = None,
    ball_resolution_g: float | None = None,
    diameter_resolution_in: float | None = None,
    period_resolution_s: float | None = None,
    moi_resolution_oz_in2: float | None = None,
    z_resolution_in: float | None = None,
    speed_resolution_mph: float | None = None,
    round: bool = False,
    v_pitch_mph: float | None = None,
    nominal_mph: float | None = None,
    v0_mph: float | None = None,
    swing_length_in: float | None = None,
    swing_moi_oz_in2: float | None = None,
    swing_exponent: float | None = None,
    lot_correction: float | None = None,
    gravity_in_s2: float | None = None,
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
    """Compute a bat's performance: drop, MOI, BESR, BBS, BBCOR.

    Computes every metric that the given readings allow: drop, moment of inertia, swing and contact
    speed, BESR, BBS and BBCOR. Each has the uncertainty that follows from the resolution of the
    readings. The names of the options state their units. cg and z are measured from the tip of the
    barrel; the pivot is 6 in from the knob. A table has a row per bat, with an id and readings in
    columns named like the options (length_in, v_in_mph). Options give the readings that a row does
    not state. percuss study reads the result.

    Parameters
    ----------
    *table : path, optional
        A table of readings, with a row per bat.
    bat_id : str, optional
        Store this id of the bat in the document; percuss study joins documents by it.
    bat : dict or str, optional
        Store a property of the bat in the document, such as material=wood.
    length_in : float in in, optional
        Set the length of the bat.
    weight_oz : float in oz, optional
        Set the weight of the bat.
    cg_in : float in in, optional
        Set the balance point, from the tip of the barrel.
    period_s : float or list of float in s, optional
        Set the period of the bat swinging about the pivot; one reading or several.
    gate_times_s : float or list of float in s, optional
        Set the times at which the swinging bat crosses the light gate.
    crossings_per_period : int, optional
        Set the crossings of the gate per period: 2 if the gate counts both directions, 1 if it
        counts one. Default: 2.
    moi_oz_in2 : float in oz·in², optional
        Set the moment of inertia about the pivot, if known.
    ball_g : float in g, optional
        Set the mass of the ball.
    z_in : float in in, optional
        Set the impact position, from the tip of the barrel.
    v_in_mph : float in mph, optional
        Set the speed of the ball before the impact.
    v_out_mph : float in mph, optional
        Set the rebound speed of the ball, positive away from the bat.
    besr : float, optional
        Set BESR in place of the speeds.
    bbcor : float, optional
        Set BBCOR in place of the speeds.
    v_swing_mph : float in mph, optional
        Set the swing speed at the impact position, in place of the swing model's.
    diameter_in : float or list of float in in, optional
        Set the barrel diameters 3, 4, ... 9 in from the tip.
    handle_diameter_in : float in in, optional
        Set the diameter of the handle 6 in from the knob.
    length_resolution_in : float in in, optional
        Set the resolution of the length. Default: 0.0625.
    weight_resolution_oz : float in oz, optional
        Set the resolution of the weight. Default: 0.005.
    cg_resolution_in : float in in, optional
        Set the resolution of the balance point. Default: 0.0625.
    ball_resolution_g : float in g, optional
        Set the resolution of the ball's mass. Default: 0.1.
    diameter_resolution_in : float in in, optional
        Set the resolution of diameters. Default: 0.001.
    period_resolution_s : float in s, optional
        Set the resolution of periods or gate times; 0: unknown. Default: 0.
    moi_resolution_oz_in2 : float in oz·in², optional
        Set the resolution of the moment of inertia; 0: unknown. Default: 0.
    z_resolution_in : float in in, optional
        Set the resolution of the impact position; 0: unknown. Default: 0.
    speed_resolution_mph : float in mph, optional
        Set the resolution of speeds; 0: unknown. Default: 0.
    round : bool, optional
        Round the readings to these resolutions, as the protocol records them.
    v_pitch_mph : float in mph, optional
        Set the speed of the pitch at the plate. Default: 70.
    nominal_mph : float in mph, optional
        Set the reference speed of NCAA BESR. Default: 136.
    v0_mph : float in mph, optional
        Set the speed of the standard bat in the swing model. Default: 60.
    swing_length_in : float in in, optional
        Set the distance from the knob at which the standard bat has the speed `v0_mph`. Default:
        28.
    swing_moi_oz_in2 : float in oz·in², optional
        Set the moment of inertia of the standard bat in the swing model. Default: 15000.
    swing_exponent : float, optional
        Set the exponent of inertia in the swing model. Default: 0.3.
    lot_correction : float, optional
        Set the correction of the ball lot, added to v_out/v_in. Default: 0.
    gravity_in_s2 : float in in/s², optional
        Set the acceleration of gravity, as printed in the protocol; standard gravity is 386.089.
        Default: 386.4.
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
        `drop`, `moi_oz_in2`, `besr`, `bbs_mph`, `bbcor` … A metric that the readings do not allow
        is None. Of a table, `bats` has such a result per row.

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
    The keywords are the options of `percuss metrics`; docs/theory/performance.md has the equations.

    Examples
    --------
    >>> import percuss
    >>> round(percuss.metrics.performance(length_in=34, weight_oz=31).drop, 9)
    -3.0
    """
    return Result(run_on_documents("metrics.performance", "metrics", table, {
        "bat_id": bat_id, "bat": bat, "length_in": length_in, "weight_oz": weight_oz, "cg_in": cg_in,
        "period_s": period_s, "gate_times_s": gate_times_s, "crossings_per_period": crossings_per_period,
        "moi_oz_in2": moi_oz_in2, "ball_g": ball_g, "z_in": z_in, "v_in_mph": v_in_mph, "v_out_mph": v_out_mph,
        "besr": besr, "bbcor": bbcor, "v_swing_mph": v_swing_mph, "diameter_in": diameter_in,
        "handle_diameter_in": handle_diameter_in, "length_resolution_in": length_resolution_in,
        "weight_resolution_oz": weight_resolution_oz, "cg_resolution_in": cg_resolution_in,
        "ball_resolution_g": ball_resolution_g, "diameter_resolution_in": diameter_resolution_in,
        "period_resolution_s": period_resolution_s, "moi_resolution_oz_in2": moi_resolution_oz_in2,
        "z_resolution_in": z_resolution_in, "speed_resolution_mph": speed_resolution_mph, "round": round,
        "v_pitch_mph": v_pitch_mph, "nominal_mph": nominal_mph, "v0_mph": v0_mph,
        "swing_length_in": swing_length_in, "swing_moi_oz_in2": swing_moi_oz_in2,
        "swing_exponent": swing_exponent, "lot_correction": lot_correction, "gravity_in_s2": gravity_in_s2,
        "title": title, "customer": customer, "operator": operator, "specimen": specimen, "date": date,
        "note": note, "logo": logo, "paper": paper, "keep_formulas": keep_formulas,
    }))
