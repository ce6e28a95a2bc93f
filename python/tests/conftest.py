"""The tool beside the module: PERCUSS names it, and PYTHONPATH the folder that holds the package."""

import json
import os
import pathlib
import subprocess

import pytest

import percuss

SOURCE = pathlib.Path(__file__).resolve().parents[2]
TOOL = pathlib.Path(os.environ.get("PERCUSS", pathlib.Path(percuss.__file__).parents[2] / "tools" / "percuss"))


class Tool:
    """Runs the command line in a folder."""

    def __init__(self, folder):
        self.folder = folder

    def __call__(self, *words):
        return subprocess.run([TOOL, *map(str, words)], cwd=self.folder, capture_output=True, text=True, check=False)

    def document(self, *words):
        """What --json prints, as text."""
        ran = self(*words, "--json")
        assert ran.stdout, ran.stderr
        json.loads(ran.stdout)
        return ran.stdout

    def complaint(self, *words):
        """The line on standard error, without the program's name."""
        ran = self(*words, "--json")
        assert ran.returncode in (2, 3, 4), ran
        assert ran.stderr.startswith("percuss: ") and ran.stderr.count("\n") == 1, ran.stderr
        return ran.stderr.removeprefix("percuss: ").rstrip("\n")


@pytest.fixture
def tool(tmp_path, monkeypatch):
    """The command line in an empty folder, which is Python's as well."""
    monkeypatch.chdir(tmp_path)
    return Tool(tmp_path)


@pytest.fixture(scope="session")
def bat():
    """A made-up test in memory."""
    return percuss.synth("wood-bat")
