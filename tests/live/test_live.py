"""The live loop of the C, flown from Python by flights that share nothing with it."""

import ctypes
import random
import shutil
from dataclasses import replace

import numpy as np
import pytest
from conditions import CONDITIONS, Condition, scale_and_axes
from conftest import ROOT
from judge import judged, met
from loops import fly_live, sigmas, start
from simulator import standard

from boresight import BoresightError, Live, Record, generate, load
from boresight.runtime.status import Status
from boresight.runtime.transfer import sensors

NAMED = {condition.name: condition for condition in CONDITIONS}


def flown(name, runs=4, **changes):
    flight = NAMED[name].flight(runs=runs, **changes)
    record = fly_live(flight)
    return judged(record, flight.setting.seconds), record


def loop_of(flight, run=0, rules=None, model="velocity-attitude"):
    constants = flight.setting.constants()
    constants.pop("lever_b")
    return Live(model, rules, **constants)


def fly(flight, loop, run=0, behind=lambda: 10**6, cut=None):
    """One run to its end; behind(): how many things the background may do behind a sample.  cut: (k, function)."""
    lever_b, begun, k = flight.setting.constants()["lever_b"], False, -1
    for kind, at_us, *given in flight.events(run):
        if kind == "sample":
            k += 1
            if begun:
                packed = loop._samples(at_us, given[0], 0, {"dtheta_ib_b": given[1], "dv_b": given[2]})
                loop._sample(loop._memory, ctypes.c_void_p(packed.ctypes.data))
                for _ in range(behind()):
                    if not loop.background():
                        break
            if cut and k == cut[0]:
                cut[1](loop)
        elif not begun:
            loop.begin(int(flight.end_us[k]), start(given[0], flight, run), **sigmas(flight))
            begun = True
        else:
            fields = given[0]
            loop.message("velocity", at_us, fields["R"][:3], v_m_n=fields["v_m_n"], lever_b=lever_b)
            loop.message("dcm", at_us, fields["R"][3:], q_m2n_wxyz=fields["q_m2n_wxyz"])
    while loop.background():
        pass
    return loop.digest()


@pytest.fixture(scope="module")
def vertical(tmp_path_factory):
    folder = tmp_path_factory.mktemp("vertical") / "vertical"
    generate(f"{ROOT / 'examples' / 'vertical.py'}:VERTICAL", folder)
    return load(folder)


@pytest.fixture(scope="module")
def short():
    return standard(runs=2, seconds=12.0)


@pytest.mark.parametrize(
    "name", ["healthy, ship", "healthy, calm", "healthy, catapult", "healthy, parked", "messages 0.2 s late"]
)
def test_a_healthy_flight_is_consistent_and_loses_no_message(name):
    one, runs = NAMED[name], 6
    flight = one.flight(runs=runs)
    assert met(one.asked, one.refused, flight, fly_live(flight))


@pytest.mark.parametrize("name", ["delay, loiter", "delay, steady turn", "delay, parked"])
def test_a_delay_is_not_learned_from_noise(name):
    _, record = flown(name, runs=2)
    assert 47.5 < 1e3 * np.sqrt(np.mean([P[:, 15, 15] for P in record.P[-5:]])) < 60


@pytest.mark.parametrize("name", ["tags of the slave step by +50 ms", "tags of the slave step by -50 ms"])
def test_a_delay_that_two_messages_of_one_instant_show_is_corrected_once(name):
    """Velocity and attitude come together: the second is older by what the first has shown of the delay."""
    _, record = flown(name, seconds=23.0)
    late = np.array(record.time) > 20.7
    error, P = np.array(record.errors)[late, :, 15], np.array(record.P)[late, :, 15, 15]
    assert late.sum() > 8 and np.abs(error / np.sqrt(P)).max() < 4


@pytest.mark.parametrize(
    "name",
    [
        "parked, one velocity 500 m/s off",
        "parked, one heading 90 deg off",
        "moving, one velocity 3 m/s off at 4.1 s",
        "counter of the slave restarts, 20 s to 0.2 s",
        "delay steps by 100 ms",
        "one dt of 1e-9 s",
        "one gyro sample is no number",
        "0.04 s of the slave lost",
    ],
)
def test_what_is_wrong_is_named_and_the_rest_of_the_flight_is_taken(name):
    found, record = flown(name)
    assert not record.raised and len({run for _, run, _ in record.notes}) == 4
    assert found.nees_end < 30 and found.refused < 0.02


