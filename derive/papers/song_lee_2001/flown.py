"""What \flown{name} stands for in the derivations: the functions that the models use, in the paper's letters."""

from collections.abc import Mapping

from sympy import ImmutableMatrix, Matrix, Symbol, eye
from sympy.simplify.fu import TR2i

from boresight.derive.expressions import unnamed
from boresight.derive.ledger.equation import total
from boresight.derive.mechanics.rotation import TINY_SQUARE, dcm_from_euler
from boresight.derive.papers.song_lee_2001 import results


def flown(letters: Mapping[str, Symbol]) -> dict[str, object]:
    """The matrices of results.py, with the tangents of the page."""

    def s(names: str) -> tuple:
        return tuple(letters[name] for name in names.split())

    def layout(M) -> ImmutableMatrix:
        return ImmutableMatrix(Matrix(M).applyfunc(TR2i))

    euler = phi, theta, psi = s("φ θ ψ")
    euler_b, euler_r = s("φ_b θ_b ψ_b"), s("φ_r θ_r ψ_r")
    turn = s("Δq_0 Δq_1 Δq_2 Δq_3")
    mu, eps, omega = s("μ_x μ_y μ_z"), s("ε_n ε_e ε_d"), s("ω_n ω_e ω_d")
    C, H = dcm_from_euler(*euler), layout(results.measurement_matrix(euler_b, euler_r))
    before, missed = s("μ̂(k-) δμ(k)")
    quaternion = unnamed(results.error_quaternion(eps))
    corrected = unnamed(results.corrected_quaternion(s("q̂_0 q̂_1 q̂_2 q̂_3"), eps))
    corrected = corrected.subs(dict(zip(quaternion, turn, strict=True)))
    found = {
        "C_b2n": ImmutableMatrix(C),
        "noise": ImmutableMatrix(results.attitude_noise_matrix(C)),
        "axes_after_yaw": ImmutableMatrix(results.axes_after_yaw(theta)),
        "axes_before_roll": ImmutableMatrix(results.axes_before_roll(theta)),
        "inverse_after_yaw": layout(results.axes_after_yaw(theta).lower_triangular_solve(eye(3))),
        "inverse_before_roll": layout(results.axes_before_roll(theta).upper_triangular_solve(eye(3))),
        "eps_D_euler": ImmutableMatrix(results.eps_D_euler(theta, psi)),
        "euler_D_eps": layout(results.euler_D_eps(theta, psi)),
        "beta_D_euler": ImmutableMatrix(results.beta_D_euler(phi, theta)),
        "euler_D_beta": layout(results.euler_D_beta(phi, theta)),
        "euler_D_mu": layout(results.relative_euler(euler_r, mu).jacobian(Matrix(mu))),
        "H": H,
        "H_eps": H[:, :3],
        "H_mu": -H[:, 3:],
        "F": ImmutableMatrix(results.attitude_error_matrix(omega)),
        "quaternion": ImmutableMatrix(quaternion.subs(TINY_SQUARE, 0)),
        "corrected_quaternion": ImmutableMatrix(corrected),
        # The function's own terms, in the order of the page.
        "corrected_mu": total(
            *sorted(results.corrected_misalignment(before, missed).args, key=lambda term: term != before)
        ),
    }
    found |= {f"change_{angle.name}": ImmutableMatrix(C.diff(angle)) for angle in euler}
    found |= {f"H_eps_{i}": H[i - 1, :3] for i in (1, 2, 3)}
    found |= {f"H_mu_{i}": -H[i - 1, 3:] for i in (1, 2, 3)}
    return found
