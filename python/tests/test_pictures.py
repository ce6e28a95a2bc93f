"""Tables for pandas and pictures with matplotlib, where they are installed; and the errors where they are not."""

import sys

import numpy as np
import pytest

import percuss

BAND = (60, 3200)


@pytest.fixture(scope="module")
def found(bat):
    return percuss.analyze(bat.record, band=BAND)


@pytest.fixture
def pyplot():
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    import matplotlib.pyplot

    yield matplotlib.pyplot
    matplotlib.pyplot.close("all")


def test_tables_become_data_frames(found, bat):
    pandas = pytest.importorskip("pandas")
    frame = found.to_dataframe()
    assert isinstance(frame, pandas.DataFrame) and frame["frequency_hz"].tolist() == found.frequency_hz.tolist()
    assert list(frame.columns) == list(found.table)
    responses = found.frf().to_dataframe()
    assert responses.index.name == "frequency_hz" and responses.columns.names == ["point", "channel"]
    assert np.array_equal(responses[0, 1].to_numpy(), found.frf().at(0, 1))
    assert percuss.frf(bat, band=BAND).to_dataframe().shape == responses.shape
    assert len(percuss.models.trampoline(hoop=(1000, 500, 2500)).to_dataframe()) == 4
    deflection = percuss.deflect(bat)
    assert deflection.to_dataframe()["peak_m"].tolist() == [hit["peak_m"] for hit in deflection["hits"]]
    with pytest.raises(TypeError, match="no table"):
        percuss.info("none.h5").to_dataframe()


def test_data_frames_of_surveys_hold_masses_and_mpc():
    pytest.importorskip("pandas")
    plate = percuss.synth("plate").record
    frame = percuss.survey(plate, band=(40, 450), effort="quick").to_dataframe()
    assert "mpc" in frame and "modal_mass_kg" not in frame  # no driving point
    found = percuss.survey(plate, band=(40, 450), effort="quick", driving_point=(7, 0))
    frame = found.to_dataframe()
    assert list(frame.columns) == [*found.table, "mpc", "modal_mass_kg", "modal_mass_std_kg"]
    masses = [mode["shape"].get("modal_mass_kg") for mode in found.modes]
    assert np.array_equal(frame["modal_mass_kg"], np.array([np.nan if one is None else one for one in masses]), equal_nan=True)
    assert (frame["modal_mass_std_kg"].notna() == frame["modal_mass_kg"].notna()).all()


def curves(axes):
    return [line for line in axes.lines if len(line.get_xdata()) > 2]


def test_frfs_are_drawn_with_the_fit(found, pyplot):
    magnitude, phase = found.plot()
    measured, fit, *_ = [line.get_ydata() for line in curves(magnitude)]
    assert len(curves(magnitude)) == 4 and len(curves(phase)) == 2  # two channels, each with its fit
    near = slice(*np.searchsorted(found.frf().frequency_hz, [160, 170]))
    assert np.allclose(measured[near], fit[near], atol=0.05)  # dB
    assert np.allclose(measured, 20 * np.log10(abs(found.frf().at(0, 0))))
    assert "dB" in magnitude.get_ylabel() and "Hz" in phase.get_xlabel()
    one, _ = found.plot(channel=1)
    assert len(curves(one)) == 2
    with pytest.raises(KeyError, match="channel 7"):
        found.plot(channel=7)
    _, given = pyplot.subplots(2)
    assert found.frf("mobility").plot(ax=given)[0] is given[0]
    with pytest.raises(percuss.UsageError, match="1 axes for 2"):
        found.plot(ax=given[0])


def test_stabilisation_and_shapes_are_drawn(found, pyplot):
    axes = found.plot("stabilisation")
    assert sum(len(line.get_xdata()) for line in axes.lines if line.get_linestyle() == "None") == len(found.stabilisation()["order"])
    barrel = percuss.survey(percuss.synth("roving-barrel"), band=BAND, effort="quick")
    drawn = barrel.plot("shapes")
    assert len(drawn) == len(barrel.frequency_hz)
    assert np.allclose(np.abs(curves(drawn[0])[0].get_ydata()).max(), 1)
    assert len(found.plot("shapes")) == 3
    with pytest.raises(percuss.UsageError, match="what= cannot be 'modes'; give frf, stabilisation or shapes"):
        found.plot("modes")


def test_deflections_are_drawn(bat, pyplot):
    seen = percuss.deflect(bat.record)
    axes = seen.plot()
    assert len(curves(axes)) == len(seen.curves())
    for line, curve in zip(curves(axes), seen.curves()):
        assert np.array_equal(line.get_ydata(), 1e3 * curve["deflection_m"])  # mm
        assert np.isclose(line.get_xdata()[100], 1e3 * (curve["first_s"] + 100 / 25600))  # ms


@pytest.mark.parametrize("module, use", [("pandas", lambda one: one.to_dataframe()), ("matplotlib.pyplot", lambda one: one.plot())])
def test_missing_modules_are_named(found, monkeypatch, module, use):
    monkeypatch.setitem(sys.modules, module, None)
    monkeypatch.setitem(sys.modules, module.partition(".")[0], None)
    for one in (found, found.frf()):
        with pytest.raises(ImportError, match=f"needs {module.partition('.')[0]}; install python3-{module.partition('.')[0]}"):
            use(one)
