"""Stubs, docstrings and the tutorial agree with the module."""

import ast
import contextlib
import doctest
import inspect
import io
import pathlib
import re
import sys

import pytest

import percuss
from conftest import SOURCE

sys.path.append(str(SOURCE / "python" / "scripts"))
import make_stubs  # noqa: E402

PACKAGE = SOURCE / "python" / "percuss"
TUTORIAL = SOURCE / "docs" / "tutorials" / "python.md"
MODULES = {"__init__": percuss, "models": percuss.models, "metrics": percuss.metrics}
FUNCTIONS = [(name, one) for module in MODULES.values() for name, one in vars(module).items()
             if inspect.isfunction(one) and name in module.__all__]  # fmt: skip


@pytest.mark.parametrize("name", MODULES)
def test_stubs_agree_with_the_declarations(name):
    assert (PACKAGE / f"{name}.pyi").read_text() == make_stubs.stubs()[f"{name}.pyi"], "run python/scripts/make_stubs.py"


@pytest.mark.parametrize("name", MODULES)
def test_stubs_declare_all_functions(name):
    tree = ast.parse((PACKAGE / f"{name}.pyi").read_text())
    functions = {one.name: one for one in tree.body if isinstance(one, ast.FunctionDef)}
    imported = {alias.asname for one in tree.body if isinstance(one, ast.ImportFrom) for alias in one.names if alias.asname}
    assert functions.keys() | imported >= set(MODULES[name].__all__)
    for function, stub in functions.items():
        arguments = stub.args
        stubbed = [one.arg for one in arguments.posonlyargs + arguments.args] + ([arguments.vararg.arg] if arguments.vararg else [])
        stubbed += [one.arg for one in arguments.kwonlyargs]
        assert stubbed == list(inspect.signature(getattr(MODULES[name], function)).parameters), function


def test_the_compiled_part_agrees_with_its_stub():
    from percuss import _percuss

    tree = ast.parse((PACKAGE / "_percuss.pyi").read_text())
    for one in tree.body:
        if isinstance(one, (ast.FunctionDef, ast.ClassDef)):
            made = getattr(_percuss, one.name)
            members = [part.name for part in getattr(one, "body", []) if isinstance(part, ast.FunctionDef)]
            assert all(hasattr(made, member) for member in members), one.name
    named = {one.name for one in tree.body if isinstance(one, (ast.FunctionDef, ast.ClassDef))} | {"version"}
    assert named == {name for name in dir(_percuss) if not name.startswith("__")}


@pytest.mark.parametrize("name, function", FUNCTIONS, ids=[name for name, _ in FUNCTIONS])
def test_docstrings_name_every_keyword(name, function):
    text = inspect.getdoc(function)
    assert text and len(text) > 200, name
    for keyword in inspect.signature(function).parameters:
        assert re.search(rf"\b{keyword}\b", text), f"{name} says nothing of {keyword}"
    assert "Returns" in text and "Raises" in text or ">>>" in text, name


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
    html = percuss.analyze(bat.record, band=(60, 3200))._repr_html_()
    assert html.count("<tr>") == 4 and "±" in html and "bending 1" in html
    assert "<script" not in html and "http" not in html
    assert percuss.models.beam(support="free")._repr_html_().count("<table>") >= 1
    assert percuss.survey(percuss.synth("roving-barrel").record, band=(60, 3200), effort="quick")._repr_html_()


def test_the_package_is_marked_as_typed():
    assert (pathlib.Path(percuss.__file__).parent / "py.typed").exists()
