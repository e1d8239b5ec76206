"""What z is, for every measurement of every model: H times the error, and what the header says in words.

The estimates of a slave are wrong by an error in one state, put in by hand as docs/conventions.md defines it.  What is
measured is exact: it follows from the true state, by finite rotations, in the mechanics below.
"""

import json
import re
from pathlib import Path

import numpy as np
import pytest
from numpy_euler_matching import angles, exp, log, quaternion, wrap

from boresight.codegen.generate import model_names
from boresight.runtime.library import load
from boresight.runtime.manifest import GENERATED, folder_of

EARTH_RATE, SEMI_MAJOR_AXIS, ECCENTRICITY_SQUARED = 7.292115e-5, 6378137.0, 0.0066943799901413165
SIZES = {"1": 1e-3, "rad": 1e-3, "m/s": 1e-2, "rad/s": 1e-4, "m/s^2": 1e-2, "s": 1e-3, "m": 1e-2}
ROUNDING = 1e-13  # of velocities of some m/s and of matrices
MANIFESTS = {name: json.loads((folder_of(name) / "manifest.json").read_text()) for name in model_names()}
MEASUREMENTS = [(model, name) for model, manifest in MANIFESTS.items() for name in manifest["measurements"]]
TURN = "e the turn from the computed to the measured one"
WORDS = re.compile(rf"z = (computed - measured|[+-]e, {TURN})")


def earth_rate(lat):
    """Of the Earth, in NED."""
    return EARTH_RATE * np.array([np.cos(lat), 0.0, -np.sin(lat)])


def transport_rate(lat, height, v):
    w = np.sqrt(1 - ECCENTRICITY_SQUARED * np.sin(lat) ** 2)
    meridian, transverse = SEMI_MAJOR_AXIS * (1 - ECCENTRICITY_SQUARED) / w**3 + height, SEMI_MAJOR_AXIS / w + height
    return np.array([v[1] / transverse, -v[0] / meridian, -v[1] * np.tan(lat) / transverse])


def situation(model, name):
    """The true state of a slave: numbers by name; C_b2n, C_b2m are matrices."""
    rng = np.random.default_rng(7)
    C_b2n, C_b2m = (exp(rng.uniform(-0.7, 0.7, 3)) for _ in range(2))
    linear = name in ("euler", "dcm")  # to first order in the misalignment, or in the time by which attitude goes back
    true = {
        "position": np.array([0.6, 0.3, 20.0]), "v_n": rng.uniform(-9, 9, 3), "C_b2n": C_b2n, "C_b2m": C_b2m,
        "gyro_bias": rng.uniform(-1e-3, 1e-3, 3), "accel_bias": rng.uniform(-0.1, 0.1, 3), "tau": np.array([0.05]),
        "omega_ib_b": rng.uniform(-0.4, 0.4, 3), "f_b": np.array([0.1, 0.2, 9.8]), "lever_b": rng.uniform(-8, 8, 3),
        "lag": np.array([0.0 if linear else 0.2]), "a_n": rng.uniform(-3, 3, 3), "reference_error": np.zeros(1),
        "omega_nm_n": rng.uniform(-0.5, 0.5, 3), "mu": (0.0 if linear else 0.2) * rng.uniform(-1, 1, 3),
    }  # fmt: skip
    if model == "velocity-attitude-sensors":  # to first order in the bending
        sizes = {"flexure": 0.0, "flexure_rate": 0.3, "gyro_scale": 0.03, "gyro_axes": 0.03}
        true |= {key: size * rng.uniform(-1, 1, 6 if "axes" in key else 3) for key, size in sizes.items()}
    if model.startswith("azimuth-hold"):  # at rest, in ENU: longitude first
        east_north_up = earth_rate(true["position"][1])[[1, 0, 2]] * [1, 1, -1]
        true |= {"v_n": np.zeros(3), "omega_ib_b": C_b2n.T @ east_north_up}
    return true


