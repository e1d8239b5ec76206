"""Where the recorded data is: under BORESIGHT_DATA, or in shared/data beside the checkout."""

import os
from pathlib import Path

import pytest


def real_recording(name):
    """The path of a recording.  Without it the test is skipped, but fails where CI is true: there it must run."""
    folder = Path(os.environ.get("BORESIGHT_DATA") or Path(__file__).parents[2] / "shared" / "data")
    if not (folder / name).is_file():
        missing = f"{name} is not under {folder}; set BORESIGHT_DATA"
        if os.environ.get("CI", "").lower() == "true":
            pytest.fail(missing)
        pytest.skip(missing)
    return folder / name
