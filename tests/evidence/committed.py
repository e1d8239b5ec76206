"""The generated folders, and what is committed of each."""

from tools import lacks

from boresight.codegen.folder import Folder, folders
from boresight.evidence import results
from boresight.evidence.kind import KINDS, is_small

NAMES = [folder.name for folder in folders()]
# What costs with the third power of the states is not made of the largest.
SMALL = [folder.name for folder in folders() if is_small(folder)]
LIVE = "strapdown"  # the folder whose compilers and emulators run in these tests; of the others the results are judged


def folder_of(name):
    return next(folder for folder in folders() if folder.name == name)


def committed(name, kind):
    """What a run of `make evidence` left, by unit."""
    of = results.read(folder_of(name)).get(kind)
    assert of, f"no {kind} is committed of {name}: run 'make evidence'"
    return of["units"]


def comparable(name, kind):
    """What is committed, if the tools here are those that made it."""
    (tools,) = (k.tools() for k in KINDS if k.name == kind)
    found, made_with = committed(name, kind), results.read(folder_of(name))[kind]["tools"]
    if made_with != tools:
        lacks(f"the tools of the committed {kind}", f"{name} is of {made_with}, here is {tools}; run 'make evidence'")
    return found


def spoilt(copy, path, old, new):
    """The copied folder with one file spoilt, whose manifest vouches for it."""
    text = (copy / path).read_text()
    assert old in text
    (copy / path).write_text(text.replace(old, new))
    folder = Folder(copy)
    folder.__dict__["manifest"] = folder_of(copy.name).manifest
    return folder
