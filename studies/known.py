"""The studies that there are: each is imported when it is asked for, so that a list of them costs nothing."""

from importlib import import_module

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
MODULES = ("euler_table.table", "euler_table.exploration", "azimuth_hold.hold", "azimuth_hold.shock",
           "azimuth_hold.exploration", "sea_state.experiment", "sea_state.claims", "sea_state.exploration",
           "float_covariance.covariance")  # fmt: skip


def study(name: str) -> Study:
    """The study of that name.  Raises BoresightError for a name that none has."""
    if name not in STUDIES:
        raise BoresightError(f"no study {name!r}; there are {', '.join(STUDIES)}")
    module = dict(zip(STUDIES, MODULES, strict=True))[name]
    found: Study = import_module(f"boresight.studies.{module}").STUDY
    return found
