"""Phi and every H of examples/autopilot.py beside SymForce's print of them: python -m benchmarks.autopilot

The equations are written once more, in SymForce's terms: the truth is the estimate less an error, both are carried over
a step, and what SymForce differentiates and prints is held against the generated C.  The step is the one that PX4's
autopilot takes, with a quaternion of the first order; Boresight's follows with `exact=True`.
"""

import importlib.util
import sys
import tempfile
import time
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
from sympy import Matrix

from boresight import Model, generate, load, rotation
from boresight.examples import autopilot
from boresight.mechanics import normalized, quaternion_product

EQUAL = 1e-12  # of the largest entry of a row
POINTS = 200
NAMES = ("q", *autopilot.nav)


def first_order() -> Model:
    """The autopilot with the turn of a step as [1, turn / 2], and Phi the derivative of that step."""
    rate = autopilot.turn.vector - autopilot.nav["gyro_bias"].vector * autopilot.step
    model = autopilot.AUTOPILOT
    strapdown, feedback = model.functions
    q = normalized(quaternion_product(autopilot.q.vector, Matrix([1, *(rate / 2)])))
    carried = tuple(replace(one, value=q) if one.name == "q" else one for one in strapdown.outputs)
    functions = (replace(strapdown, outputs=carried), feedback)
    order = type(model).order
    return replace(model, name="autopilot-step", c_prefix="as", functions=functions, exact=True, order=order)


# ---------------------------------------------------------------- the same in SymForce


def symforce_matrices() -> tuple[dict[str, Any], dict[str, Any]]:
    """What is read, and Phi and each H by its name; SymForce's symbols."""
    import symforce

    symforce.set_epsilon_to_number(0.0)
    import symforce.symbolic as sf

    vectors = {name: sf.Matrix(v.size, 1).symbolic(name) for name, v in autopilot.nav.items()}
    read = {"q": sf.V4.symbolic("q"), **vectors, "turn": sf.V3.symbolic("turn"), "gain": sf.V3.symbolic("gain"),
            "dt": sf.Symbol("dt"), "offset": sf.Symbol("offset"), "side": sf.V4.symbolic("side")}  # fmt: skip
    error = sf.Matrix(24, 1).symbolic("x")
    zero = {e: 0 for e in error}

    def quaternion(w, xyz):
        return sf.Quaternion(xyz=sf.V3(*xyz), w=w)

    def step(state):
        rate = read["turn"] - state["gyro_bias"] * read["dt"]
        C = sf.Rot3(state["q"]).to_rotation_matrix()
        gained = C * (read["gain"] - state["accel_bias"] * read["dt"]) + sf.V3(0, 0, 9.81) * read["dt"]
        moved = {"q": state["q"] * quaternion(1, rate / 2), "vel": state["vel"] + gained,
                 "pos": state["pos"] + state["vel"] * read["dt"]}  # fmt: skip
        return state | moved

    q_hat = quaternion(read["q"][0], read["q"][1:])
    hat = {"q": q_hat, **vectors}
    true, at = {"q": quaternion(1, error[:3, :] / 2) * q_hat}, 3
    for name, v in vectors.items():
        true[name], at = v - error[at : at + v.shape[0], :], at + v.shape[0]
    hat_after, after = step(hat), step(true)
    turned = after["q"] * hat_after["q"].inverse()
    grown = sf.Matrix.block_matrix([[sf.V3(turned.x, turned.y, turned.z) * 2],
                                    *([hat_after[name] - after[name]] for name in vectors)])  # fmt: skip

    def seen(state):
        """What each sensor shows.  side: the signs of what a small number keeps off zero."""
        C, side = sf.Rot3(state["q"]).to_rotation_matrix(), read["side"]
        air = state["vel"] - sf.V3(state["wind"][0], state["wind"][1], 0)
        air_b, v_b = C.T * air, C.T * state["vel"]
        pair = C * sf.V3(sf.cos(read["offset"]), sf.sin(read["offset"]), 0)
        height = state["terrain"][0] - state["pos"][2]
        mag_i = state["mag_i"]
        return {
            "mag": C.T * mag_i + state["mag_b"],
            "yaw": sf.V1(sf.atan2(C[1, 0], C[0, 0] + 1e-6)),
            "airspeed": sf.V1(sf.sqrt(air.dot(air) + 1e-6)),
            "sideslip": sf.V1(sf.atan2(air_b[1], air_b[0] + 1e-3 * side[0])),
            "flow": sf.V2(v_b[1], -v_b[0]) / (height + 0.1 * side[1]) * C[2, 2],
            "antennas": sf.V1(sf.atan2(pair[1], pair[0] + 1e-6 * side[2])),
            "declination": sf.V1(sf.atan2(mag_i[1], mag_i[0] + 1e-6 * side[3])),
            "velocity": state["vel"],
            "position": state["pos"],
            "height": sf.V1(height),
        }

    made = {"Phi": grown.jacobian(error).subs(zero)}
    made |= {f"{name}_H": -h.jacobian(error).subs(zero) for name, h in seen(true).items()}
    return read, made


