"""The filter over blocks of runs: every run has the bits that the scalar functions of the generated C give it alone."""

import ctypes

import numpy as np
import pytest
from building import spoil
from conftest import optimised

from boresight.runtime import library
from boresight.runtime.filter import CompiledFilter, Epoch
from boresight.runtime.library import WIDTHS, load
from boresight.runtime.status import Status

RUNS = 61  # no multiple of any width
SAMPLES = 3  # of the strapdown in one call
SMALL, LARGE = "euler-matching", "velocity-attitude-sensors"
# every width of a small model; one of a model with measurements of one row, and of the largest, of all parts
BUILDS = [*((SMALL, width) for width in WIDTHS), ("azimuth-hold", 4), (LARGE, None)]
HOSTILE = (np.nan, np.inf, -np.inf, -0.0, 1e300, -1e300, 5e-324)


def bits(array):
    return np.ascontiguousarray(array, dtype=float).view(np.uint64)


class Gates(ctypes.Structure):
    """bs_gates."""

    _fields_ = [
        ("rows", ctypes.c_uint),
        ("gate", ctypes.c_double),
        ("joint", ctypes.c_double),
        ("iterations", ctypes.c_int),
        ("options", ctypes.c_uint),
    ]


class Alone:
    """Runs of a filter one after another, by the functions of PREFIX_filter.h."""

    def __init__(self, loop):
        memory = loop.memory
        self.loop, self.library = loop, memory.library
        blocks = memory.settle(memory.runs)
        self.dll, self.described = memory.dll, loop.described
        size = self.library.dll[f"{self.library.manifest['c_prefix']}_batch_filter_size"]
        size.restype = ctypes.c_size_t
        self.n, self.front = blocks.n, memory.part["P"].stop
        self.carried = sum(part.stop - part.start for part in (memory.part[name] for name in memory.fields))
        self.skipped = max(0, memory.part["x"].start - self.carried)  # a place that stands for nothing
        self.memory = np.zeros((self.n, size()))
        whole = blocks.read(slice(0, memory.size))
        self.memory[:, : self.front - self.skipped] = whole[:, self.skipped : self.front]
        kept = whole[:, memory.part["considered"]]
        states = kept.shape[1] - 1
        self.bytes = self.memory.view(np.uint8)[:, 8 * (self.front - self.skipped) :]
        self.bytes[:, :states], self.bytes[:, states] = kept[:, 1:], kept[:, 0]
        begin = (states + 2) // 2 * 2
        counts = memory.part["counts"]
        self.counts = self.bytes[:, begin : begin + 2 * (counts.stop - counts.start)].view(np.uint16)
        self.counts[:] = whole[:, counts]

    def call(self, name, described, inputs, run, *rest):
        function = self.dll[f"{self.library.manifest['c_prefix']}_filter_{name}"]
        structs = [np.ascontiguousarray(inputs.array(struct, run)) for struct in described["structs"]]
        pointers = [ctypes.c_void_p(array.ctypes.data) for array in (self.memory[run], *structs, *rest)]
        return function(*pointers)

    def state(self):
        return np.hstack([self.memory[:, : self.front - self.skipped], self.counts])


class Drawn:
    """Inputs of one function: those of an Epoch, as the scalar function takes them."""

    def __init__(self, inputs, described, library, sample=None):
        self.inputs, self.described, self.library, self.sample = inputs, described, library, sample

    def array(self, struct, run):
        one = np.zeros(self.library.width[struct])
        for name, part in self.library.layout[struct].items():
            if name in self.inputs.fields:
                value = self.inputs[name] if self.sample is None else self.inputs[name][self.sample]
                one[part] = value[run]
        return one


def drawn(library, name, rng, spoilt):
    """(RUNS, size) of a field: well inside its box, at its ends, and where it is spoilt, beyond it or no number."""
    field = library.field[name]
    low, high = np.array(field["low"]), np.array(field["high"])
    middle, half = (low + high) / 2, (high - low) / 2
    value = middle + half * rng.uniform(-1, 1, (RUNS, len(low))) * 10.0 ** rng.uniform(-4, -0.1, (RUNS, 1))
    if name == "dt":  # by decades: over long steps nothing stays in its box
        value = low * (high / low) ** rng.random((RUNS, 1))
    if field["norm"]:
        value = rng.standard_normal((RUNS, len(low)))
        value[:, 0] += 3
        value /= np.linalg.norm(value, axis=1, keepdims=True)
    if spoilt:
        ends = rng.random(RUNS) < 0.04
        value[ends] = np.where(rng.random((ends.sum(), len(low))) < 0.5, low, high)
        odd = rng.random(RUNS) < 0.02
        value[odd, rng.integers(len(low))] = rng.choice(HOSTILE, odd.sum())
    return value if len(low) > 1 else value[:, 0]


