"""Whether the velocity residuals move with the turning of the hull, as a wrong lever arm makes them."""

from dataclasses import dataclass

import numpy as np

from boresight.runtime.array import Array


@dataclass(frozen=True)
class LeverSeen:
    """How far the velocity residuals move with the turning of the hull: the sums of a least-squares fit, run by run.

    A lever arm that is wrong by d puts -C (omega x d) into them.  The filter follows part of it, so that the fit shows
    that a lever arm is wrong, and not by how much.  No message weighs more than one that just fits.
    """

    N: Array  # (..., 3, 3)
    b: Array  # (..., 3)
    square: Array  # (...,) of the residuals over their sigmas
    messages: Array  # (...,)
    large: Array  # (...,) messages beyond the 95 % bound

    @staticmethod
    def nothing(runs: tuple[int, ...]) -> "LeverSeen":
        return LeverSeen(np.zeros((*runs, 3, 3)), np.zeros((*runs, 3)), *(np.zeros(runs) for _ in range(3)))

    def with_message(self, z: Array, S: Array, rows: Array, C_b2n: Array, omega_ib_b: Array) -> "LeverSeen":
        """z, S, rows: (..., 3) residuals, variances, and which there are."""
        A = -C_b2n @ np.cross(omega_ib_b[..., None, :], -np.eye(3))  # omega x d is the matrix of rows -omega x e_i
        nis = np.sum(rows * z**2 / S, axis=-1)
        weight = rows / S / np.maximum(1.0, nis / 3)[..., None]
        return LeverSeen(
            self.N + np.einsum("...ij,...i,...ik->...jk", A, weight, A),
            self.b + np.einsum("...ij,...i,...i->...j", A, weight, z),
            self.square + np.sum(weight * z**2, axis=-1),
            self.messages + rows.any(-1),
            self.large + (nis > 7.81),
        )

    @property
    def share(self) -> Array:
        """(...,) of the residuals' squares that such a movement explains; about 0.01 where the lever arm is right."""
        scale = np.maximum(np.einsum("...ii->...", self.N), 1e-300)[..., None, None]
        d = np.linalg.solve(self.N / scale + 1e-9 * np.eye(3), (self.b / scale[..., 0])[..., None])[..., 0]
        explained: Array = np.einsum("...i,...i->...", self.b, d) / np.maximum(self.square, 1e-300)
        return explained

    @property
    def suspect(self) -> Array:
        """(...,) bool, after 50 messages, three times as many beyond the bound as there should be."""
        return (self.messages >= 50) & (self.large > 0.15 * self.messages) & (self.share > 0.15)
