"""Two compositions of velocity-attitude: a hull that bends, and sensors with scale factors and axes.

    boresight generate examples/velocity_attitude_options.py:flexure          # writes ./generated/flexure
    boresight generate examples/velocity_attitude_options.py:scale_factors

Each is a part of the built-in `velocity-attitude-sensors` put upon the plain model.  A part of one's own is written
like these: states, what carries and corrects their estimates, and the terms by which the measurements see them.
"""

from dataclasses import replace

from boresight import Model
from boresight.models import bent, scaled, velocity_attitude


def flexure() -> Model:
    """velocity-attitude with bending as a second-order Gauss-Markov process about each of the master's axes."""
    return replace(bent(velocity_attitude()), title="velocity and attitude matching on a hull that bends, 22 states")


def scale_factors() -> Model:
    """velocity-attitude with scale factors and axes of gyros and accelerometers."""
    return replace(scaled(velocity_attitude()), title="velocity and attitude matching with scale factors, 31 states")
