"""What making a model's C takes as its states grow: python -m benchmarks.growth [STATES]...

The model is phi-error without its position, and random constants behind it, each triad of which drives velocity or
attitude through C_b2n.
Printed are processor seconds of all its files from scratch, and their megabytes.
"""

import sys
import time
from dataclasses import replace

from sympy import Matrix, eye, zeros

from boresight.codegen.text.files import folder_files
from boresight.derive.mechanics.rotation import dcm_from_quaternion
from boresight.derive.model import Measurement, Model, Struct
from boresight.derive.models.phi_error import phi_error
from boresight.derive.models.variables import body, noise_density

STATES = (6, 15, 30, 45, 60)


def grown(n: int) -> Model:
    """phi-error without its position, measured in velocity, with n states, all but 6 of them constants."""
    whole = phi_error()
    assert whole.F is not None
    C_b2n = dcm_from_quaternion(next(v for v in whole.inputs if v.name == "q_b2n_wxyz").vector)
    v_n = next(v for v in whole.inputs if v.name == "v_n").vector
    measured = Measurement("velocity", ("e", "n", "u"), "m/s", "velocity at rest: z = computed - measured",
                           z=v_n, H=Matrix.hstack(eye(3), zeros(3)))  # fmt: skip
    core = replace(
        whole,
        name=f"grown-{n}",
        c_prefix=f"g{n}",
        title=f"phi-error with constants, {n} states",
        states=whole.states[1:],
        F=whole.F[3:, 3:],
        G=whole.G[3:, :],
        functions=(),
        mechanics=None,
        measurements=(measured,),
    )
    triads = range((n - core.n) // 3)
    if not triads:
        return core
    F, G = zeros(n), zeros(n, core.noise.rows + 3 * len(triads))
    for k in triads:
        at, driven = core.n + 3 * k, 3 * (k % 2)
        F[driven : driven + 3, at : at + 3] = C_b2n
        G[at : at + 3, at - core.n + core.noise.rows : at - core.n + core.noise.rows + 3] = eye(3)
    noises = tuple(noise_density(f"noise_{k}", "1/sqrt(s)", f"constants {k}", 0.1) for k in triads)
    return core.extend(
        name=core.name,
        c_prefix=core.c_prefix,
        states=tuple(body(f"constants_{k}", f"c{k}", "1", f"constants {k}", -1.0, 1.0) for k in triads),
        structs=(Struct("walk", "process noise of the constants", noises),),
        F=F,
        G=G,
        noise=Matrix.vstack(*(v.vector for v in noises)),
    )


def main() -> None:
    for n in map(int, sys.argv[1:] or STATES):
        start = time.process_time()
        _, files = folder_files(grown(n), lambda test, tested: None)
        seconds = time.process_time() - start
        print(f"{n} states: {seconds:.1f} s, {sum(map(len, files.values())) / 1e6:.1f} MB", flush=True)


if __name__ == "__main__":
    main()
