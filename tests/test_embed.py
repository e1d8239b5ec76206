"""The examples of other people's builds are short, and those build whose tools every checkout has."""

import subprocess
import sys
from pathlib import Path

import pytest
from tools import needs

EMBED = Path(__file__).parent.parent / "examples" / "embed"


FLIES = ("freertos",)  # the live loop, with interrupts and tasks


def test_each_example_is_short():
    for folder in EMBED.iterdir():
        if folder.is_dir() and folder.name != "__pycache__":
            lines = sum(len(path.read_text().splitlines()) for path in folder.rglob("*.*") if path.suffix != ".pyc")
            assert 0 < lines <= (160 if folder.name in FLIES else 60), folder.name


@needs("g++")
@pytest.mark.parametrize("place", ["px4", "ctypes"])
def test_an_example_is_built_and_runs(place):
    done = subprocess.run([sys.executable, EMBED / "build.py", place], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert "runs" in done.stdout
