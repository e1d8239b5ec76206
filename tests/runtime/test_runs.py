"""Very many runs: what they say depends on the seed alone, and nothing that was flown is lost."""

import hashlib
import json
import multiprocessing
import os
import shlex
import signal
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest
from conftest import ROOT

from boresight import BoresightError
from boresight.runtime import runs as r
from boresight.runtime import store, summary
from boresight.runtime.library import load

MODEL = "euler-matching"
COLUMNS = {"a": "m", "b": "", "phi": "rad"}


def walk(library, settings, seed, runs):
    """A small flight: numbers of each run, and one of the model's functions."""
    time.sleep(settings.get("slow_s", 0.0) * len(runs))
    drawn = np.array([np.random.Generator(np.random.Philox(key=[seed, run])).standard_normal(3) for run in runs])
    drawn[:, 0] = 1e3 + settings["scale"] * drawn[:, 0]
    euler = library.euler_angles(q_b2n_wxyz=np.array([1.0, 0, 0, 0]) + 0.01 * np.abs(drawn[:, [2]]) * [0, 1, 0, 0])
    drawn[:, 2] = euler[:, 0]
    for i, run in enumerate(runs):
        if run in settings.get("lost", ()):
            drawn[i] = np.inf
    return drawn


def experiment(**settings):
    return r.Experiment(
        "walk", MODEL, COLUMNS, walk, {"scale": 2.0} | settings, expected={"b": 0.0}, percentiles=("a",)
    )


@pytest.fixture(scope="module")
def plainly():
    """3000 runs, in one chunk of each block."""
    return r.many(experiment(), runs=3000, seed=5, chunk=store.BLOCK)


@pytest.mark.parametrize(("chunk", "jobs"), [(1, 1), (7, 1), (64, 1), (256, 1), (7, 2), (64, 2)])
def test_the_digest_depends_on_the_seed_alone(plainly, chunk, jobs):
    assert r.many(experiment(), runs=3000, seed=5, chunk=chunk, jobs=jobs) == plainly
    assert r.many(experiment(), runs=3000, seed=6, chunk=256).digest != plainly.digest


def test_the_summaries_are_those_of_the_values(plainly):
    values = plainly.values
    assert values.shape == (3000, 3)
    for i, (name, column) in enumerate(plainly.columns.items()):
        own = values[:, i]
        assert column["unit"] == COLUMNS[name]
        np.testing.assert_allclose(
            [column["mean"], column["sd"]], [own.mean(), own.std(ddof=1)], rtol=1e-13, atol=1e-15
        )
        assert (column["least"], column["largest"]) == (own.min(), own.max())
        half = 1.96 * own.std(ddof=1) / np.sqrt(3000)
        np.testing.assert_allclose(column["interval"], own.mean() + np.array([-half, half]), rtol=1e-4)
    for p, (value, low, high) in plainly.percentiles["a"].items():
        np.testing.assert_allclose(value, np.percentile(values[:, 0], float(p)), atol=0.1)
        assert low < value < high
    assert plainly.columns["b"]["expected"] == 0.0 and "expected" not in plainly.columns["a"]


def test_a_sum_keeps_what_a_large_mean_would_hide():
    rows = 1e8 + np.random.default_rng(1).standard_normal((5000, 1))
    whole = summary.Moments.of_runs(rows).whole()
    np.testing.assert_allclose(np.sqrt(whole.square[0, 0] / 4999), np.std(rows, ddof=1), rtol=1e-9)


def test_the_interval_of_a_percentile_holds_it_95_times_of_100(tmp_path):
    """Of an exponential, whose percentiles are known."""
    inside = {50.0: 0, 95.0: 0, 99.0: 0}
    kind = r.Experiment("none", MODEL, {"a": ""}, walk)
    for seed in range(400):
        known = summary.Known(store.Store(None, ["a"], {}), ("a",), kind)
        known.values["a"] = [np.random.default_rng(seed).exponential(size=1024)]
        for p in inside:
            _, low, high = known.percentile("a", p)
            inside[p] += low <= -np.log(1 - p / 100) <= high
    for hits in inside.values():
        assert 0.92 * 400 <= hits <= 0.985 * 400  # 0.95 within 3 sigma below; ranks are rounded outwards


