"""What `boresight generate` leaves in a model's folder, read without NumPy: names, files and their hashes."""

import hashlib
import json
import os
from collections.abc import Iterable
from pathlib import Path
from typing import Any

from platformdirs import user_cache_path

from boresight.errors import BoresightError, did_you_mean

GENERATED = Path(__file__).parent.parent / "generated"
EVIDENT = ("src/", "include/", "selftest/")


def built_in() -> list[str]:
    """Names of the models that are generated with the package."""
    return sorted(
        path.parent.name.replace("_", "-") for path in GENERATED.glob("*/manifest.json") if not is_component(path)
    )


def is_component(manifest: Path) -> bool:
    """Whether the folder holds C that comes from no model, as the detectors; its binding is its own."""
    try:
        return "component" in json.loads(manifest.read_text())
    except (OSError, ValueError):
        return False  # what cannot be read is reported by who reads it


def folder_of(model: str | Path) -> Path:
    """The generated folder of a built-in model's name, or the folder given."""
    if isinstance(model, str) and (GENERATED / model.replace("-", "_") / "manifest.json").is_file():
        return GENERATED / model.replace("-", "_")
    if (Path(model) / "manifest.json").is_file():
        return Path(model)
    raise BoresightError(
        f"no generated model {str(model)!r}{did_you_mean(str(model), built_in())}; built in are "
        f"{', '.join(built_in())}; for your own, give the folder that 'boresight generate FILE.py:NAME' wrote"
    )


def read_manifest(folder: Path) -> dict[str, Any]:
    """The folder's manifest, once every file it lists is found unchanged."""
    try:
        manifest = json.loads((folder / "manifest.json").read_text())
        files = manifest["files"]
    except (ValueError, KeyError, OSError) as error:
        raise BoresightError(f"{folder}/manifest.json cannot be read ({error}); run 'boresight generate'") from None
    for path, digest in files.items():
        try:
            content = (folder / path).read_bytes()
        except OSError:
            raise BoresightError(f"{folder / path} is missing; run 'boresight generate'") from None
        if hashlib.sha256(content).hexdigest() != digest:
            raise BoresightError(
                f"{folder / path} was edited since it was generated; change the model instead, delete the file, "
                "and run 'boresight generate'"
            )
    return manifest


def sources(folder: Path, files: Iterable[str]) -> list[Path]:
    """Of a manifest's files what evidence depends on: C, headers, self-test; not what tells the version alone."""
    used = (name for name in sorted(files) if not name.endswith("_identity.h"))
    listed = [(place, name) for name in used for place in EVIDENT if name.startswith(place)]
    return [folder / name for _, name in sorted(listed, key=lambda one: EVIDENT.index(one[0]))]


def sources_hash(paths: Iterable[Path]) -> str:
    """Of names and contents, in the order given."""
    key = hashlib.sha256()
    for path in paths:
        key.update(path.name.encode() + b"\0" + path.read_bytes() + b"\0")
    return key.hexdigest()


def cache_folder() -> Path:
    """Where compiled libraries are kept: BORESIGHT_CACHE, or the user's cache folder."""
    given = os.environ.get("BORESIGHT_CACHE")
    return Path(given) if given else user_cache_path("boresight", appauthor=False)
