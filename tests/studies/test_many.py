"""Transfer alignments at sea by the thousand: the flights, and the command that flies them."""

import json
import os
import signal
import subprocess
import sys
import time
from dataclasses import replace

import numpy as np
import pandas as pd
import pyarrow.parquet as parquet
import pytest
from conftest import ROOT

from boresight import BoresightError, cli
from boresight.runtime import compiler, random, store, summary
from boresight.runtime import runs as r
from boresight.runtime.library import load
from boresight.runtime.simulation import hull
from boresight.runtime.simulation import sea as waves
from boresight.runtime.units import DEG, MIL
from boresight.studies.sea_state import flight
from boresight.studies.sea_state import many as sea

SHORT = flight.Scenario(covariance_hz=1, seconds=12)
RUNS = 256
WIDEST = compiler.lanes()
SMALL_BLOCK = 16  # runs of a file, where it is the files that matter


@pytest.fixture(scope="module")
def slope():
    """Runs of 60 s over one motion."""
    return r.many(sea.experiment(sea.Sea("slope", 5)), runs=RUNS, seed=3, chunk=256)


@pytest.fixture
def small_blocks(monkeypatch):
    for module in (store, r, summary):
        monkeypatch.setattr(module, "BLOCK", SMALL_BLOCK)


def python(code, *words):
    """A command of Python that compiles as this process does, and whose blocks are small."""
    begin = (
        "from boresight.runtime import compiler, store\n"
        f"compiler.FLAGS, compiler.LANES, store.BLOCK = {compiler.FLAGS!r}, {compiler.LANES!r}, {SMALL_BLOCK}\n"
    )
    return [sys.executable, "-c", begin + code, *words]


def test_the_filter_is_consistent_and_its_intervals_say_so(slope):
    for name, expected in (("nees", 16.0), ("nis", 6.0)):
        column = slope.columns[name]
        low, high = column["interval"]
        spread = (high - low) / 2
        assert column["expected"] == expected
        # 3 sigma, and a part of the second order
        assert abs(column["mean"] - expected) < 1.5 * spread + 0.01 * expected
    assert slope.lost == 0
    said = slope.report()
    assert "nees" in said and "16 of a consistent filter" in said and "6 of a consistent filter" in said
    for name in ("phi_d", "d_tau", "dmu_z"):
        ratio = slope.columns[name]["sd"] / slope.columns[f"sigma_{name}"]["mean"]
        assert abs(ratio - 1) < 3.2 / np.sqrt(2 * RUNS), name  # 3.2 sigma of a standard deviation


def test_the_heading_is_as_good_as_that_of_the_study_s_own_filter(slope):
    """`flight.fly` over the same motion, with biases and noise of its own: the mean of |heading error| of 100 runs."""
    s = replace(sea.Sea().scenario, height_m=(flight.HEIGHT_M[4],))
    flown = flight.fly(load(sea.MODEL), "slope", s, runs=100, seed=8, belief=flight.Belief())
    other = np.abs(flown.heading[-1]) / MIL
    column = slope.columns["heading_mil"]
    spread = np.hypot(other.std(ddof=1) / 10, column["sd"] / np.sqrt(RUNS))
    assert abs(other.mean() - column["mean"]) < 3 * spread


@pytest.mark.parametrize("motion", ["wave", "slope", "sea"])
def test_one_hash_in_chunks_lanes_and_processes_of_any_number(motion, monkeypatch):
    """Of the final states and of their summaries; in a random sea over two of its seas."""
    monkeypatch.setattr(sea, "TOGETHER", 64)
    kind = sea.experiment(sea.Sea(motion, 4, SHORT))

    def digest(chunk, lanes, jobs):
        monkeypatch.setattr(compiler, "lanes", lambda: lanes)
        r._library.cache_clear()
        return r.many(kind, runs=100, seed=1, chunk=chunk, jobs=jobs).digest

    ways = [(256, WIDEST, 1), (33, 2, 1), (64, WIDEST, 2)]
    ways += [(1, WIDEST, 2), (7, 2, 1)] if motion == "slope" else []
    found = {way: digest(*way) for way in ways}
    r._library.cache_clear()
    assert len(set(found.values())) == 1, found
    alone = sea.fly(load(sea.MODEL), kind.settings, 1, range(90, 91))
    np.testing.assert_array_equal(alone, r.many(kind, runs=100, seed=1).values[[90]])


KILLED = """
import os, signal
from pathlib import Path
from boresight.runtime import compiler
from boresight.runtime import runs as r
from boresight.studies.sea_state import many as sea
from boresight.studies.sea_state import flight

def killed(done, total, text):
    if list(Path({folder!r}).glob("runs/block-*")):
        os.kill(os.getpid(), signal.SIGKILL)

kind = sea.experiment(sea.Sea("slope", 4, flight.Scenario(covariance_hz=1, seconds=12)))
r.many(kind, runs=150, seed=1, chunk=8, jobs={jobs}, directory={folder!r}, progress=killed)
"""


