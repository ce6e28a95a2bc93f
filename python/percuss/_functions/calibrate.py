# Made by python/scripts/make_functions.py from the declarations of the command line. Do not edit.
from __future__ import annotations

from typing import Literal

from .._call import command_function, run_on_data
from .._results import Result
from .._types import Data, File, Numbers, Quantities, Quantity, Rate, Texts


@command_function("calibrate", "calibrate")
def calibrate(
    *data: Data,
    mass: Quantity,
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
    trigger: float | None = None,
) -> Result:
    """Calibrate the force channel from hits on a free mass.

    A freely hanging mass accelerates by force / mass under a hit. Computes the N per unit of the
    force channel from the measured acceleration, with its standard deviation. The unit is the one
    of the stored numbers, such as mV. The last line of the printed text states the `force_scale` to
    use. The force may be stored in any unit; the keywords for reading files set the unit of the
    acceleration.

    Parameters
    ----------
    *data : path, array or Record
        Files (HDF5, MAT, UFF, LabVIEW, sound, CSV or text); or two arrays, force as stored and
        acceleration in m/s² or in `unit`, with `fs`, in the shapes that `Record` takes; or records.
        Arrays are not copied: do not change them before the function returns, or while the result
        still computes.
    mass : float in kg
        Set the free mass, including its accelerometer.
    fs : float or str in Hz, optional
        Set the sampling rate in place of the file's: a number, or for a MAT file the name of a
        variable.
    trigger : float, optional
        Detect a hit above this reading, in the unit of the force channel (default: from the noise).

    Returns
    -------
    Result
        `force_scale` and `force_scale_std` in N per stored unit of the force channel, `n_per_unit`
        (without the sign), `hits`.

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
    The keywords are the options of `percuss calibrate`; docs/theory/theory.md has the equations.
    """
    return Result(run_on_data("calibrate", "calibrate", data, {
        "fs": fs, "df": df, "force_channel": force_channel, "accel_channel": accel_channel, "unit": unit,
        "force_unit": force_unit, "force_scale": force_scale, "accel_scale": accel_scale,
        "force_sensitivity": force_sensitivity, "accel_sensitivity": accel_sensitivity,
        "pressure_sensitivity": pressure_sensitivity, "angle": angle, "position": position,
        "frf_kind": frf_kind, "averages": averages, "setup": setup, "files": files, "trust_input": trust_input,
        "mass": mass, "trigger": trigger,
    }))
