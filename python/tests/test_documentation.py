"""Docstrings and the tutorial agree with the module."""

import ast
import contextlib
import doctest
import inspect
import io
import pathlib
import re

import pytest

import percuss
from conftest import SOURCE

TUTORIAL = SOURCE / "docs" / "tutorials" / "python.md"
MODULES = {"percuss": percuss, "models": percuss.models, "metrics": percuss.metrics}
FUNCTIONS = [(name, one) for module in MODULES.values() for name, one in vars(module).items()
             if inspect.isfunction(one) and name in module.__all__]  # fmt: skip
NUMPYDOC = ["Parameters", "Returns", "Other Parameters", "Raises", "See Also", "Notes", "Examples"]  # the order of NumPy and SciPy


def sections(text):
    return re.findall(r"^(\w[\w ]*)\n-{3,}$", text, re.M)


@pytest.mark.parametrize("name, function", FUNCTIONS, ids=[name for name, _ in FUNCTIONS])
def test_docstrings_have_the_sections_of_scipy(name, function):
    text = inspect.getdoc(function)
    found = sections(text)
    assert found == [one for one in NUMPYDOC if one in found], name
    assert "Returns" in found and ("Raises" in found or "Examples" in found)
    assert re.match(r"[A-Z][^\n]*\.(\n\n|$)|[A-Z][^\n]*\n[^\n]*\.\n\n", text), f"{name}: no summary"
    for keyword, one in inspect.signature(function).parameters.items():
        shown = ("*" if one.kind is one.VAR_POSITIONAL else "") + keyword
        assert re.search(rf"^(\w+, )*{re.escape(shown)}(, \w+)* : \S", text, re.M), f"{name} says nothing of {keyword}"
    assert "--" not in re.sub(r"^-+$", "", text, flags=re.M), f"{name} names a flag of the command line"


def test_the_compiled_part_agrees_with_its_stub():
    from percuss import _percuss

    tree = ast.parse((SOURCE / "python" / "percuss" / "_percuss.pyi").read_text())
    named = {one.name: one for one in tree.body if isinstance(one, (ast.FunctionDef, ast.ClassDef))}
    for name, one in named.items():
        members = [part.name for part in getattr(one, "body", []) if isinstance(part, ast.FunctionDef)]
        members += [part.target.id for part in getattr(one, "body", []) if isinstance(part, ast.AnnAssign)]
        assert all(hasattr(getattr(_percuss, name), member) for member in members), name
        if isinstance(one, ast.ClassDef):
            assert {member for member in vars(getattr(_percuss, name)) if not member.startswith("__")} <= set(members), name
    assert set(named) | {"version"} == {name for name in dir(_percuss) if not name.startswith("__")}


def test_help_shows_a_plain_signature():
    with contextlib.redirect_stdout(io.StringIO()) as shown:
        help(percuss.models.shell)
    first = shown.getvalue().splitlines()[2]
    assert first.startswith("shell(*, outer_diameter=None, wall=None,"), first


def test_help_introduces_the_package():
    with contextlib.redirect_stdout(io.StringIO()) as shown:
        help(percuss)
    text = shown.getvalue()
    for word in ("percuss.synth", "percuss.analyze", "to_dict()", "InputError", "metrics", "models", "(modes,)"):
        assert word in text


def test_examples_in_docstrings_are_correct():
    finder, runner = doctest.DocTestFinder(), doctest.DocTestRunner(verbose=False)
    tests = [test for name, one in [("percuss", percuss), ("models", percuss.models), ("metrics", percuss.metrics)]
             for test in finder.find(one, name, extraglobs={"percuss": percuss})]  # fmt: skip
    tests += [test for one in percuss.__all__ for test in finder.find(getattr(percuss, one), one, module=False, globs={"percuss": percuss})]
    examples = 0
    for test in tests:
        examples += len(test.examples)
        runner.run(test)
    assert runner.failures == 0 and examples > 40


def test_the_tutorial_is_correct(tmp_path, monkeypatch):
    """Runs its >>> blocks in order in an empty folder."""
    monkeypatch.chdir(tmp_path)
    blocks = re.findall(r"^```python\n(.*?)^```", TUTORIAL.read_text(), re.S | re.M)
    assert len(blocks) >= 12 and all(block.startswith(">>> ") for block in blocks)
    test = doctest.DocTestParser().get_doctest("\n".join(blocks), {}, "tutorial-python.md", str(TUTORIAL), 0)
    runner = doctest.DocTestRunner(optionflags=doctest.ELLIPSIS | doctest.NORMALIZE_WHITESPACE)
    runner.run(test)
    assert runner.failures == 0


def test_notebooks_show_a_table_without_scripts(bat):
    found = percuss.analyze(bat.record, band=(60, 3200))
    html = found._repr_html_()
    assert html.count("<tr>") == 4 and "±" in html and "bending 1" in html
    assert "<script" not in html and "http" not in html
    assert percuss.models.beam(support="free")._repr_html_().count("<table>") >= 1
    assert percuss.survey(percuss.synth("roving-barrel").record, band=(60, 3200), effort="quick")._repr_html_()
    named = percuss.Frf(found.frf().frequency_hz, found.frf().H, names=["<b>", "y"])._repr_html_()
    assert named.count("<tr>") == 3 and "&lt;b&gt;" in named


def test_the_package_is_marked_as_typed():
    assert (pathlib.Path(percuss.__file__).parent / "py.typed").exists()


@pytest.mark.parametrize("name", ["deflect", "calibrate"])
def test_functions_that_refuse_frfs_do_not_offer_them(name, bat):
    function, options = getattr(percuss, name), {"mass": 1.0} if name == "calibrate" else {}
    with pytest.raises(percuss.InputError, match="FRFs"):
        function(percuss.analyze(bat.record, band=(60, 3200)).frf(), **options)
    data = " ".join(function.__doc__.split()).partition("*data : ")[2].partition("still computes.")[0]
    assert data.startswith("path, array or Record Files") and "FRF" not in data
