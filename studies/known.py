"""The studies that there are: each is imported when it is asked for, so that a list of them costs nothing."""

from pathlib import Path

from boresight import BoresightError
from boresight.studies.study import Study

STUDIES = {
    "euler-table": "Table 1 of Song and Lee (2001), by covariance and by Monte Carlo.",
    "euler-exploration": "What decides that table, and whether its filter is consistent.",
    "azimuth-hold": "Kim (2018): an hour at rest after a transfer alignment, four ways.",
    "azimuth-shock": "The hold disturbed: what the detector and the gate notice.",
    "azimuth-exploration": "What decides the hold's covariance.",
    "sea-state": "Kang and others (2025): transfer alignment in sea states 1 to 6.",
    "sea-claims": "What the claims of that paper depend on, one change at a time.",
    "sea-exploration": "Which motions show which errors; how far a heading may be off.",
    "float-covariance": "What single precision does to a covariance.",
}
# What a paper leaves open, answered by computing.  A wheel holds none of it.
EXPLORATIONS = ("euler-exploration", "azimuth-exploration", "sea-claims", "sea-exploration")


def names() -> list[str]:
    """Of the studies that can be run here."""
    here = (Path(__file__).parent / "explorations").is_dir()
    return [name for name in STUDIES if here or name not in EXPLORATIONS]


def elsewhere() -> list[str]:
    """Of the studies that only the checkout holds, where this is none."""
    return [name for name in STUDIES if name not in names()]


def study(name: str) -> Study:
    """The study of that name.  Raises BoresightError for a name that none has, or that is in the checkout alone."""
    if name in elsewhere():
        raise BoresightError(f"study {name} is not installed; in the checkout: {', '.join(elsewhere())}")
    if name == "euler-table":
        from boresight.studies.euler_table.table import STUDY
    elif name == "euler-exploration":
        from boresight.studies.explorations.euler_table import STUDY
    elif name == "azimuth-hold":
        from boresight.studies.azimuth_hold.hold import STUDY
    elif name == "azimuth-shock":
        from boresight.studies.azimuth_hold.shock import STUDY
    elif name == "azimuth-exploration":
        from boresight.studies.explorations.azimuth_hold import STUDY
    elif name == "sea-state":
        from boresight.studies.sea_state.experiment import STUDY
    elif name == "sea-claims":
        from boresight.studies.explorations.sea_claims import STUDY
    elif name == "sea-exploration":
        from boresight.studies.explorations.sea_state import STUDY
    elif name == "float-covariance":
        from boresight.studies.float_covariance.covariance import STUDY
    else:
        raise BoresightError(f"no study {name!r}; there are {', '.join(names())}")
    return STUDY