@pytest.mark.parametrize("jobs", [1, 2])
def test_killed_and_resumed_the_hash_is_the_same(jobs, tmp_path, small_blocks):
    code = KILLED.format(jobs=jobs, folder=str(tmp_path))
    done = subprocess.run(python(code), env={**os.environ, "PYTHONPATH": str(ROOT)}, check=False)
    assert done.returncode == -signal.SIGKILL
    (block,) = (tmp_path / "runs").glob("block-*")
    held = parquet.read_metadata(block).num_rows
    kind, flown = sea.experiment(sea.Sea("slope", 4, SHORT)), []
    whole = r.many(kind, runs=150, seed=1, directory=tmp_path, progress=lambda *now: flown.append(now[0]))
    assert flown[0] > held > 0 and flown[-1] == 150  # what the first block holds is not flown again
    assert whole.digest == r.many(kind, runs=150, seed=1).digest


def test_the_final_states_are_the_same_in_lanes_of_another_width():
    """That each width has the bits of the scalar functions is shown in tests/runtime/test_lanes.py."""
    kind = sea.Sea("slope", 4, SHORT)
    narrow, wide = (sea.fly(load(sea.MODEL, lanes=lanes), kind, 1, range(21)) for lanes in (2, WIDEST))
    np.testing.assert_array_equal(narrow, wide)


def by_numpy(at, seed, number):
    """The scenario and the motion of hull.py, with the phases that truth.c draws for a sea."""
    s = replace(at.scenario, height_m=(at.scenario.height_m[at.grade - 1],))
    if at.motion != "sea":
        return s, flight.motion_of(at.motion, s, [])
    part = (random.words(seed, [number], 120, stream=3) >> np.uint64(11)) * 2.0**-53
    omega, elevation = waves.components(np.array(s.height_m), gamma=s.spectrum_gamma)
    heading = np.array(s.heading_deg * DEG)
    towards = heading + s.waves_deg * DEG
    return s, hull.in_sea(hull.Hull(), omega, elevation, 2 * np.pi * part[:, None], towards=towards, heading=heading,
                          speed=s.speed_m_s)  # fmt: skip


@pytest.mark.parametrize(
    ("motion", "given"),
    [("wave", {}), ("slope", {}), ("sea", {}), ("sea", {"spectrum_gamma": 3.3, "speed_m_s": 5.0})],
)
def test_the_truth_in_c_is_that_of_the_hull_and_of_the_start_of_a_filter(motion, given):
    """hull.py, sea.py, inertial.py and transfer.first know nothing of it.  It leaves out what an error of the lever arm
    does by the Earth's rate, (7e-6 m/s)^2."""
    at = sea.Sea(motion, 4, replace(SHORT, **given))
    true, model = sea.shared(at, 4, 3), load(sea.MODEL)
    s, moving = by_numpy(at, 4, 3)
    none = np.zeros((1, 3))
    wanted = flight.truth(model, moving, s, flight.Drawn(true.delays, none, none, np.zeros((1, 1, 3, 3)), ()))
    ideal = np.concatenate([wanted.dtheta, wanted.dv], axis=-1)[:, 0, 0]
    np.testing.assert_allclose(true.ideal.reshape(-1, 6)[:, ::-1], ideal, rtol=0, atol=1e-14)
    np.testing.assert_allclose(true.v_n, wanted.slave.v_n[-1, 0, 0], rtol=0, atol=1e-13)
    np.testing.assert_allclose(true.q_b2n_wxyz, wanted.slave.q_b2n_wxyz[-1, 0, 0], rtol=0, atol=1e-14)
    poses = np.concatenate([wanted.master.v_n, wanted.master.q_b2n_wxyz], axis=-1)[:, 0]
    np.testing.assert_allclose(true.master, np.moveaxis(poses, 1, 0), rtol=0, atol=1e-13)
    first = true.master[0, 0]
    _, P = flight.begin(model, s, flight.Belief(), v_m_n=first[:3], q_m2n_wxyz=first[3:], position=true.position)
    np.testing.assert_allclose(true.P, P, rtol=0, atol=1e-10)
    np.testing.assert_allclose(true.swing, np.cross(wanted.dtheta[0, 0, 0] * s.navigation_hz, s.lever_b), atol=1e-12)


def test_a_motion_that_no_sensor_follows_is_one_line():
    wild = sea.Sea("slope", 6, replace(SHORT, frequency_hz=40.0))
    with pytest.raises(BoresightError, match="no sensor increments make this motion in sea state 6"):
        sea.shared(wild, 1, 0)