def with_error(model, true, block, error):
    """The estimates where one block of the error state is `error`, estimated - true."""
    out = dict(true)
    added = {
        "d_position": "position", "dv_n": "v_n", "d_gyro_bias": "gyro_bias", "d_accel_bias": "accel_bias",
        "d_lever": "lever_b", "d_reference_error": "reference_error", "d_tau": "tau",
    }  # fmt: skip
    added |= {f"d_{key}": key for key in ("flexure", "flexure_rate", "gyro_scale", "gyro_axes")}
    if block in added:
        out[added[block]] = true[added[block]] + error
    if block in ("phi", "psi", "eps"):
        out["C_b2n"] = exp(-error) @ true["C_b2n"]  # C_hat = (I - [e x]) C
    if block == "d_gyro_bias":
        out["omega_ib_b"] = true["omega_ib_b"] - error  # too much is taken off what the gyros measure
    if block == "dmu":
        out |= {"mu": true["mu"] + error, "C_b2m": exp(-error) @ true["C_b2m"]}
    if block == "d_tau":
        out["lag"] = true["lag"] + error
        if model == "velocity-dcm":  # the slave is given as it was tau_hat ago, which is that much too early
            out["v_n"] = true["v_n"] - true["a_n"] * error
            out["C_b2n"] = exp(-true["omega_nm_n"] * error) @ true["C_b2n"]
    return out


def predicted(model, name, s, v_of_level):
    """The quantity that is measured, for a state: a velocity, a rate, Euler angles or an attitude (3, 3).

    v_of_level: the velocity with which the level turns.  The models take the estimate, 1.6e-7 rad/s for each m/s of it.
    """
    if model.startswith("azimuth-hold"):
        east_north_up = earth_rate(s["position"][1])[[1, 0, 2]] * [1, 1, -1]
        rate = s["omega_ib_b"] - s["C_b2n"].T @ east_north_up
        return {"zupt": s["v_n"], "zaru": rate, "azimuth": s["C_b2n"]}[name]
    if model == "velocity-dcm":
        return s["v_n"] if name == "velocity" else s["C_b2n"] @ exp(-s["mu"])
    if model == "euler-matching":
        return angles(s["C_b2n"] @ exp(-s["mu"]))
    if model == "velocity-attitude-sensors":
        s = of_the_hull(s)
    lat, _, height = s["position"]
    omega_nb = s["C_b2n"] @ s["omega_ib_b"] - earth_rate(lat) - transport_rate(lat, height, v_of_level)
    if name == "velocity":
        return s["v_n"] - np.cross(omega_nb, s["C_b2n"] @ s["lever_b"]) - s["a_n"] * s["lag"]
    C_m2n = exp(-omega_nb * s["lag"]) @ s["C_b2n"] @ s["C_b2m"].T
    return angles(C_m2n) if name == "euler" else C_m2n


def of_the_hull(s):
    """The state with its rates as they are, without the bending's, and the bending in the mounting."""
    K = np.diag(s["gyro_scale"])
    K[[0, 0, 1, 1, 2, 2], [1, 2, 0, 2, 0, 1]] = s["gyro_axes"]
    rate = s["omega_ib_b"] - K @ s["omega_ib_b"] - s["C_b2m"].T @ s["flexure_rate"]
    return s | {"omega_ib_b": rate, "C_b2m": exp(s["flexure"]) @ s["C_b2m"]}


def turn_from(computed, measured):
    return log(measured @ computed.T)


def states(model):
    """Of each state: its block, where the block begins and ends, and its unit."""
    out, first = [], 0
    for block in MANIFESTS[model]["blocks"]:
        units = block["unit"].split(", ")
        units = units if len(units) == block["size"] else units * block["size"]
        out += [(block["name"], slice(first, first + block["size"]), unit) for unit in units]
        first += block["size"]
    return out


