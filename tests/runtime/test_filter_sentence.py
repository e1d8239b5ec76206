"""What a status of the filter in C says of x, P and nav holds: coasting, spoilt memory, edges of boxes."""

import ctypes
import re
import subprocess
import zlib

import numpy as np
import pytest
from conftest import ROOT

from boresight import BoresightError
from boresight.codegen.requirements import NUMBER
from boresight.runtime.filter import CompiledFilter, Filter
from boresight.runtime.filter.filter import lowered
from boresight.runtime.library import load
from boresight.runtime.manifest import read_manifest
from boresight.runtime.status import Status

FOLDER = ROOT / "generated" / "azimuth_hold"
ENDINGS = {"joseph": "", "ud": "_ud", "float": "_f32"}  # of a filter's functions, by macro
FORMS = {"joseph": (), "ud": ("-DBORESIGHT_UD=1",), "float": ("-DBORESIGHT_FLOAT",)}
GOOD = (Status.OK, Status.AT_CEILING)
REST = [0.1, 0.6, 100.0, 0.1, 0.2, 0.3, 1.0, 0.0, 0.0, 0.0, *np.zeros(6)]  # nav: position, v_n, q, biases
SIGMA = np.repeat([1e-6, 0.1, 1e-2, 1e-6, 1e-2], 3) * [1, 1, 1e6, *np.ones(12)]
NOISE = np.repeat([1e-5, 1e-3, 1e-8, 1e-5], 3)
N, PACKED = 15, 120
BOXES = read_manifest(FOLDER)["structs"]["nav"]
LOW, HIGH = (np.concatenate([box[end] for box in BOXES]) for end in ("low", "high"))

# What a Python test cannot do for itself: the sizes, and where the numbers stand.
PROBE = """
#include "azimuth_hold_filter.h"
int size(void);
int size(void) { return (int)sizeof(ah_filter); }
int snapshot_size(void);
int snapshot_size(void) { return AH_SNAPSHOT_SIZE; }
int place(int k);
int place(int k)
{
    return (int)((k == 0) ? offsetof(ah_filter, x) : (k == 1) ? offsetof(ah_filter, P) : offsetof(ah_filter, F));
}
bs_status measure(ah_filter *filter, int which, const bs_real *q, const bs_real *R, const bs_real *gates,
                  unsigned int rows, ah_innovation *innovation);
bs_status measure(ah_filter *filter, int which, const bs_real *q, const bs_real *R, const bs_real *gates,
                  unsigned int rows, ah_innovation *innovation)
{
    const bs_gates how = { rows, gates[0], gates[1], 0, 0U };
    const ah_reference reference = { { q[0], q[1], q[2], q[3] } };
    return (which == 0) ? ah_filter_measure_zupt(filter, R, &how, innovation)
                        : ah_filter_measure_azimuth(filter, &reference, R, &how, innovation);
}
"""


