"""The lever arm: given in the master's axes; and whether the velocity residuals show that it is wrong."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from boresight import BoresightError
from boresight.runtime import rotation
from boresight.runtime.array import Array


class LeverOfMaster:
    """A model whose lever arm is known in the master's axes: what takes `lever_b` takes `lever_m` and the mounting.

    lever_b = C_b2m' lever_m, and what lever_b of nav adds where it is a state.  The mounting's error turns it, by
    -C_b2m' [lever_m x] dmu, which enters H beside what dmu does there already.
    """

    def __init__(self, model: Any):
        self.model = model
        self.field = {**model.field, "lever_m": {**model.field["lever_b"], "name": "lever_m"}}
        self.mounting = [i for i, name in enumerate(model.states) if name.startswith("dmu")]
        self.state = "lever_b" in model.feedback.fields

    def __getattr__(self, name: str) -> Any:
        found = getattr(self.model, name)
        if name == "feedback" or "lever_b" not in getattr(found, "fields", ()):
            return found
        if name.endswith("_h"):
            raise BoresightError(f"{self.model.name}: {name} cannot take lever_m; give lever_b, in the slave's axes")
        return OfMaster(self, name, found)

    def __dir__(self) -> list[str]:
        return [*dir(self.model), "model", "mounting", "state"]


class OfMaster:
    """One function of such a model."""

    def __init__(self, owner: LeverOfMaster, name: str, unit: Any):
        self.owner, self.unit, self.is_H = owner, unit, name.endswith("_H")
        needed = {*unit.fields, "q_b2m_wxyz", *(owner.model.expected.fields if self.is_H else ())}
        self.fields = (*sorted(needed - {"lever_b"}), "lever_m", *(["lever_b"] if owner.state else []))

    def __call__(self, **given: Any) -> Any:
        lever_m = np.asarray(given.pop("lever_m"), float)
        C_m2b = np.swapaxes(rotation.matrix_from_quaternion(given["q_b2m_wxyz"]), -1, -2)
        given["lever_b"] = given.get("lever_b", 0.0) + np.einsum("...ij,...j->...i", C_m2b, lever_m)
        out = self.unit(**{name: given[name] for name in self.unit.fields})
        if not self.is_H:
            return out
        # velocity is linear in the lever arm
        expected = self.owner.model.expected
        at = {name: given[name] for name in expected.fields}
        v = expected(**at)["v_m_n"]
        by_lever = np.stack(
            [(expected(**{**at, "lever_b": at["lever_b"] + 0.1 * e})["v_m_n"] - v) / 0.1 for e in np.eye(3)], axis=-1
        )
        skew = np.cross(np.eye(3), lever_m[..., None, :])  # [lever_m x]
        runs = np.broadcast_shapes(out.shape[:-2], by_lever.shape[:-2], C_m2b.shape[:-2])
        out = np.array(np.broadcast_to(out, (*runs, *out.shape[-2:])))
        out[..., self.owner.mounting] -= by_lever @ C_m2b @ skew
        return out


def flown(model: Any, constants: Mapping[str, Any]) -> Any:
    """The model, of a lever arm in the master's axes if that is what is known."""
    return LeverOfMaster(model) if "lever_m" in constants and not isinstance(model, LeverOfMaster) else model


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
        large = (self.messages >= 50) & (self.large > 0.15 * self.messages)
        return large & (self.share > 0.15) if large.any() else large