def seen(library, model, name, index, size):
    """z, H x and what the words make of the same, for an error of that size in one state."""
    block, part, unit = states(model)[index]
    x = np.zeros(len(library.states))
    x[index] = size * SIZES[unit]
    true = situation(model, name)
    hat = with_error(model, true, block, x[part])
    computed, measured = (predicted(model, name, s, hat["v_n"]) for s in (hat, true))

    fields = {key: value if len(value) > 1 else value[0] for key, value in hat.items() if not key.startswith("C_")}
    fields |= {"q_b2n_wxyz": quaternion(hat["C_b2n"]), "q_b2m_wxyz": quaternion(hat["C_b2m"]), "x": 0 * x}
    fields |= dict.fromkeys(("lat_lon_height", "lon_lat_height"), hat["position"])  # the frame's
    if name == "azimuth":
        about_up = np.array([0.0, 0.0, 1.0])
        C_ref = exp(-about_up * true["reference_error"]) @ true["C_b2n"]
        fields["q_ref_wxyz"] = quaternion(C_ref)
        measured = exp(about_up * hat["reference_error"]) @ C_ref  # with the estimate of its error taken out
    elif "euler" in name:
        fields |= {"euler_b": angles(hat["C_b2n"]), "euler_m": measured}
    else:
        fields |= {"v_m_n": measured, "q_m2n_wxyz": quaternion(measured) if measured.ndim == 2 else None}
    z, H = (
        np.asarray(unit(**{field: fields[field] for field in unit.fields}))
        for unit in (getattr(library, f"{name}_{part}") for part in "zH")
    )
    if measured.ndim == 2:
        e = turn_from(computed, measured)
        difference = {"+e": e, "-e": -e}
        difference = {sign: value[2:] if name == "azimuth" else value for sign, value in difference.items()}
    else:
        difference = {"computed - measured": wrap(computed - measured) if "euler" in name else computed - measured}
    return z, H @ x, difference


def comment_of(header, function):
    """The comment above a function, as one line."""
    text = header.read_text()
    above = text[: re.search(rf"\b{function}\(", text).start()].rsplit("/*", 1)[1]
    return re.sub(r"\s+(\* )?", " ", above)


def words(model, name):
    """What the headers and the manifest say that z is; all three the same."""
    folder, manifest = folder_of(model), MANIFESTS[model]
    stem, prefix = folder.name, manifest["c_prefix"]
    places = (
        comment_of(folder / "include" / f"{stem}.h", f"{prefix}_{name}_z"),
        comment_of(folder / "include" / f"{stem}_filter.h", f"{prefix}_filter_measure_{name}"),
        manifest["measurements"][name]["meaning"],
    )
    said = [WORDS.findall(place) for place in places]
    assert all(found == said[0] and len(found) == 1 for found in said), places
    return said[0][0].removesuffix(f", {TURN}")


@pytest.mark.parametrize(("model", "name"), MEASUREMENTS)
def test_z_is_H_times_an_error_in_each_state_and_what_the_header_says(model, name):
    library, said = load(model), words(model, name)
    largest = 0.0
    for index, state in enumerate(library.states):
        z, Hx, difference = zip(*(seen(library, model, name, index, size) for size in (1.0, 0.5)), strict=True)
        for other in (Hx, [part[said] for part in difference]):
            coarse, fine = (np.abs(a - b).max() for a, b in zip(z, other, strict=True))
            assert fine < ROUNDING or coarse / fine > 3.5, (state, coarse, fine)
            assert coarse < 0.02 * np.abs(z[0]).max() + ROUNDING, (state, coarse, z[0])
        largest = max(largest, np.abs(z[0]).max())
    assert largest > 1e6 * ROUNDING, "no error is large enough to tell a sign"


def test_the_conventions_say_of_every_measurement_what_its_header_says():
    text = (Path(__file__).parents[2] / "docs" / "conventions.md").read_text()
    rows = re.findall(r"^\| ([a-z-]+): (\w+) \| (.*) \|$", text, re.MULTILINE)
    assert {(model, name): said for model, name, said in rows} == {pair: words(*pair) for pair in MEASUREMENTS}


def test_no_header_calls_z_a_measured_less_a_predicted_value():
    for header in GENERATED.glob("*/include/*.h"):
        assert "minus predicted" not in header.read_text(), header
    for header in GENERATED.glob("*/include/*_filter.h"):
        if header.name != "boresight_filter.h":
            assert "nu = z - H x, or z - h(x)" in re.sub(r"\s+(\* )?", " ", header.read_text()), header
