"""python-control: linear systems in NumPy."""

import numpy as np
from mpmath import mp

from boresight.evidence.crossed import exact
from boresight.evidence.crossed.judge import THEIRS, Check, Numbers, Peer
from boresight.runtime.filter import Filter
from boresight.runtime.library import load

OMEGA, DT = np.array([4e-3, -6e-3, 5e-3]), 10.0
PHI, Q = np.array([[1.0, 0.5], [0.0, 1.0]]), np.array([[1.0, 3.0], [3.0, 12.0]]) / 24
H, R = np.array([[1.0, 0.0]]), np.array([[0.25]])


class Given:
    """A model whose functions return what they are given."""

    states = ("place", "speed")

    @staticmethod
    def Phi(phi):
        return phi

    @staticmethod
    def Q(q):
        return q

    @staticmethod
    def place_H(h):
        return h


for function in ("Phi", "Q", "place_H"):
    getattr(Given, function).fields = (getattr(Given, function).__code__.co_varnames[0],)


def transition() -> Numbers:
    import control

    library = load("euler-matching")
    F = library.F(omega_in_n=OMEGA)
    theirs = control.c2d(control.ss(F, np.zeros((6, 1)), np.eye(6), np.zeros((6, 1))), DT).A
    true, _ = exact.discrete(F, np.zeros((6, 6)), mp.mpf(DT))
    return Numbers(library.Phi(omega_in_n=OMEGA, dt=DT), theirs, true, 1.0, 200)


def settled() -> Numbers:
    import control

    loop = Filter(Given(), {}, Q)
    for _ in range(300):
        loop.update("place", R, z=np.zeros(1), h=H)
        loop.predict(phi=PHI, q=Q)
    _, theirs, _ = control.dlqe(PHI, np.eye(2), H, Q, R)
    return Numbers(loop.P, theirs, exact.settled(PHI, Q, H, R), 1.0, 200)


PEER = Peer("control", __file__,
    (
        Check("transition over 10 s", "1", transition, ("euler_matching",), THEIRS,
              "the generated Phi is of second order, and 10 s are long for it; the peer has the exponential"),
        Check("covariance that has settled", "1", settled, ("runtime/filter/filter.py",)),
    ),
)  # fmt: skip
