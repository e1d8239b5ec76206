"""Public recordings: an excerpt of each flies here, and the whole file where BORESIGHT_DATA has it.

The excerpts and their credits are in examples/recordings; the figures of their authors stand in docs/recordings.md.
"""

import runpy

import numpy as np
import pytest
from conftest import ROOT
from scipy.io import loadmat
from scipy.stats import chi2
from tools import real_recording

from boresight.runtime.library import load
from boresight.runtime.recording import check, read
from boresight.studies.replays import stationary, zero_velocity

EXCERPTS = ROOT / "examples" / "recordings"
CLOSED_BY_ITS_AUTHORS_M = 0.082
WALK = ("Time (s)", [f"Gyroscope {axis} (deg/s)" for axis in "XYZ"], [f"Accelerometer {axis} (g)" for axis in "XYZ"])


@pytest.fixture(scope="module")
def models(compiled_once):
    return load("azimuth-hold"), load("strapdown")


def described(tmp_path, excerpt, whole, *replaced):
    """The description of an excerpt, or that of its whole file."""
    path = EXCERPTS / f"{excerpt}.toml"
    if whole is None:
        return path
    text = path.read_text()
    for old, new in (*replaced, (f'file = "{excerpt}.{"mat" if excerpt == "breaks" else "npz"}"', f'file = "{whole}"')):
        assert old in text, old
        text = text.replace(old, new)
    out = tmp_path / f"{excerpt}.toml"
    out.write_text(text)
    return out


def test_the_excerpts_are_small_and_credited():
    files = [path for path in EXCERPTS.iterdir() if path.suffix in (".npz", ".mat", ".ulg")]
    credits = (EXCERPTS / "CREDITS.txt").read_text()
    assert sum(path.stat().st_size for path in files) < 600_000 and len(files) == 3
    assert all(path.name in credits for path in files)


@pytest.mark.parametrize("whole", [False, True])
def test_the_closed_walk_closes(models, tmp_path, whole):
    """25 m in 16 strides; what is left over is height, of which nothing is measured."""
    names = {"time_us": WALK[0], "gyro_deg_s": WALK[1], "accel_g": WALK[2]}
    replaced = [(f'columns = "{old}"', f"columns = {str(new) if isinstance(new, list) else repr(new)}")
                for old, new in names.items()] + [('unit = "us"', 'unit = "s"')]  # fmt: skip
    file = real_recording("xio_foot_short_walk.csv") if whole else None
    recording = read(described(tmp_path, "walk", file, *replaced))
    assert "205 equal rows" in recording.left_out[0]
    assert [one for one in check(recording) if one.level == "error"] == []
    result = zero_velocity.run(recording, *models, **recording.stops)
    assert 24 < result["path_m"] < 26
    end = result["history"]["track_m"][-1]
    assert np.hypot(*end[:2]) < 1.5 * CLOSED_BY_ITS_AUTHORS_M
    assert result["end_from_start_m"] < 3 * CLOSED_BY_ITS_AUTHORS_M and abs(end[2]) > np.hypot(*end[:2])
    n = len(result["stops"])
    low, high = chi2.ppf([0.005, 0.995], 3 * n) / n
    assert n >= 16 and low < result["nis_mean"] < high


@pytest.mark.parametrize("whole", [False, True])
def test_rest_is_declared_where_its_label_says_so(tmp_path, whole):
    """The trial has no column of times; the likelihood ratio beside the label, row by row."""
    file = real_recording("broad_14_slow_translation_with_breaks_B.mat") if whole else None
    recording = read(described(tmp_path, "breaks", file))
    moves = loadmat(file or EXCERPTS / "breaks.mat", squeeze_me=True)["movement"] > 0
    assert len(moves) == len(recording.imu.time)
    rest, window = recording.stops["rest"], recording.stops["window"]
    found = stationary.run(recording, rest=rest, window=window)["history"]["rest"]["likelihood_ratio"]
    # a label is set by eye: half a second on either side of its edges is left out
    edge = round(0.5 / recording.imu.dt)
    near = np.convolve(np.abs(np.diff(moves.astype(int), prepend=moves[0])), np.ones(2 * edge + 1), "same") > 0
    near[:window] = True
    assert found[moves & ~near].mean() < 1e-3 and found[~moves & ~near].mean() > 0.9


@pytest.fixture(scope="module")
def script(compiled_once):
    return runpy.run_path(str(ROOT / "examples" / "fly_autopilot_log.py"))


@pytest.mark.parametrize("whole", [False, True])
def test_the_autopilot_flies_a_log_as_well_as_the_logs_own_estimator(script, tmp_path, whole):
    """By the log's own parameters: as near to the ground truth as ekf2, and no more confident."""
    file = real_recording("pyulog_sample_tagged.ulg") if whole else EXCERPTS / "pad.ulg"
    of = script["flown"](file, tmp_path / "generated")
    size, ratio = {}, {}
    for name, (times, off, sigma) in of.items():
        use = times > 2.0
        for quantity, (part, _) in script["JUDGED"].items():
            size[name, quantity] = np.sqrt(np.mean(off[use, part] ** 2))
            ratio[name, quantity] = np.sqrt(np.mean((off[use, part] / sigma[use, part]) ** 2))
    theirs = "ekf2 (PX4)"
    assert size["autopilot", "attitude"] < 1.1 * size[theirs, "attitude"] < np.radians(0.2)
    assert size["autopilot", "velocity"] < 1.1 * size[theirs, "velocity"] < 2e-3
    assert size["autopilot", "position"] < 0.015
    assert all(0.01 < ratio["autopilot", quantity] < 1 for quantity in script["JUDGED"])
    report = script["report"](of, since=2.0)
    assert f"{np.degrees(size[theirs, 'attitude']):.4f} deg" in report
    assert script["draw"](of, tmp_path / "log.png").stat().st_size > 20_000