def test_a_run_that_is_lost_is_counted_and_spoils_no_mean():
    found = r.many(experiment(lost=[3, 1500]), runs=2000, seed=5)
    good = np.delete(found.values, [3, 1500], axis=0)
    assert found.lost == 2 and np.isnan(found.values[[3, 1500]]).all()
    np.testing.assert_allclose(found.columns["a"]["mean"], good[:, 0].mean(), rtol=1e-14)
    np.testing.assert_allclose(found.columns["a"]["sd"], good[:, 0].std(ddof=1), rtol=1e-12)
    assert "2 lost" in found.report()
    all_lost = r.many(experiment(lost=list(range(40))), runs=40)
    assert all_lost.lost == 40 and all_lost.columns["a"]["mean"] is None and all_lost.percentiles["a"]["50"][0] is None
    json.dumps(all_lost.document(), allow_nan=False)


# ---- stopping where enough is known


def test_it_stops_where_the_interval_is_narrow_enough_and_no_later(tmp_path):
    goal = r.Goal("a", within=0.12, percentile=95)
    said = []
    found = r.many(
        experiment(), runs=20_000, seed=5, goal=goal, directory=tmp_path, progress=lambda *now: said.append(now)
    )
    _, low, high = found.percentiles["a"]["95"]
    counts = list(r._counts(20_000, goal))
    assert found.reached and (high - low) / 2 <= 0.12 and 1024 < found.runs < 20_000
    assert found.runs in counts and len(list((tmp_path / "runs").iterdir())) == found.runs // store.BLOCK
    fewer = r.many(experiment(), runs=counts[counts.index(found.runs) - 1], seed=5).percentiles["a"]["95"]
    assert (fewer[2] - fewer[1]) / 2 > 0.12
    assert "95 % of a" in said[-1][2] and all(done <= total for done, total, _ in said)
    for chunk, jobs in ((7, 2), (256, 1)):
        assert r.many(experiment(), runs=20_000, seed=5, goal=goal, chunk=chunk, jobs=jobs) == found
    short = r.many(experiment(), runs=2000, seed=5, goal=r.Goal("a", within=1e-3))
    assert short.reached is False and short.runs == 2000 and "NOT reached" in short.report()


# ---- what a directory keeps


def test_the_files_hold_every_run_and_a_second_call_flies_none_of_them(plainly, tmp_path):
    import pandas as pd

    first = r.many(experiment(), runs=1500, seed=5, directory=tmp_path)
    assert first.values is None
    whole = r.many(experiment(), runs=3000, seed=5, chunk=7, directory=tmp_path)
    assert whole == plainly
    kept = pd.read_parquet(tmp_path / "runs").sort_values("run")
    assert (kept["run"] == np.arange(3000)).all()
    np.testing.assert_array_equal(kept[list(COLUMNS)].to_numpy(), plainly.values)
    flown = []
    again = r.many(experiment(), runs=3000, seed=5, directory=tmp_path, progress=lambda *now: flown.append(now))
    assert again == plainly and not flown
    assert r.many(experiment(), runs=1500, seed=5, directory=tmp_path) == first
    assert sorted(path.name for path in (tmp_path / "runs").iterdir()) == [f"block-00000{i}.parquet" for i in range(3)]


@pytest.fixture(scope="module")
def quick_cc(tmp_path_factory):
    """A C compiler for processes of their own, without optimisation as in this one."""
    from boresight.runtime.compiler import compiler

    path = tmp_path_factory.mktemp("cc") / "cc"
    path.write_text(f'#!/bin/sh\nexec {shlex.join(compiler())} "$@" -O0\n')
    path.chmod(0o755)
    return str(path)


