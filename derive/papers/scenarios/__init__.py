"""Scenarios: witnesses ready for a paper of one's own, whose letters are bound to their values by name."""

from boresight import BoresightError
from boresight.derive.papers.scenarios.kalman import KALMAN
from boresight.derive.papers.scenarios.motion import MOTION
from boresight.derive.papers.scenarios.scenario import Scenario
from boresight.derive.papers.scenarios.strapdown import ECEF, ENU, NED
from boresight.errors import did_you_mean

SCENARIOS: dict[str, Scenario] = {scenario.name: scenario for scenario in (MOTION, NED, ENU, ECEF, KALMAN)}


def scenario(name: str) -> Scenario:
    """Raises BoresightError with the names that there are."""
    if name not in SCENARIOS:
        raise BoresightError(f"no witness {name!r}{did_you_mean(name, SCENARIOS)}; there are {', '.join(SCENARIOS)}")
    return SCENARIOS[name]