class Flown:
    """The filter of the azimuth hold in C: its functions take arrays, its memory lies open."""

    def __init__(self, dll, form):
        real = np.float32 if form == "float" else np.float64
        self.dll, self.real = dll, real
        self.suffix = ENDINGS[form]
        self.memory = np.zeros(dll.size(), np.uint8)
        start, P, end = (dll.place(k) for k in range(3))
        numbers = self.memory.view(real)
        width = real().itemsize
        self.nav, self.x = numbers[: start // width], numbers[start // width : P // width]
        self.P = numbers[P // width : P // width + PACKED]
        self.state = self.memory[:end]
        self.innovation = np.zeros(8, np.float64)

    def function(self, name):
        return getattr(self.dll, f"ah_filter_{name}{self.suffix}")

    def call(self, name, *arguments):
        given = [np.ascontiguousarray(a, self.real) if not isinstance(a, int) else a for a in arguments]
        pointers = [a if isinstance(a, int) else ctypes.c_void_p(a.ctypes.data) for a in given]
        return Status(self.function(name)(ctypes.c_void_p(self.memory.ctypes.data), *pointers))

    def begin(self, sigma=SIGMA, nav=REST):
        assert self.call("init_sigmas", nav, sigma) == Status.OK
        return self

    def propagate(self, f_b=(0.1, 0.2, 9.8), dt=0.1, noise=NOISE):
        return self.call("propagate", [*f_b, 0, 0, 0, dt], noise)

    def measure(self, R, which=0, q=(1, 0, 0, 1e-3), gate=0.0, joint=0.0, rows=7):
        arrays = [np.ascontiguousarray(a, self.real) for a in (q, R, (gate, joint))]
        pointers = [ctypes.c_void_p(a.ctypes.data) for a in arrays]
        memory, said = (ctypes.c_void_p(a.ctypes.data) for a in (self.memory, self.innovation))
        return Status(self.dll.measure(memory, which, *pointers, rows, said))

    @property
    def nis(self):
        return self.innovation.view(self.real)[6]

    @property
    def used(self):
        return int(self.innovation.view(np.uint32)[7 * (self.real().itemsize // 4)])

    def out(self, name, *arguments, count=N):
        """Status and the numbers that a function of (filter, ..., out) writes."""
        result = np.full(count, np.nan, self.real)
        status = self.function(name)(
            ctypes.c_void_p(self.memory.ctypes.data), *arguments, ctypes.c_void_p(result.ctypes.data)
        )
        return Status(status), result


@pytest.fixture(scope="module", params=FORMS)
def flown(request, tmp_path_factory):
    out = tmp_path_factory.mktemp(request.param)
    (out / "probe.c").write_text(PROBE)
    flags = ["-std=c99", "-O0", "-ffp-contract=off", "-Wall", "-Wextra", "-Werror", *FORMS[request.param]]
    sources = [*sorted((FOLDER / "src").glob("*.c")), out / "probe.c"]
    image = out / "filter.so"
    subprocess.run(
        ["gcc", "-shared", "-fPIC", *flags, "-I", FOLDER / "include", *sources, "-lm", "-o", image], check=True
    )
    dll = ctypes.CDLL(str(image))

    def begun(**start):
        return Flown(dll, request.param).begin(**start)

    begun.form = request.param
    return begun


def dense(filter):
    status, P = filter.out("covariance", count=N * N)
    assert status == Status.OK
    return P.reshape(N, N).astype(float)


def holds(filter, status, before, form):
    """The sentence of the header."""
    if status not in GOOD:
        return np.array_equal(filter.state, before)
    finite = all(np.isfinite(part).all() for part in (filter.x, filter.P, filter.nav))
    diagonal = [filter.P[j * (j + 3) // 2] for j in range(N)]
    inside = (filter.nav >= LOW.astype(filter.real)).all() and (filter.nav <= HIGH.astype(filter.real)).all()
    return finite and inside and min(diagonal) >= 0


def test_a_filter_that_coasts_for_a_day_stays_alive(flown):
    filter, seen = flown(sigma=SIGMA * 10), []
    for _ in range(86400 // 10):
        before = filter.state.copy()
        seen.append(filter.propagate(dt=10.0))
        assert holds(filter, seen[-1], before, flown.form)
    assert set(seen) == {Status.OK, Status.AT_CEILING}
    ceiling = load("azimuth-hold").ceiling
    status, sigma = filter.out("sigmas")
    assert status == Status.OK and (sigma <= np.sqrt(ceiling) * (1 + 1e-6)).all()
    assert sigma[2] > np.sqrt(ceiling[2]) / 4  # the height, which runs away first
    assert filter.measure([1e-4] * 3) in GOOD and filter.used == 7


@pytest.mark.parametrize("part", ["x", "P", "nav"])
def test_no_number_in_memory_passes_for_a_sound_filter(part, flown):
    for bad in (np.nan, np.inf, -np.inf):
        for place in (0, -1):
            filter = flown()
            getattr(filter, part)[place] = bad
            before = filter.state.copy()
            said = [
                filter.propagate(),
                filter.measure([1e-4] * 3),
                filter.measure([1e-6], which=1),
                filter.measure([1e-4] * 3, rows=0),
                filter.call("correct"),
            ]
            if part == "nav":  # a strapdown reads nothing else
                said.append(filter.call("strapdown", np.r_[np.zeros(6), 0.01], np.zeros(12)))
            assert not set(said) & set(GOOD), (bad, place, said)
            assert np.array_equal(filter.state, before)
            if part != "nav":
                assert filter.out("sigmas")[0] not in GOOD and filter.out("covariance", count=N * N)[0] not in GOOD


def test_wild_numbers_end_in_a_sound_filter_or_in_the_one_before(flown):
    rng, ended = np.random.default_rng(5), []
    for _ in range(40):
        filter = flown(sigma=10 ** rng.uniform(-4, 1.3, N) * np.where(np.arange(N) < 2, 0.1, 1))
        for _ in range(100):
            before, kind, last = filter.state.copy(), rng.integers(4), filter.innovation.copy()
            if kind == 0:
                status = filter.propagate(rng.uniform(-500, 500, 3), 10 ** rng.uniform(-6, 1))
            elif kind == 1:
                status = filter.measure(10 ** rng.uniform(-30, 1, 3), rows=int(rng.integers(8)))
                assert status in GOOD or filter.innovation.tobytes() == last.tobytes()
            elif kind == 2:
                status = filter.measure(10 ** rng.uniform(-30, 1, 1), which=1)
            else:
                status = filter.call("correct")
            ended.append(status)
            assert holds(filter, status, before, flown.form), (kind, status)
    assert ended.count(Status.OK) > 1000


@pytest.mark.parametrize("flown", ["joseph"], indirect=True)  # UD has no variance below zero
def test_a_variance_that_joseph_would_make_negative_undoes_the_whole_measurement(flown):
    """P with a row that is wrong by more than it holds: P - K g' is then below zero."""
    filter = flown()
    filter.P[3 * 6 // 2 :][3 - 3] = 0.0
    column = lambda j: j * (j + 1) // 2  # noqa: E731
    filter.P[column(4) + 3] = 1.0  # a covariance far beyond its variances of .01
    before = filter.state.copy()
    assert filter.measure([1e-9] * 3) == Status.NOT_POSITIVE
    assert np.array_equal(filter.state, before) and filter.used == 0


def test_a_correction_that_would_leave_the_box_is_refused_and_nav_can_be_set(flown):
    filter = flown(nav=[*REST[:3], 999.0, *REST[4:]])
    filter.x[3] = -50.0
    before = filter.state.copy()
    assert filter.call("correct") == Status.OUT_OF_RANGE
    assert np.array_equal(filter.state, before)
    assert filter.propagate() == Status.OK  # it is not locked out
    P = filter.P.copy()
    outside = [*REST[:3], 1049.0, 0.2, -1e30, 2.0, 0.0, 0.0, 2.0, *REST[10:]]
    before = filter.state.copy()
    assert filter.call("set_nav", outside, 0) == Status.OUT_OF_RANGE
    assert np.array_equal(filter.state, before)
    assert filter.call("set_nav", outside, 1) == Status.OK
    assert np.array_equal(filter.P, P) and not filter.x.any()
    half = np.sqrt(0.5)
    assert filter.nav[3:10] == pytest.approx([1000.0, 0.2, -1000.0, half, 0.0, 0.0, half], rel=1e-6)
    assert filter.call("set_nav", [*REST[:6], 0.0, *REST[7:]], 1) == Status.OUT_OF_RANGE  # no direction
    assert filter.call("set_nav", [np.inf, *REST[1:]], 1) == Status.NOT_FINITE
    assert filter.propagate() == Status.OK and filter.call("correct") == Status.OK


def test_a_strapdown_that_would_leave_the_box_is_refused(flown):
    filter = flown(nav=[*REST[:3], 999.9, *REST[4:]])
    before = filter.state.copy()
    push = np.r_[np.zeros(3), 5.0, 0.0, 0.098, np.zeros(6)]
    assert filter.call("strapdown", np.r_[np.zeros(6), 0.01], push) == Status.OUT_OF_RANGE
    assert np.array_equal(filter.state, before)
    push[3] = -5.0
    assert filter.call("strapdown", np.r_[np.zeros(6), 0.01], push) == Status.OK


def test_sigmas_and_variances_are_those_of_the_dense_covariance(flown):
    filter = flown()
    for _ in range(5):
        assert filter.propagate() == Status.OK and filter.measure([1e-4] * 3) == Status.OK
    P = dense(filter)
    assert np.array_equal(filter.out("sigmas")[1], np.sqrt(np.diag(P).astype(filter.real)))
    for i in range(N):
        assert filter.out("variance", ctypes.c_int(i), count=1)[1][0] == filter.real(P[i, i])
    assert filter.out("variance", ctypes.c_int(N), count=1)[0] == Status.OUT_OF_RANGE


def test_beyond_the_joint_gate_nothing_is_taken_and_it_is_counted(flown):
    filter = flown()
    assert filter.measure([1e-4] * 3) == Status.OK
    nis = filter.nis
    filter = flown()
    before = filter.state.copy()
    for count in range(3):
        assert filter.measure([1e-4] * 3, joint=nis * 0.999) == Status.OK
        assert filter.used == 0 and filter.nis == nis
        state, ceilings, *rejected = health(filter)
        assert (state, ceilings, rejected) == (Status.OK, 0, [count + 1, 0, 0])
    assert np.array_equal(filter.state[: N * 2], before[: N * 2]) and np.array_equal(filter.P, before_P(before, filter))
    assert filter.measure([1e-4] * 3, joint=nis * 1.001) == Status.OK and filter.used == 7
    assert health(filter)[2] == 0


def health(filter):
    result = np.zeros(5, np.uint32)
    pointers = (ctypes.c_void_p(a.ctypes.data) for a in (filter.memory, result))
    assert filter.function("health")(*pointers) == Status.OK
    return result.tolist()


def before_P(state, filter):
    at = filter.P.ctypes.data - filter.memory.ctypes.data
    return state[at : at + filter.P.nbytes].view(filter.real)


def test_a_snapshot_goes_on_bit_for_bit_and_a_strange_one_is_refused(flown):
    filter, other = flown(), flown(sigma=SIGMA * 3)
    filter.propagate()
    filter.measure([1e-4] * 3)
    size = filter.dll.snapshot_size()
    assert size == 72 + 23 + 151 * filter.real().itemsize + 4
    taken = np.zeros(size, np.uint8)

    def moved(name, of, held):
        return of.function(name)(*(ctypes.c_void_p(a.ctypes.data) for a in (of.memory, held)))

    assert moved("snapshot", filter, taken) == Status.OK
    assert zlib.crc32(taken[:-4]) == int.from_bytes(taken[-4:], "little")
    before = other.state.copy()
    for k in range(size):
        strange = taken.copy()
        strange[k] ^= 1 << k % 8
        assert moved("restore", other, strange) == Status.OUT_OF_RANGE, k
    for part, wrong in ((slice(0, 72), lambda was: was ^ 1), (slice(-204, -104), lambda was: 0xFF)):
        for k in range(*part.indices(size)):  # sealed again: another's head, numbers that are none
            strange = taken.copy()
            strange[k if part.start == 0 else part] = wrong(taken[k])
            strange[-4:] = np.frombuffer(zlib.crc32(strange[:-4]).to_bytes(4, "little"), np.uint8)
            assert moved("restore", other, strange) not in GOOD, k
    assert np.array_equal(other.state, before)
    assert moved("restore", other, taken) == Status.OK
    for one in (filter, other):
        assert one.propagate() == Status.OK and one.measure([1e-6], which=1, rows=1) == Status.OK
    assert all(np.array_equal(getattr(filter, part), getattr(other, part)) for part in ("x", "P", "nav"))


def test_blocks_are_the_dense_covariance_without_the_rest(flown):
    rng = np.random.default_rng(2)
    roots = [rng.standard_normal((3, 3)) * 1e-3 for _ in range(5)]
    blocks = [root @ root.T for root in roots]
    P = np.zeros((N, N))
    for k, block in enumerate(blocks):
        P[3 * k : 3 * k + 3, 3 * k : 3 * k + 3] = block
    one, other = flown(), flown()
    assert one.call("init", REST, P) == Status.OK
    assert other.call("init_blocks", REST, np.concatenate([block.ravel() for block in blocks])) == Status.OK
    assert np.array_equal(one.P, other.P)
    beyond = SIGMA.copy()
    beyond[2] = 1.1e6
    before = one.state.copy()
    assert one.call("init_sigmas", REST, beyond) == Status.OUT_OF_RANGE and np.array_equal(one.state, before)


def test_the_header_quotes_the_sentence_and_the_ceilings():
    text = re.sub(r"\s*\n \* ?", " ", (FOLDER / "include" / "azimuth_hold_filter.h").read_text())
    text = re.sub(r" +", " ", NUMBER.sub("", text)).replace(" ,", ",").replace(" ;", ";")
    assert (
        "BS_OK means that every number of x, nav and P is finite, nav lies in its box and every variance is at least "
        "0; with UD also that P is positive semidefinite; with Joseph no more than the diagonal is claimed. With "
        "another "
        "status (but BS_AT_CEILING, which claims the same as BS_OK) x, P and nav are as they were, bit for bit."
    ) in text
    (listed,) = re.findall(r"The ceilings, as sigmas: (.*?)\. ", text)
    sigmas = [float(v) for v in re.findall(r"\d(?:\.\d+)?e[+-]\d+", listed)]
    assert sigmas == pytest.approx(np.sqrt(load("azimuth-hold").ceiling))


NAV = {"lon_lat_height": REST[:3], "v_n": REST[3:6], "q_b2n_wxyz": REST[6:10]}
NAV |= {"gyro_bias": REST[10:13], "accel_bias": REST[13:]}
DENSITIES = ("gyro_noise", "accel_noise", "gyro_bias_noise", "accel_bias_noise")
NOISES = dict(zip(DENSITIES, NOISE.reshape(4, 3), strict=True))


@pytest.mark.parametrize("kind", [Filter, CompiledFilter])
def test_python_has_the_same_ceilings_and_joint_gate(kind):
    model = load("azimuth-hold")
    loop = kind(model, NAV, np.diag(SIGMA**2))
    loop.P = np.diag(SIGMA**2) + np.diag(np.r_[0, 0, 3e12, np.zeros(12)])
    loop.P[2, 5] = loop.P[5, 2] = 1e5
    loop.predict(f_b=[0, 0, 9.8], dt=1e-6, **NOISES)
    assert np.all(loop.at_ceiling)
    assert loop.P[2, 2] == pytest.approx(0.75e12, rel=1e-3) and loop.P[2, 5] == pytest.approx(0.5e5 + 1.5, rel=0.05)
    loop = kind(model, NAV, np.diag(SIGMA**2))
    loop.predict(f_b=[0, 0, 9.8], dt=0.1, **NOISES)
    assert not np.any(loop.at_ceiling)
    before = loop.P.copy(), loop.x.copy()
    out = loop.update("zupt", np.full(3, 1e-4), joint=1e-3)
    assert not out.used.any() and out.nis == pytest.approx(np.sum(out.nu**2 / out.S)) and out.nis > 1
    assert np.array_equal(loop.P, before[0]) and np.array_equal(loop.x, before[1])
    assert loop.update("zupt", np.full(3, 1e-4), joint=1e3).used.all()
    with pytest.raises(BoresightError, match="joint is 0"):
        loop.update("zupt", np.full(3, 1e-4), joint=0)
    with pytest.raises(BoresightError, match="the sigma of d_height is 2e"):
        kind(model, NAV, np.diag(np.r_[SIGMA[:2], 2e6, SIGMA[3:]] ** 2))


def test_lowering_keeps_every_correlation_to_the_bit():
    rng = np.random.default_rng(1)
    root = rng.standard_normal((4, 5, 5)) * [1, 1e3, 1e-4, 1e5, 1]
    P = np.swapaxes(root, -1, -2) @ root
    low, at = lowered(P, np.array([1e6, 1e3, 1e6, 1e4, 1e6]))
    assert at.all() and (np.diagonal(low, axis1=-2, axis2=-1) <= [1e6, 1e3, 1e6, 1e4, 1e6]).all()
    scale = low[..., 0, :] / P[..., 0, :]
    assert np.array_equal(scale, 2.0 ** np.round(np.log2(scale)))
    assert np.array_equal(low, P * scale[..., :, None] * scale[..., None, :])
