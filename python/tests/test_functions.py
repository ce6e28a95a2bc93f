"""The functions stand in the source with their types, and agree with the declarations of the command line."""

import ast
import inspect
import shutil
import subprocess
import sys
import typing

import pytest

import percuss
from conftest import SOURCE

sys.path.append(str(SOURCE / "python" / "scripts"))
import make_functions  # noqa: E402

PACKAGE = SOURCE / "python" / "percuss"
NAMES = [one.name for one in make_functions.FUNCTIONS]


def test_the_sources_are_up_to_date():
    made = make_functions.modules()
    assert {one.name for one in (PACKAGE / "_functions").glob("*.py")} == set(made)
    for name, text in made.items():
        assert (PACKAGE / "_functions" / name).read_text() == text, f"{name}: run python/scripts/make_functions.py"


def test_every_command_has_its_function():
    """Except the commands of a shell: batches, conversion (write), completion, manual pages, devices and recording."""
    commands = {one for one in make_functions.declared() if not one.startswith("batch")}
    assert commands - {one.command for one in make_functions.FUNCTIONS} == {"convert", "completion", "man", "devices", "record"}


def test_the_module_uses_the_stable_interface_of_python():
    """Then one binary serves CPython 3.9 and later; the compiler refuses other functions (Py_LIMITED_API)."""
    from percuss import _percuss

    assert _percuss.__file__.endswith(".abi3.so") and "Py_LIMITED_API 0x03090000" in (SOURCE / "python" / "objects.hpp").read_text()


def test_no_public_function_takes_any_keyword():
    for path in [PACKAGE / "__init__.py", *PACKAGE.glob("[a-z]*.py"), *(PACKAGE / "_functions").glob("*.py")]:
        for one in ast.walk(ast.parse(path.read_text())):
            if isinstance(one, ast.FunctionDef):
                assert one.args.kwarg is None, f"{path.name}: {one.name} takes **{one.args.kwarg.arg}"
                given = one.args.posonlyargs + one.args.args + one.args.kwonlyargs + [one.args.vararg] * bool(one.args.vararg)
                assert all(part.annotation is not None for part in given), f"{path.name}: {one.name} lacks types"


@pytest.mark.parametrize("name", NAMES)
def test_signatures_are_explicit(name):
    function = getattr(sys.modules["percuss." + name.rpartition(".")[0]] if "." in name else percuss, name.rpartition(".")[2])
    parameters = inspect.signature(function).parameters
    assert not any(one.kind is one.VAR_KEYWORD for one in parameters.values())
    if sys.version_info >= (3, 10):  # which has X | None
        assert set(parameters) <= set(typing.get_type_hints(function))  # the types can be resolved
    assert function.__module__.startswith("percuss") and "_functions" not in function.__module__


def test_types_are_right_for_a_checker(tmp_path):
    """A program with right calls passes a type checker; one with wrong calls does not."""
    if shutil.which("mypy") is None:
        pytest.skip("no mypy")
    (tmp_path / "right.py").write_text(
        "import percuss\n"
        'found: percuss.Analysis = percuss.analyze("a.h5", band=(60, 3200), effort="quick", accept_hit=[1, 2])\n'
        "test: percuss.Synthetic = percuss.synth({'modes': []}, seed=1)\n"
        "beam: percuss.Result = percuss.models.beam(length='33in', support='free')\n"
    )
    (tmp_path / "wrong.py").write_text('import percuss\npercuss.analyze("a.h5", bnd=(60, 3200))\npercuss.analyze("a.h5", effort="bst")\n')
    ran = subprocess.run(["mypy", "--no-incremental", "--follow-imports=silent", "--ignore-missing-imports", "right.py", "wrong.py"],
                         cwd=tmp_path, env={"MYPYPATH": str(PACKAGE.parent), "PATH": "/usr/bin:/bin"}, capture_output=True, text=True, check=False)  # fmt: skip
    assert "right.py" not in ran.stdout and ran.stdout.count("wrong.py:2: error") == ran.stdout.count("wrong.py:3: error") == 1, ran.stdout
    assert '"bnd"' in ran.stdout and '"effort"' in ran.stdout


def test_repeated_calls_take_the_options_that_they_are_given(bat):
    """A call with the words of the last call does not parse them again. Calls with other words take their own options."""
    calls = [{"only": "hits"}, {"only": "hits"}, {"only": ["hits", "frf"]}, {"only": "hits"}, {"only": "hits", "reject_hit": 1}]
    first = [percuss.analyze(bat, threads=1, **options).json for options in calls]
    assert first[0] == first[1] == first[3]
    assert len(set(first)) == 3
    with pytest.raises(percuss.UsageError):
        percuss.analyze(bat, threads=1, only="nothing")
    assert [percuss.analyze(bat, threads=1, **options).json for options in calls] == first