SCRIPT = """
import sys
sys.path.insert(0, {tests!r})
from test_runs import experiment, r
print(r.many(experiment(slow_s=5e-4), runs=3000, seed=5, chunk=16, jobs={jobs}, directory={folder!r}).digest)
"""


@pytest.fixture
def begun(quick_cc):
    return lambda folder, jobs: begun_by(quick_cc, folder, jobs)


def begun_by(cc, folder, jobs):
    code = SCRIPT.format(tests=str(Path(__file__).parent), jobs=jobs, folder=str(folder))
    env = {**os.environ, "CC": cc, "PYTHONPATH": os.pathsep.join([str(ROOT), str(ROOT / "tests")])}
    process = subprocess.Popen(
        [sys.executable, "-c", code], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env=env
    )
    deadline = time.monotonic() + 300
    while not list(folder.glob("runs/block-*.parquet")):
        assert process.poll() is None and time.monotonic() < deadline, process.stderr.read()
        time.sleep(0.01)
    return process


@pytest.mark.parametrize("jobs", [1, 2])
@pytest.mark.parametrize("sent", [signal.SIGKILL, signal.SIGINT])
def test_killed_or_interrupted_and_resumed_it_says_the_same(begun, tmp_path, jobs, sent):
    def kept():
        return store.Store(tmp_path, list(COLUMNS), json.loads((tmp_path / "experiment.json").read_text())).held

    process = begun(tmp_path, jobs)
    process.send_signal(sent)
    out, err = process.communicate(timeout=300)
    assert process.returncode and not out
    assert 0 < kept() < 3000
    if sent == signal.SIGINT:
        assert f"{kept()} runs are flown and kept" in err
        assert kept() % store.BLOCK  # what lay between two whole blocks is kept too
    whole = r.many(experiment(slow_s=5e-4), runs=3000, seed=5, directory=tmp_path)
    slowly = r.many(experiment(), runs=3000, seed=5)
    assert whole.digest == slowly.digest
    assert not [path for path in (tmp_path / "runs").iterdir() if not path.name.startswith(".")][3:]


def children(of):
    """Processes whose parent is this one."""
    found = []
    for path in Path("/proc").glob("[0-9]*/stat"):
        try:
            if int(path.read_text().rsplit(")", 1)[1].split()[1]) == of:
                found.append(int(path.parent.name))
        except OSError:
            continue
    return found


def test_processes_do_not_outlive_their_parent(begun, tmp_path):
    process = begun(tmp_path, 2)
    workers = children(process.pid)
    assert len(workers) >= 2
    process.kill()
    process.wait()
    deadline = time.monotonic() + 20
    while any(Path(f"/proc/{pid}").exists() for pid in workers):
        assert time.monotonic() < deadline, "a worker goes on without its parent"
        time.sleep(0.05)


def test_a_process_that_is_killed_ends_it_in_one_line_and_the_next_call_goes_on(plainly, tmp_path):
    def kill(done, total, text):
        if done > 500:
            os.kill(multiprocessing.active_children()[0].pid, signal.SIGKILL)

    kind = experiment(slow_s=1e-3)
    with pytest.raises(BoresightError, match=r"a process was killed, .* the same command goes on") as ended:
        r.many(kind, runs=3000, seed=5, chunk=16, jobs=2, directory=tmp_path, progress=kill)
    assert "\n" not in str(ended.value) and list((tmp_path / "runs").iterdir())
    assert r.many(kind, runs=3000, seed=5, chunk=512, directory=tmp_path).digest == plainly.digest