def test_when_the_background_runs_and_how_far_changes_no_bit(short):
    whole = fly(short, loop_of(short))
    draw = random.Random(1)
    for _ in range(3):
        loop = loop_of(short, rules={"latency": 12})
        alike = loop_of(short, rules={"latency": 12})
        cut = fly(short, loop, behind=lambda: draw.randrange(16))
        assert loop.counts()["corrections_late"] == 0 and loop.counts()["TAKEN"] > 80
        assert cut == fly(short, alike) != whole  # another latency corrects another sample


def test_a_snapshot_in_the_middle_goes_on_with_every_bit(short):
    kept = []
    whole = fly(short, loop_of(short), cut=(300, lambda loop: kept.append(loop.snapshot())))
    assert fly(short, loop_of(short), cut=(300, lambda loop: loop.restore(kept[0]))) == whole
    spoilt = bytearray(kept[0])
    spoilt[1000] ^= 1
    loop = loop_of(short)
    with pytest.raises(BoresightError, match="no snapshot of this loop, or it has changed"):
        loop.restore(bytes(spoilt))


def test_a_copy_flies_on_by_itself(short):
    import copy

    loop = loop_of(short)
    fly(replace(short, end_us=short.end_us[:200]), loop)
    before, other = loop.digest(), copy.deepcopy(loop)
    other.sample(int(short.end_us[200]), 0.02, dtheta_ib_b=np.zeros(3), dv_b=[0, 0, -0.196])
    assert loop.digest() == before != other.digest()


def two_sensors(flight, hold_us):
    """The attitude at once; the velocity five samples later, of 60 ms before."""
    loop, waiting, begun, k = loop_of(flight, rules={"hold_us": hold_us}), [], False, -1
    for kind, at_us, *given in flight.events(0):
        if kind == "sample":
            k += 1
            if begun:
                loop.sample(at_us, given[0], dtheta_ib_b=given[1], dv_b=given[2])
            while waiting and waiting[0][0] <= k:
                _, then_us, fields = waiting.pop(0)
                loop.message("velocity", then_us, fields["R"][:3] * 100, v_m_n=fields["v_m_n"])
        elif not begun:
            loop.begin(int(flight.end_us[k]), start(given[0], flight, 0), **sigmas(flight))
            begun = True
        else:
            loop.message("dcm", at_us, given[0]["R"][3:], q_m2n_wxyz=given[0]["q_m2n_wxyz"])
            waiting.append((k + 5, at_us - 60_000, given[0]))
    return loop


def test_messages_out_of_order_among_each_other_are_taken_in_theirs(short):
    """Two sensors of different delays; held for the longer one, all are taken, and the result is that of the order."""
    taken = {hold_us: two_sensors(short, hold_us).counts() for hold_us in (0, 300_000)}
    assert taken[0]["LATE"] > 40 and taken[300_000]["LATE"] == 0
    assert taken[300_000]["TAKEN"] + taken[300_000]["IN_PART"] >= 95


def test_it_flies_in_float_with_factors(short):
    double, single = (loop_of(short, model=load("velocity-attitude", precision=p)) for p in ("double", "float"))
    for loop in (double, single):
        fly(short, loop)
    a, b = (loop.output(int(short.end_us[-1])) for loop in (double, single))
    assert single.counts()["TAKEN"] == double.counts()["TAKEN"] > 80
    assert np.all(np.abs(a["v_n"] - b["v_n"]) < 3 * a["sigma"][3:6])
    assert np.allclose(a["sigma"], b["sigma"], rtol=0.2)


def test_a_sample_or_a_message_of_anything_ends_in_a_code(short):
    draw, loop, happened = random.Random(3), loop_of(short), set()
    rough = {"q_b2n_wxyz": [1, 0, 0, 0], "q_b2m_wxyz": [1, 0, 0, 0]}
    loop.begin(0, rough, phi=0.1, dv_n=1.0, d_tau=0.05)
    odd = [0.0, 1e-9, 1e-300, 1e300, -1.0, float("nan"), float("inf"), 0.01]
    instants = [0, 1, -1, 2**62, -(2**62), 10**15, 5000]
    for k in range(4000):
        at = draw.choice(instants) if draw.random() < 0.3 else 10_000 * k
        dtheta, dv = ([draw.choice(odd) if draw.random() < 0.1 else 0.0 for _ in range(3)] for _ in range(2))
        loop.sample(at, draw.choice(odd) if draw.random() < 0.1 else 0.01, dtheta_ib_b=dtheta, dv_b=dv)
        if draw.random() < 0.3:
            wrong = [draw.choice(odd)] * 3
            loop.message("velocity", at, [draw.choice(odd)] * 3, v_m_n=wrong, rows=draw.getrandbits(32))
        if not loop.output(at) and draw.random() < 0.1:
            loop.begin(10_000 * k, rough, phi=0.1, dv_n=1.0, d_tau=0.05)
        happened.update(line.split(": ")[1].split(" ")[0] for line in loop.events())
    assert len(happened) > 4