def begun(library, rng, spoilt):
    n = len(library.states)
    box = library.field["x"]
    size = (np.array(box["high"]) - np.array(box["low"])) * 1e-4
    root = rng.standard_normal((RUNS, n, n + 2)) * 0.3 + np.eye(n, n + 2)
    P = root @ np.swapaxes(root, -1, -2) * size[:, None] * size * 10.0 ** rng.uniform(-3, 0, (RUNS, 1, 1))
    P = (P + np.swapaxes(P, -1, -2)) / 2
    x = rng.standard_normal((RUNS, n)) * size * 0.01
    if spoilt:
        for run in np.flatnonzero(rng.random(RUNS) < 0.1):
            i, j = rng.integers(n, size=2)
            P[run, i, j] = P[run, j, i] = rng.choice([*HOSTILE, -1e-9, 1e30])
        for run in np.flatnonzero(rng.random(RUNS) < 0.05):
            x[run, rng.integers(n)] = rng.choice(HOSTILE)
        P[rng.random(RUNS) < 0.03] = np.eye(n) * 1e28  # above the ceilings
    nav = {name: drawn(library, name, rng, spoilt) for struct in library.manifest["filter"]["carried"]
           for name in library.layout[struct]}  # fmt: skip
    loop = CompiledFilter(library, {}, np.broadcast_to(np.eye(n) * 1e-9, (RUNS, n, n)))
    loop.nav, loop.P, loop.x = nav, P, x
    return loop


def filled(inputs, library, rng, spoilt, samples):
    for name in inputs.fields:
        if name not in ("z", "R"):
            value = np.array([drawn(library, name, rng, spoilt) for _ in range(samples or 1)])
            inputs[name] = (np.abs(value) if "noise" in name else value)[slice(None) if samples else 0]


def apart(library, function, rng, spoilt):
    """Names of what differs by a bit between `function` in lanes and run by run; each run's status and its state."""
    loop = begun(library, rng, spoilt)
    measured = function.startswith("measure_")
    name = function.removeprefix("measure_")
    samples = SAMPLES if function == "strapdown" else 0
    epoch = Epoch(loop, samples, [name] if measured else [], predict=function == "propagate",
                  feedback=function == "correct", runs=(RUNS,))  # fmt: skip
    described = loop.described["measurements"][name] if measured else loop.described[function]
    inputs = (
        {"strapdown": epoch.strapdown, "propagate": epoch.predict}.get(function)
        or epoch.measured.get(name)
        or epoch.predict
    )
    filled(inputs, library, rng, spoilt, samples)
    if measured:
        m = described["m"]
        one = inputs
        one["R"] = (
            (10.0 ** rng.uniform(-8, 0, one["R"].shape))
            if one["R"].shape[-1] == m
            else np.tile(np.eye(m).ravel(), (RUNS, 1))
        )
        if described["brings_z"]:
            one["z"] = rng.standard_normal(one["z"].shape)
        if spoilt:
            one["R"][rng.random(RUNS) < 0.05, 0] = rng.choice([0.0, -1.0, np.nan, 1e31])
            one.rows[:] = rng.random(one.rows.shape) < 0.8
            one.gates[:] = ((3, 0), (0, 10), (3, 10), (0, 0))[rng.integers(4)]
            one.iterations[:] = rng.integers(0, 3)
            one.options[:] = rng.integers(0, 4)
    memory, counts = loop.memory, loop.memory.part["counts"]
    blocks = memory.settle((RUNS,))
    if spoilt:
        drawn_counts = rng.integers(0, 3, (RUNS, blocks.numbers.shape[1])).astype(float)
        memory.write("counts", drawn_counts[:, : counts.stop - counts.start])
        if measured or function == "propagate":
            memory.consider(*(rng.random((2, RUNS, len(library.states))) < 0.01))
    alone = Alone(loop)
    parts = [Drawn(inputs, described, library, k) for k in range(samples) or (None,)]
    said, innovations = [], []
    for run in range(RUNS):
        rest = []
        if measured:
            m, most = described["m"], max(d["m"] for d in loop.described["measurements"].values())
            innovation = np.zeros(2 * most + 2)  # used and inflated are the last number
            rows = int(sum(1 << k for k in range(m) if one.rows[run, k]))
            gates = Gates(rows, *one.gates, one.iterations[0], one.options[0])
            rest = [*([np.array(one["z"][run])] if described["brings_z"] else []), np.array(one["R"][run])]
            rest += [np.frombuffer(gates, dtype=np.uint8), innovation]
        answers = (alone.call(function, described, part, run, *rest) for part in parts)
        said.append(next(filter(None, answers), Status.OK))  # what is refused at a sample flies none of the later ones
        if measured:
            used, inflated = innovation[-1:].view(np.uint32)
            innovations.append(
                [
                    *innovation[:m],
                    *innovation[most : most + m],
                    innovation[2 * most],
                    *[(used >> k & 1) + 2 * (inflated >> k & 1) for k in range(m)],
                ]
            )
    epoch()
    found = []
    if not np.array_equal(said, epoch.status):
        found.append("status")
    whole = blocks.read(slice(0, counts.stop))[:, alone.skipped :]
    if not np.array_equal(bits(whole), bits(alone.state())):
        found.append("state")
    if measured:
        ours = np.hstack([one.nu, one.S, one.nis[:, None], one.used])
        if not np.array_equal(bits(ours), bits(innovations)):
            found.append("innovation")
    return found, np.array(said), whole