@pytest.mark.parametrize(
    ("change", "says"),
    [
        ({"seed": 6}, "another seed: 5 there, 6 here"),
        ({"scale": 3.0}, "another scale: 2.0 there, 3.0 here"),
        ({"model": "velocity-dcm"}, "another model"),
        ({"name": "other"}, "another experiment: walk there, other here"),
    ],
)
def test_a_directory_of_something_else_is_refused_in_one_line(tmp_path, change, says):
    r.many(experiment(), runs=30, seed=5, directory=tmp_path)
    before = {path: path.read_bytes() for path in tmp_path.rglob("*") if path.is_file()}
    own = experiment(scale=change.get("scale", 2.0))
    other = r.Experiment(change.get("name", "walk"), change.get("model", MODEL), COLUMNS, walk, own.settings)
    with pytest.raises(BoresightError, match=says) as refused:
        r.many(other, runs=30, seed=change.get("seed", 5), directory=tmp_path)
    assert "\n" not in str(refused.value)
    assert {path: path.read_bytes() for path in tmp_path.rglob("*") if path.is_file()} == before


def cut_off(path):
    path.write_bytes(path.read_bytes()[:-20])


def another_block(path):
    path.write_bytes(path.with_name("block-000000.parquet").read_bytes())


def a_flipped_bit_of_a_value(path):
    content = bytearray(path.read_bytes())
    content[len(content) // 2] ^= 1
    path.write_bytes(content)


def a_footer_that_is_no_thrift(path):
    content = bytearray(path.read_bytes())
    content[-40:-8] = b"\xff" * 32
    path.write_bytes(content)


def a_link_to_nothing(path):
    path.unlink()
    path.symlink_to(path.with_name("nothing"))


def a_folder(path):
    path.unlink()
    path.mkdir()


def words_for_numbers(path):
    import pandas as pd

    pd.read_parquet(path).assign(a="one").to_parquet(path)


DAMAGES = [
    cut_off,
    another_block,
    a_flipped_bit_of_a_value,
    a_footer_that_is_no_thrift,
    a_link_to_nothing,
    a_folder,
    words_for_numbers,
]


@pytest.mark.parametrize("damage", DAMAGES)
def test_a_file_that_is_damaged_is_named_and_what_to_do(tmp_path, damage):
    r.many(experiment(), runs=1500, seed=5, directory=tmp_path)
    damage(tmp_path / "runs" / "block-000001.parquet")
    with pytest.raises(
        BoresightError, match=r"block-000001\.parquet cannot be read \(.+\); delete it, and its"
    ) as refused:
        r.many(experiment(), runs=1500, seed=5, directory=tmp_path)
    assert "\n" not in str(refused.value)


def test_a_file_that_was_damaged_is_deleted_and_its_runs_are_flown_again(plainly, tmp_path):
    r.many(experiment(), runs=3000, seed=5, directory=tmp_path)
    path = tmp_path / "runs" / "block-000001.parquet"
    another_block(path)
    with pytest.raises(BoresightError, match="holds runs of another block"):
        r.many(experiment(), runs=3000, seed=5, directory=tmp_path)
    path.unlink()
    assert r.many(experiment(), runs=3000, seed=5, directory=tmp_path) == plainly


def test_no_byte_of_a_file_changes_unseen(tmp_path):
    """Each byte with a bit flipped: the file is refused, or it gives the same values, of fewer runs at the worst."""
    r.many(experiment(), runs=20, seed=5, directory=tmp_path)
    (path,) = (tmp_path / "runs").iterdir()
    identity = json.loads((tmp_path / "experiment.json").read_text())
    content = path.read_bytes()
    rows = store.Store(tmp_path, list(COLUMNS), identity).block(0)[0]
    refused = 0
    for place in range(len(content)):
        path.write_bytes(content[:place] + bytes([content[place] ^ 1 << place % 8]) + content[place + 1 :])
        try:
            read, there = store.Store(tmp_path, list(COLUMNS), identity).block(0)
        except BoresightError as error:
            assert "block-000000.parquet cannot be read" in str(error) and "\n" not in str(error)
            refused += 1
        else:
            np.testing.assert_array_equal(read[there], rows[there], err_msg=f"byte {place}")
    assert refused > len(COLUMNS) * 20 * 8  # those of the values at the least


def test_files_from_before_there_were_checksums_are_read(plainly, tmp_path):
    import pyarrow.parquet as parquet

    r.many(experiment(), runs=3000, seed=5, directory=tmp_path)
    for path in (tmp_path / "runs").iterdir():
        parquet.write_table(parquet.read_table(path).replace_schema_metadata(), path, compression="none")
    flown = []
    again = r.many(experiment(), runs=3000, seed=5, directory=tmp_path, progress=lambda *now: flown.append(now))
    assert again == plainly and not flown


@pytest.mark.parametrize("name", ["block-foo", "block-1", "block-0000001", "block--00001", "block-000001 (copy)"])
def test_a_file_whose_name_the_store_does_not_write_is_refused_in_one_line(tmp_path, name):
    r.many(experiment(), runs=1500, seed=5, directory=tmp_path)
    path = tmp_path / "runs" / "block-000001.parquet"
    path.with_name(f"{name}.parquet").write_bytes(path.read_bytes())
    with pytest.raises(BoresightError, match="is not one of the files that are written here; move it away") as refused:
        r.many(experiment(), runs=1500, seed=5, directory=tmp_path)
    assert "\n" not in str(refused.value) and f"{name}.parquet" in str(refused.value)


@pytest.mark.parametrize("content", ["[]", "null", "1", "{", "\xff"])
def test_an_experiment_json_that_is_none_is_refused_in_one_line(tmp_path, content):
    r.many(experiment(), runs=30, seed=5, directory=tmp_path)
    (tmp_path / "experiment.json").write_bytes(content.encode("latin-1"))
    with pytest.raises(BoresightError, match=r"experiment\.json cannot be read; choose another folder"):
        r.many(experiment(), runs=30, seed=5, directory=tmp_path)


def test_any_number_of_runs_begins_at_once():
    """What is missing of 2e10 runs is not listed before the first is flown."""

    class Begun(Exception):
        pass

    def begun(done, total, text):
        raise Begun

    with pytest.raises(Begun):
        r.many(experiment(), runs=20_000_000_000, seed=5, progress=begun)


@pytest.mark.parametrize(
    ("asked", "says"),
    [
        ({"runs": 0}, "runs is 0"),
        ({"runs": 10, "chunk": 0}, "chunk is 0"),
        ({"runs": 10, "jobs": 0}, "jobs is 0"),
        ({"runs": 10, "seed": -1}, "seed is -1"),
        ({"runs": 1.5}, "runs is 1.5"),
        ({"runs": 10, "goal": r.Goal("phy", 1.0)}, "no column 'phy' .did you mean 'phi'"),
        ({"runs": 10, "goal": r.Goal("phi", 0.0)}, "width above 0"),
        ({"runs": 10, "directory": ""}, "directory is ''; give a folder"),
        ({"runs": 10, "dask": "tcp://127.0.0.1:9"}, "no Dask scheduler answers"),
    ],
)
def test_what_has_no_meaning_is_refused_in_one_line(monkeypatch, tmp_path, asked, says):
    monkeypatch.chdir(tmp_path)
    from boresight.runtime import cluster

    monkeypatch.setattr(cluster, "CONNECT_S", 1)
    with pytest.raises(BoresightError, match=says) as refused:
        r.many(experiment(), **asked)
    assert "\n" not in str(refused.value) and not list(tmp_path.iterdir())


@pytest.mark.parametrize("address", ["foo", "", "tcp://", "foo:bar", "http://127.0.0.1:9"])
def test_what_is_no_address_is_refused_and_no_client_is_made(monkeypatch, address):
    """A client that fails to begin prints a traceback when Python ends."""
    from boresight.runtime import cluster

    monkeypatch.setattr(cluster, "Client", lambda *given, **named: pytest.fail("a client was made"))
    with pytest.raises(BoresightError, match="no Dask scheduler answers at") as refused:
        r.many(experiment(), runs=10, dask=address)
    assert "\n" not in str(refused.value)


def test_final_states_of_another_shape_are_refused():
    def wrong(library, settings, seed, runs):
        return np.zeros((len(runs), 2))

    with pytest.raises(BoresightError, match=r"shape \(10, 2\) in place of \(10, 3\)"):
        r.many(r.Experiment("walk", MODEL, COLUMNS, wrong), runs=10)


MEMORY = """
import numpy as np
from boresight.runtime import runs as r
from boresight.runtime import store, summary

def fly(library, settings, seed, runs):
    return np.random.Generator(np.random.Philox(key=[seed, runs.start])).standard_normal((len(runs), 35))

for runs in (20_000, 170_000):
    r.many(r.Experiment("e", "euler-matching", {{f"c{{i}}": "" for i in range(35)}}, fly, percentiles=("c0",)),
           runs=runs, chunk=store.BLOCK, directory={folder!r} + str(runs))
    # its own peak: ru_maxrss begins with that of the process which started it
    print(int(next(line for line in open('/proc/self/status') if line.startswith('VmHWM')).split()[1]) / 1024)
"""


def test_memory_does_not_grow_with_the_runs(quick_cc, tmp_path):
    """The values of 150 000 runs more are 42 MB; what is kept of a column with percentiles is 1.2."""
    env = {**os.environ, "CC": quick_cc, "PYTHONPATH": str(ROOT)}
    code = MEMORY.format(folder=str(tmp_path / "runs of "))
    done = subprocess.run([sys.executable, "-c", code], env=env, capture_output=True, text=True, check=True)
    few, many = map(float, done.stdout.split())
    assert many < 500 and many - few < 25, (few, many)  # MB
    assert len(list((tmp_path / "runs of 170000" / "runs").iterdir())) == -(-170_000 // store.BLOCK)


# ---- a cluster


def test_a_cluster_of_two_workers_one_of_which_is_killed_says_the_same(plainly, quick_cc, tmp_path, monkeypatch):
    """The model is one's own: only its files travel, by their hash, and each worker's machine builds them."""
    import shutil

    import distributed

    from boresight.runtime.manifest import folder_of

    own = tmp_path / "own_model"
    shutil.copytree(folder_of(MODEL), own)
    load(own)
    monkeypatch.setenv("BORESIGHT_CACHE", str(tmp_path / "cache of the workers"))
    paths = os.pathsep.join([str(ROOT), str(ROOT / "tests"), str(Path(__file__).parent)])
    monkeypatch.setenv("PYTHONPATH", paths)
    monkeypatch.setenv("CC", quick_cc)
    kind = experiment(slow_s=2e-3)
    kind = r.Experiment(kind.name, own, kind.columns, walk, kind.settings, kind.expected, kind.percentiles)
    with distributed.LocalCluster(
        n_workers=2, threads_per_worker=1, processes=True, dashboard_address=None, silence_logs=50
    ) as cluster:
        pids = [worker.process.pid for worker in cluster.workers.values()]
        killed = []

        def kill(done, total, text):
            if done > 500 and not killed:
                killed.append(pids[0])
                os.kill(pids[0], signal.SIGKILL)

        found = r.many(kind, runs=3000, seed=5, chunk=16, dask=cluster.scheduler_address, progress=kill)
    assert killed and found.digest == plainly.digest
    (travelled,) = (tmp_path / "cache of the workers" / "travelled").iterdir()
    named = hashlib.sha256()
    for name in sorted(str(path.relative_to(travelled)) for path in travelled.rglob("*") if path.is_file()):
        named.update(name.encode() + b"\0" + hashlib.sha256((own / name).read_bytes()).digest())
    assert travelled.name == named.hexdigest()
