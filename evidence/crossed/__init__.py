"""The same number by Boresight, by an independent tool and in 50 digits.

A check gives three answers to one question.  Where ours and the peer's differ by more than rounding, the 50 digits say
who is right, and the check must say why; a verdict without a reason, and a reason without such a verdict, is a failure.
"""

from boresight.evidence.crossed import by_allantools, by_control, by_filterpy, by_gtsam, by_pyins, by_symforce
from boresight.evidence.crossed.judge import Peer

PEERS: tuple[Peer, ...] = tuple(
    by.PEER for by in (by_pyins, by_gtsam, by_symforce, by_filterpy, by_control, by_allantools)
)