def printed(folder: Path) -> Any:
    """SymForce's functions, in Python: a module with phi, mag_h and so on."""
    from symforce import codegen
    from symforce.values import Values

    read, made = symforce_matrices()
    functions = {}
    for name, matrix in made.items():
        code = codegen.Codegen(Values(**read), Values(out=matrix), codegen.PythonConfig(use_eigen_types=False),
                               name=name.lower(), return_key="out")  # fmt: skip
        path = code.generate_function(folder / name, skip_directory_nesting=True).function_dir / f"{name.lower()}.py"
        spec = importlib.util.spec_from_file_location(name.lower(), path)
        assert spec and spec.loader
        module = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(module)
        functions[name] = getattr(module, name.lower())
    return functions


# ---------------------------------------------------------------- the comparison


def points(rng: np.random.Generator) -> dict[str, Any]:
    """States and increments of flights, at random."""
    q = rng.standard_normal((POINTS, 4))
    sizes = {"vel": 20, "pos": 30, "gyro_bias": 0.1, "accel_bias": 0.5, "mag_i": 0.5, "mag_b": 0.1, "wind": 8}
    at = {name: size * rng.uniform(-1, 1, (POINTS, autopilot.nav[name].size)) for name, size in sizes.items()}
    at |= {"q": q / np.linalg.norm(q, axis=-1, keepdims=True), "terrain": rng.uniform(40, 200, POINTS)}
    at |= {"delta_ang": rng.uniform(-0.1, 0.1, (POINTS, 3)), "delta_vel": rng.uniform(-0.1, 0.1, (POINTS, 3))}
    return at | {"dt": rng.uniform(1e-3, 0.02, POINTS), "antenna_offset": rng.uniform(-3, 3, POINTS)}


def sides(at: dict[str, Any]) -> Any:
    """On which side of zero lies what the model keeps off zero, (POINTS, 4)."""
    C = rotation.matrix_from_quaternion(at["q"])
    nose = np.einsum("ki,ki->k", C[:, :, 0], at["vel"] - np.pad(at["wind"], ((0, 0), (0, 1))))
    pair = C[:, 0, 0] * np.cos(at["antenna_offset"]) + C[:, 0, 1] * np.sin(at["antenna_offset"])
    small = np.stack([nose, at["terrain"] - at["pos"][:, 2], pair, at["mag_i"][:, 0]], -1)
    return np.where(small < 0, -1.0, 1.0)


def differences(folder: Path, rng: np.random.Generator) -> dict[str, float]:
    """By function: the largest difference as a part of the largest of its row, double."""
    libraries = {name: load(generate(model, folder / name).folder) for name, model in
                 (("Phi", first_order()), ("H", autopilot.AUTOPILOT))}  # fmt: skip
    theirs, at = printed(folder / "symforce"), points(rng)
    side, found = sides(at), {}
    for name, function in theirs.items():
        unit = libraries["Phi" if name == "Phi" else "H"].units[name]
        ours = unit(**{field: at[field] for field in unit.fields})
        ours = np.broadcast_to(ours, (POINTS, *np.shape(ours)[-2:]))  # of what reads nothing, one for all
        worst = 0.0
        for k in range(POINTS):
            given = [np.reshape(at[key][k], (-1, 1)) for key in NAMES]
            given += [at["delta_ang"][k][:, None], at["delta_vel"][k][:, None], at["dt"][k], at["antenna_offset"][k]]
            wanted = np.reshape(function(*given, side[k][:, None]), np.shape(ours[k]))
            size = np.abs(wanted).max(-1, keepdims=True)
            worst = float(np.fmax(worst, np.max(np.abs(ours[k] - wanted) / size)))
        found[name] = worst
    return found


def main() -> int:
    begun = time.process_time()
    with tempfile.TemporaryDirectory() as place:
        found = differences(Path(place), np.random.default_rng(0))
    for name, worst in found.items():
        print(f"{name:14} {worst:9.1e}  {'equal' if worst <= EQUAL else 'DIFFERS'}")
    took = time.process_time() - begun
    print(f"{POINTS} points; the largest difference as a part of the largest of its row; {took:.0f} s")
    return int(not all(worst <= EQUAL for worst in found.values()))


if __name__ == "__main__":
    sys.exit(main())
