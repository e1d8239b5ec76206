"""The generated folders, and what is committed of each."""

from boresight.evidence import results
from boresight.evidence.sources import Folder, folders

NAMES = [folder.name for folder in folders()]


def folder_of(name):
    return next(folder for folder in folders() if folder.name == name)


def committed(name, kind):
    """What a run of `make evidence` left, by unit."""
    of = results.read(folder_of(name)).get(kind)
    assert of, f"no {kind} is committed of {name}: run 'make evidence'"
    return of["units"]


def spoilt(copy, path, old, new):
    """The copied folder of Euler matching with one file spoilt, whose manifest vouches for it."""
    text = (copy / path).read_text()
    assert old in text
    (copy / path).write_text(text.replace(old, new))
    folder = Folder(copy)
    folder.__dict__["manifest"] = folder_of("euler_matching").manifest
    return folder