def test_what_it_is_given_by_name_is_looked_at(short):
    with pytest.raises(BoresightError, match="no rule 'hold'; there are gate, joint, jitter_us"):
        Live("velocity-attitude", {"hold": 3})
    with pytest.raises(BoresightError, match="no constant 'gyro'; it has accel_bias_noise"):
        Live("velocity-attitude", gyro=3)
    with pytest.raises(BoresightError, match="phi-error has no live loop"):
        Live("phi-error")
    loop = loop_of(short)
    with pytest.raises(BoresightError, match="no block 'heading' of states; there are phi, dv_n"):
        loop.begin(0, {}, heading=1.0)
    with pytest.raises(BoresightError, match="out_of_range"):
        loop.begin(0, {})  # a quaternion of zeros
    with pytest.raises(BoresightError, match="no measurement 'speed'; it has"):
        loop.message("speed", 0, [1.0])
    with pytest.raises(BoresightError, match=r"v_m_n has shape \(2,\); give \(3,\)"):
        loop.message("velocity", 0, np.ones(3), v_m_n=[1, 2])
    with pytest.raises(BoresightError, match="reads dtheta_ib_b, dv_b; it was given gyro"):
        loop.sample(0, 0.01, gyro=np.zeros(3))


@pytest.mark.parametrize("off_us", [1, 300, 4999])
@pytest.mark.parametrize("hz", [5, 100])
def test_an_instant_nearer_to_a_sample_than_the_shortest_step_is_measured_all_the_same(vertical, hz, off_us):
    """Its dt is 1 ms to 1 s; four samples at 5 Hz are .8 s, at the box's end."""
    every = {5: 6, 100: 4}[hz]  # 6 samples are 1.2 s
    loop = Live(vertical, {"oldest_us": 3_000_000, "every": every}, accel_noise=0.01, bias_noise=1e-4)
    loop.begin(0, {"height": 100.0, "speed": 0.0, "bias": 0.0}, d_height=10.0, d_speed=1.0, d_bias=0.01)
    step_us, taken = 1_000_000 // hz, 0
    for k in range(1, 10 * hz + 1):
        loop.sample(k * step_us, 1 / hz, dv=9.81 / hz)
        if k % hz == 0:
            taken += loop.message("altitude", k * step_us - off_us, 1.0, baro=100.0) == 0
    loop.sample((10 * hz + 1) * step_us, 1 / hz, dv=9.81 / hz)
    assert not [event for event in loop.events() if "lost" in event]
    assert loop.counts()["TAKEN"] == taken == 10
    assert loop.output((10 * hz + 1) * step_us)["height"] == pytest.approx(100.0, abs=1e-9)


@pytest.mark.parametrize("off_us", [-1, 1])
@pytest.mark.parametrize("step_us", [2000, 5000, 20000])
def test_a_message_a_microsecond_off_a_sample_loses_no_loop(step_us, off_us):
    """The shortest step of the model, of which rounding leaves less."""
    loop = Live("velocity-attitude", gyro_noise=np.full(3, 6e-5), accel_noise=np.full(3, 1e-3))
    nav = {"lat_lon_height": [0.6, 0.1, 0], "v_n": np.zeros(3), "q_b2n_wxyz": [1, 0, 0, 0], "q_b2m_wxyz": [1, 0, 0, 0]}
    loop.begin(0, nav, phi=0.1, dv_n=3.0, dmu=0.02)
    for k in range(1, 106):
        loop.sample(step_us * k, 1e-6 * step_us, dtheta_ib_b=np.zeros(3), dv_b=[0, 0, -9.79e-6 * step_us])
        if k % 10 == 0:
            loop.message("velocity", step_us * (k - 2) + off_us, np.full(3, 4e-4), v_m_n=np.zeros(3))
    assert loop.output(step_us * 105) and loop.counts()["TAKEN"] == 10


def test_states_that_are_considered_stay_and_the_rest_is_consistent():
    """Scale factors of 1000 ppm in turns of 2 g: NEES is 3000 of 16 without them."""
    one = Condition("scale 1000 ppm, considered", "consistent", "s-turns", change=scale_and_axes(1000.0, 0.0))
    flight = one.flight(runs=4)
    record = fly_live(flight, carrying=sensors.Sensors(1e-3, 1e-3))
    assert met(one.asked, one.refused, flight, record)


