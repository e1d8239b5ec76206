"""Worlds: witnesses ready for a paper of one's own, whose letters are bound to their values by name."""

from boresight import BoresightError
from boresight.derive.papers.worlds.kalman import KALMAN
from boresight.derive.papers.worlds.motion import MOTION
from boresight.derive.papers.worlds.strapdown import ECEF, ENU, NED
from boresight.derive.papers.worlds.world import World
from boresight.errors import did_you_mean

WORLDS: dict[str, World] = {world.name: world for world in (MOTION, NED, ENU, ECEF, KALMAN)}


def world(name: str) -> World:
    """Raises BoresightError with the names that there are."""
    if name not in WORLDS:
        raise BoresightError(f"no witness {name!r}{did_you_mean(name, WORLDS)}; there are {', '.join(WORLDS)}")
    return WORLDS[name]
