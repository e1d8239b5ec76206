"""allantools: Allan deviations in NumPy."""

import numpy as np
from mpmath import mp

from boresight.evidence.crossed import exact
from boresight.evidence.crossed.judge import Check, Numbers, Peer


def deviation() -> Numbers:
    import allantools

    from boresight.analysis.allan import variances

    rates = np.random.Generator(np.random.PCG64(3)).standard_normal(256)
    lengths = np.array([1, 2, 4, 8, 16])
    _, theirs, _, _ = allantools.oadev(rates, rate=1.0, data_type="freq", taus=lengths)
    true = [mp.sqrt(exact.allan(rates, int(m))) for m in lengths]
    return Numbers(np.sqrt(variances(rates, 1.0, lengths)), theirs, true, 20.0, 10)


PEER = Peer("allantools", __file__, (Check("overlapping Allan deviation", "1", deviation, ("analysis/allan.py",)),))