def functions(library):
    described = library.manifest["filter"]
    return [*(name for name in ("strapdown", "propagate", "correct") if described[name]),
            *(f"measure_{name}" for name in described["measurements"])]  # fmt: skip


@pytest.mark.parametrize(("model", "width"), BUILDS)
def test_every_run_has_the_bits_that_it_has_alone(model, width):
    library = load(model, lanes=width)
    for function in functions(library):
        rng = np.random.default_rng([3, len(function), width or 0])
        said = []
        for spoilt in (False, *2 * (True,)) if model == LARGE else (False, False, *3 * (True,)):
            found, status, _ = apart(library, function, rng, spoilt)
            assert not found, (function, spoilt)
            said.append(status)
        met = set(np.concatenate(said).tolist())
        assert met & {Status.OK, Status.AT_CEILING} and met & {Status.NOT_FINITE, Status.OUT_OF_RANGE}, function


def test_c_as_it_ships_has_the_bits_of_c_without_optimisation(quickly, monkeypatch):
    """In lanes and run by run: of one build; evidence has the others."""
    monkeypatch.setattr(library, "MANY", 1)
    plain = load(SMALL)
    plain.lanes(RUNS)
    with optimised(*quickly):
        shipped = load(SMALL)
        shipped.lanes(RUNS)
    assert plain.dll.boresight_build() != shipped.dll.boresight_build()
    for function in functions(plain):
        for spoilt in (False, True):
            (_, _, before), (found, _, after) = (
                apart(build, function, np.random.default_rng([4, len(function)]), spoilt) for build in (plain, shipped)
            )
            assert not found and np.array_equal(bits(before), bits(after)), (function, spoilt)
    for function in (name for name, unit in shipped.units.items() if unit.fields):
        differs, _ = unlike(plain, shipped, function, np.random.default_rng([4, len(function)]), True)
        assert not differs, function