def test_a_delay_that_is_considered_stays_and_the_others_know_what_it_does_to_them():
    """It is 3.5 of its sigmas off in each run: 12.25 of the NEES, and 15 of the others."""
    flight = standard("calm", seconds=20.0, runs=6)
    flight = replace(flight, setting=replace(flight.setting, tau_believed=0.0, tau_sigma=0.01))
    record = fly_live(flight, considered=np.arange(16) == 15)
    P, errors = record.P[-1], record.errors[-1]
    np.testing.assert_allclose(1e3 * np.sqrt(P[:, 15, 15]), 10.0, rtol=1e-3)
    np.testing.assert_allclose(1e3 * errors[:, 15], -35.0, rtol=1e-3)
    assert 21 < judged(record, 20.0).nees < 34


def test_a_covariance_stands_in_place_of_sigmas_and_a_start_that_is_none_is_no_start(short):
    by_sigma, whole, P = loop_of(short), loop_of(short), np.diag(np.arange(1.0, 17.0) ** 2 * 1e-6)
    nav = {"q_b2n_wxyz": [1, 0, 0, 0], "q_b2m_wxyz": [1, 0, 0, 0]}
    by_sigma.begin(0, nav, np.arange(1.0, 17.0) * 1e-3)
    whole.begin(0, nav, P=P)
    assert np.allclose(whole.covariance()[0], P) and np.allclose(by_sigma.covariance()[0], P)
    with pytest.raises(BoresightError, match=r"P has shape \(16,\); give \(16, 16\)"):
        whole.begin(0, nav, P=np.ones(16))
    with pytest.raises(BoresightError, match="not_positive: P is no covariance of this model"):
        whole.begin(0, nav, P=-P)
    assert whole.sample(10_000, 0.01, dtheta_ib_b=np.zeros(3), dv_b=np.zeros(3)) == Status.NOT_READY


def test_a_clock_of_the_master_that_steps_is_followed_and_one_that_is_late_is_not():
    found, record = flown("stamps step by a week", runs=2)
    assert found.nees_end < 30 and found.refused < 0.05 and any("has stepped by" in text for *_, text in record.notes)
    late = np.int64(-2_000_000)  # a link that holds messages for two seconds says so in their stamps
    flight = standard(runs=1, seconds=12.0)
    stamps = flight.messages.stamp_us + late * (flight.messages.stamp_us > 5_000_000)
    slow = replace(flight, messages=replace(flight.messages, stamp_us=stamps))
    loop = loop_of(slow)
    fly(slow, loop)
    assert loop.counts()["OLD"] > 50 and loop.output(int(slow.end_us[-1]))["shift"] == 0


def codes(record):
    return " ".join(text for *_, text in record.notes)


def test_an_error_that_is_not_white_is_reported_though_each_message_fits():
    """A seat that bends by half a mrad: hardly a message is refused, and NEES is 90 of 16."""
    found, record = flown("flexure .5 mrad at .1 Hz", runs=1)
    assert found.refused < 0.01 and "of dcm follow each other over 64 messages" in codes(record)
    found, record = flown("R ten times", runs=1)
    assert "of velocity fits better than its variance says over 64 messages" in codes(record)


def test_samples_that_stood_still_are_forgotten_and_a_silence_is_reported():
    """The navigation is wrong, not the delay: what would be measured after it came tells so."""
    found, record = flown("slave stuck for 1 s", runs=2)
    assert found.nees_end < 40 and "in a row did not fit" in codes(record)
    _, record = flown("no message for 10 s", runs=1)
    assert codes(record).count("that could be waited for was measured for") == 2


def test_a_model_whose_transition_follows_exactly_has_a_loop(tmp_path):
    (tmp_path / "exact.py").write_text(
        "from dataclasses import replace\nfrom ahrs import SIX\n"
        'EXACT = replace(SIX, name="ahrs-exact", c_prefix="ax", exact=True)\n'
    )
    shutil.copy(ROOT / "examples" / "ahrs.py", tmp_path)
    generate(f"{tmp_path / 'exact.py'}:EXACT", tmp_path / "exact")
    loop = Live(load(tmp_path / "exact"), gyro_noise=np.full(3, 1e-3), bias_noise=np.full(3, 1e-5))
    loop.begin(0, {"q": [1, 0, 0, 0]}, theta=0.1, d_gyro_bias=0.01)
    record = Record(loop)
    for k in range(1, 101):
        loop.sample(10_000 * k, 0.01, gyro=[0.0, 0.0, 0.1])
    Phi, angle = record.Phi()[-1], 0.1 * (record.time[-1] - 0.02)  # of the body in the middle of the step
    C = np.array([[np.cos(angle), -np.sin(angle), 0], [np.sin(angle), np.cos(angle), 0], [0, 0, 1]])
    assert np.abs(Phi - np.block([[np.eye(3), 0.04 * C], [np.zeros((3, 3)), np.eye(3)]])).max() < 1e-4
