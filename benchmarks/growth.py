"""What making a model's C takes as its states grow: python -m benchmarks.growth [STATES]...

The model is phi-error with random constants behind it, each triad of which drives velocity or attitude through C_b2n.
Printed are processor seconds of all its files from scratch, and their megabytes.
"""

import sys
import time

from sympy import Matrix, eye, zeros

from boresight.codegen.text.files import folder_files
from boresight.derive.mechanics.rotation import dcm_from_quaternion
from boresight.derive.model import Model, Struct
from boresight.derive.models.phi_error import phi_error
from boresight.derive.models.variables import body, noise_density

STATES = (15, 30, 45, 60)


def grown(n: int) -> Model:
    """phi-error with n states, all but 9 of them constants."""
    core = phi_error()
    C_b2n = dcm_from_quaternion(next(v for v in core.inputs if v.name == "q_b2n_wxyz").vector)
    triads = range((n - core.n) // 3)
    F, G = zeros(n), zeros(n, core.noise.rows + 3 * len(triads))
    for k in triads:
        at, driven = core.n + 3 * k, 3 + 3 * (k % 2)
        F[driven : driven + 3, at : at + 3] = C_b2n
        G[at : at + 3, at - 3 : at] = eye(3)
    noises = tuple(noise_density(f"noise_{k}", "1/sqrt(s)", f"constants {k}", 0.1) for k in triads)
    return core.extend(
        name=f"grown-{n}",
        c_prefix=f"g{n}",
        title=f"phi-error with constants, {n} states",
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