MUTANTS = {  # of the text of em_lanes.c: each spoils one step in lanes, in the last bit or in a rare lane
    "strapdown": ("#define BS_REAL(x) bs_all_of(x)", "#define BS_REAL(x) bs_all_of((x) * (1 + 0x1p-52))"),
    "strapdown, a bad lane written": (
        "bs_keep(&b->carried[0], &now[0], good,",
        "bs_keep(&b->carried[0], &now[0], *rare,",
    ),
    "propagate, a sum reordered": (
        "s0_0 += a0 * from[0];",
        "s0_0 = (a0 * from[0]) + (s0_0 * (1 + 0x1p-52));",
    ),
    "propagate, Q": ("const bs_lanes share = 0.75 *", "const bs_lanes share = 0.7500000000000001 *"),
    "propagate, a bad lane written": ("*to = bs_choose(good, *to,", "*to = bs_choose(~good, *to,"),
    "measure_euler, a sum reordered": (
        "(P[other + i] - (K[i] * g[j + 1])) - (own[i] * K[j + 1])",
        "P[other + i] - ((K[i] * g[j + 1]) + (own[i] * K[j + 1]))",
    ),
    "measure_euler, a gate": ("t->good &= (nu * nu) <= ((gates[0] * gates[0]) * S);", ""),
    "measure_euler, a bad lane written": ("to = bs_everywhere(t->good) ? b->P : s->P;", "to = b->P;"),
    "measure_euler, x of a bad lane": ("bs_keep(b->x, t->x, t->good,", "bs_keep(b->x, t->x, t->good | ~t->good,"),
    "correct": ("b->x[i] = bs_choose(good, bs_all_of(0.0), b->x[i]);", "b->x[i] = bs_all_of(0.0) * b->x[i];"),
}


@pytest.mark.parametrize("name", MUTANTS)
def test_one_operation_changed_in_the_lanes_is_seen(name, em_copy):
    spoil(em_copy, "batch/em_lanes.c", *MUTANTS[name])
    library, rng = load(em_copy, lanes=4), np.random.default_rng(5)
    assert any(apart(library, name.split(",")[0], rng, spoilt)[0] for spoilt in (False, *12 * (True,)))


def test_an_angle_that_a_kernel_in_lanes_does_not_take_is_flown_by_the_scalar_function(em_copy):
    limit = "bs_unusual |= ~(bs_magnitude(angle) <= BS_MATH_ANGLE);"
    wrong = "*sine = bs_choose(bs_magnitude(angle) <= 0.1, *sine, bs_all_of(7.0));"
    for text, differs in ((f"bs_unusual |= ~(bs_magnitude(angle) <= 0.1); {wrong}", False), (wrong, True)):
        spoil(em_copy, "batch/boresight_lanes.h", limit, text)
        limit = text
        found, *_ = apart(load(em_copy, lanes=4), "strapdown", np.random.default_rng(11), False)
        assert bool(found) == differs


