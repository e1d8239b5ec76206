"""The simulator's Earth and the model's are two texts; they must say the same."""

import numpy as np

from boresight.runtime.simulation.sensors import earth_rate_n


def test_at_rest_the_level_turns_with_the_earth(library):
    for lat in np.radians([-80, -36, 0, 36, 80]):
        ours = library.omega_in_n(lat=lat, height=100.0, v_n=np.zeros(3))
        np.testing.assert_allclose(ours, earth_rate_n(lat), rtol=0, atol=1e-19)