@pytest.mark.parametrize("motion", ["slope", "sea"])
def test_the_late_master_is_where_the_hull_was(motion):
    """The polynomial in the delay against the hull itself."""
    at = sea.Sea(motion, 1 if motion == "sea" else 6, SHORT)  # short waves, steep waves
    true, delay = sea.shared(at, 4, 3), np.array([0.005, 0.0061, 0.0083, 0.01])
    pose = hull.ride(by_numpy(at, 4, 3)[1], np.arange(13.0)[:, None, None] - delay)
    v, q = sea.late(true, delay)
    np.testing.assert_allclose(v, pose.v_n[:, 0], atol=1e-10)
    np.testing.assert_allclose(q, pose.q_b2n_wxyz[:, 0], atol=1e-11)


def test_runs_of_one_sea_are_neighbours_and_seas_differ():
    kind = sea.Sea("sea", 4, SHORT)
    first, second = (sea.shared(kind, 1, number) for number in (0, 1))
    assert np.abs(first.ideal - second.ideal).max() > 1e-4
    assert sea.shared(kind, 1, 0) is first and np.abs(sea.shared(kind, 2, 0).ideal - first.ideal).max() > 1e-4


def said(capsys, *words):
    with pytest.raises(SystemExit) as ended:
        cli.main(["many", *words])
    return ended.value.code, *capsys.readouterr()


def test_the_command_flies_keeps_and_goes_on(capsys, tmp_path):
    words = ["--motion", "wave", "--grade", "3", "--seed", "2", "-o", str(tmp_path)]
    code, out, _ = said(capsys, *words, "--runs", "40", "--json")
    first = json.loads(out)
    assert code == 0 and first["runs"] == 40 and first["seed"] == 2 and first["reached"] is None
    assert set(first["percentiles"]["heading_mil"]) == {"50", "95", "99"}
    code, out, _ = said(capsys, *words, "--runs", "60")
    assert code == 0 and "60 runs, seed 2" in out and "SHA-256" in out
    code, out, _ = said(capsys, *words, "--runs", "40", "--json")
    assert json.loads(out) == first
    code, out, err = said(capsys, "--motion", "slope", "--seed", "2", "-o", str(tmp_path))
    assert code == 1 and not out and err.count("\n") == 1 and "another motion: wave there, slope here" in err


@pytest.mark.parametrize(
    ("words", "says"),
    [
        (["--motion", "heave"], "no motion 'heave'; there are wave, slope, sea"),
        (["--grade", "7"], "no sea state 7; there are 1, 2, 3, 4, 5, 6"),
        (["--runs", "0"], "runs is 0"),
        (["--within", "-1"], "width above 0"),
        (["-o", ""], "directory is ''; give a folder"),
    ],
)
def test_what_has_no_meaning_is_refused_in_one_line(capsys, tmp_path, monkeypatch, words, says):
    monkeypatch.chdir(tmp_path)
    code, out, err = said(capsys, *words)
    assert code == 1 and not out and err.count("\n") == 1 and says in err
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("jobs", ["1", "2"])
def test_ctrl_c_says_how_many_runs_are_kept_and_exits_130(tmp_path, jobs):
    """The command itself, in a process of its own: what parses its words has a handler of its own for Ctrl-C."""
    words = ["many", "--motion", "slope", "--runs", "1000000", "--jobs", jobs, "-o", str(tmp_path)]
    command = python("from boresight import cli; cli.main()", *words)
    with subprocess.Popen(command, cwd=ROOT, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as process:
        try:
            deadline = time.monotonic() + 120
            while not list(tmp_path.glob("runs/block-*.parquet")):
                assert process.poll() is None and time.monotonic() < deadline
                time.sleep(0.01)
            process.send_signal(signal.SIGINT)
            out, err = process.communicate(timeout=120)
        finally:
            process.kill()
    kept = sum(len(pd.read_parquet(path)) for path in tmp_path.glob("runs/block-*.parquet"))
    assert err == f"boresight: interrupted; {kept} runs are flown and kept in {tmp_path}\n"
    assert process.returncode == 130 and not out and kept >= SMALL_BLOCK


def test_a_goal_that_is_not_reached_exits_1(capsys):
    code, out, _ = said(capsys, "--motion", "wave", "--runs", "30", "--within", "1e-6")
    assert code == 1 and "NOT reached" in out


def test_a_scenario_that_the_flights_do_not_know_is_refused():
    with pytest.raises(BoresightError, match="bending_mrad"):
        sea.experiment(sea.Sea(scenario=replace(SHORT, bending_mrad=1.0)))