def unlike(flight, in_lanes, function, rng, spoilt):
    """Whether a function differs by a bit between two libraries; and what the first said of the runs."""
    fields = {name: drawn(flight, name, rng, spoilt) for name in getattr(flight, function).fields}
    for shared in rng.choice(list(fields), len(fields) // 3, replace=False):
        fields[shared] = fields[shared][0]
    given, runs = flight.arrange(function, fields)
    runs = runs or (1,)
    outputs = [[np.full_like(out, 7.0) for out in getattr(flight, function).outputs(runs[0])] for _ in range(2)]
    (_, said), (failed, again) = (
        getattr(one, function).evaluate(given, runs, out) for one, out in zip((flight, in_lanes), outputs, strict=True)
    )
    same = all(np.array_equal(bits(a), bits(b)) for a, b in zip(*outputs, strict=True))
    return not (same and np.array_equal(said, again) and failed == np.count_nonzero(said)), said


@pytest.mark.parametrize(("model", "width"), [build for build in BUILDS if build[1] != 1])
def test_every_function_has_the_bits_that_it_has_alone(model, width, monkeypatch):
    monkeypatch.setattr(library, "MANY", 1)
    flight, in_lanes = load(model, lanes=1), load(model, lanes=width)
    for function in (name for name, unit in flight.units.items() if unit.fields):
        rng, met = np.random.default_rng([7, len(function), width or 0]), set()
        for spoilt in (False, *4 * (True,)):
            differs, said = unlike(flight, in_lanes, function, rng, spoilt)
            assert not differs, (function, spoilt)
            met |= set(said.tolist())
        assert Status.OK in met and met & {Status.NOT_FINITE, Status.OUT_OF_RANGE}, function


UNIT_MUTANTS = {  # of em_unit_lanes.c
    "the last bit": ("#define BS_REAL(x) bs_all_of(x)", "#define BS_REAL(x) bs_all_of((x) * (1 + 0x1p-52))"),
    "a bad lane written": ("if (good[l] != 0) {", "if ((good[l] != 0) || (n != 0U)) {"),
    "a box": ("good = bs_inside(in, low, high,", "good = ~bs_inside(in, high, low,"),
    "a status": ("status[run] = (unsigned char)BS_OK;", ""),
}


@pytest.mark.parametrize("name", UNIT_MUTANTS)
def test_one_change_of_the_functions_in_lanes_is_seen(name, em_copy, monkeypatch):
    monkeypatch.setattr(library, "MANY", 1)
    spoil(em_copy, "batch/em_unit_lanes.c", *UNIT_MUTANTS[name])
    flight, in_lanes = load(em_copy, lanes=1), load(em_copy, lanes=4)
    assert any(
        unlike(flight, in_lanes, function, np.random.default_rng([8, k]), spoilt)[0]
        for function, unit in flight.units.items()
        if unit.fields
        for k, spoilt in enumerate((False, *6 * (True,)))
    )


def test_a_bad_run_has_its_own_status_and_the_others_go_on():
    library, rng = load("azimuth-hold"), np.random.default_rng(6)
    loop = begun(library, rng, False)
    epoch = Epoch(loop, 3, ["zupt"], runs=(RUNS,))
    for name in epoch.predict.fields:
        epoch.predict[name] = 1e-4
    epoch.strapdown["dtheta_ib_b"], epoch.strapdown["dt"], epoch.predict["dt"] = 1e-4, 0.01, 0.03
    epoch.strapdown["dv_b"], epoch.strapdown["dv_before"], epoch.measured["zupt"]["R"] = 0.01, 0.01, 1e-2
    loop.x = np.zeros((RUNS, 15))
    loop.P = np.broadcast_to(np.diag(np.full(15, 1e-12)), (RUNS, 15, 15))
    epoch.strapdown["dtheta_ib_b"][1, 7] = np.nan
    epoch.predict["f_b"][11] = np.inf
    epoch.measured["zupt"]["R"][13] = -1.0
    before = loop.nav["v_n"].copy(), loop.P.copy()
    assert epoch() == 3
    bad = {7: Status.NOT_FINITE, 11: Status.NOT_FINITE, 13: Status.OUT_OF_RANGE}
    assert {run: epoch.status[run] for run in np.flatnonzero(epoch.status)} == bad
    assert epoch.refused() == "run 7: BS_NOT_FINITE"
    moved = np.flatnonzero((before[1] != loop.P).any(axis=(1, 2)))
    assert set(range(RUNS)) - set(moved) == {7, 11}
    assert (loop.nav["v_n"] != before[0]).any(axis=1).all()
    epoch.strapdown["dtheta_ib_b"], epoch.predict["f_b"], epoch.measured["zupt"]["R"] = 1e-4, 1.0, 1e-2
    assert epoch() == 0 and not epoch.refused()


def test_a_measurement_leaves_a_run_as_it_was_whose_P_is_unsound_where_nothing_is_measured():
    library, rng = load("azimuth-hold"), np.random.default_rng(9)
    loop = begun(library, rng, False)
    epoch = Epoch(loop, 0, ["zupt"], predict=False, feedback=False, runs=(RUNS,))
    epoch.measured["zupt"]["R"] = 1e-2
    P = np.tile(np.diag(np.full(15, 1e-12)), (RUNS, 1, 1))
    P[7, 0, 14] = P[7, 14, 0] = np.nan
    P[11, 0, 14] = P[11, 14, 0] = np.inf
    P[13, 14, 14] = -1e-12
    P[17, 14, 14] = 1e30
    loop.x, loop.P = np.zeros((RUNS, 15)), P.copy()
    assert epoch() == 3
    bad = {7: Status.NOT_FINITE, 11: Status.NOT_FINITE, 13: Status.NOT_POSITIVE}
    said = {**bad, 17: Status.AT_CEILING}
    assert {run: epoch.status[run] for run in np.flatnonzero(epoch.status)} == said
    same = (bits(loop.P) == bits(P)).all(axis=(1, 2))
    assert np.flatnonzero(same).tolist() == list(bad) and (loop.x[list(bad)] == 0).all()
