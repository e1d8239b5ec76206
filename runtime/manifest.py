"""What `boresight generate` leaves in a model's folder, read without NumPy: names, files and their hashes."""

import hashlib
import json
import os
import tempfile
from collections.abc import Iterable
from pathlib import Path
from typing import Any

from platformdirs import user_cache_path

from boresight.errors import BoresightError, did_you_mean

GENERATED = Path(__file__).parent.parent / "generated"  # in the checkout
ARCHIVE = GENERATED.with_name("generated.json.xz")  # in a wheel: the text of each of its files by path
EVIDENT = ("src/", "include/", "selftest/")


def generated() -> Path:
    """Where the folders of the built-in models lie: in the checkout, or unpacked from the wheel into the cache."""
    return GENERATED if GENERATED.is_dir() else unpacked(ARCHIVE)


def unpacked(archive: Path) -> Path:
    """The folder of the cache that holds the archive's files, which are written once.

    Raises BoresightError where the archive cannot be read or the cache cannot be written to.
    """
    try:
        import lzma

        content = archive.read_bytes()
        place = cache_folder() / f"generated-{hashlib.sha256(content).hexdigest()[:16]}"
        if place.is_dir():
            return place
        place.parent.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(dir=place.parent, prefix=".writing-") as aside:
            for name, text in json.loads(lzma.decompress(content)).items():
                path = Path(aside) / "new" / name
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(text, encoding="utf-8")
            try:
                os.replace(Path(aside) / "new", place)
            except OSError:
                if not place.is_dir():  # else another process was first
                    raise
    except ModuleNotFoundError:
        raise BoresightError("this Python was built without lzma, which reads the built-in models' C") from None
    except OSError as error:
        raise BoresightError(
            f"cannot unpack {archive.name} into {cache_folder()} ({error.strerror}); set BORESIGHT_CACHE to a folder "
            "that can be written to"
        ) from None
    return place


def built_in() -> list[str]:
    """Names of the models that are generated with the package."""
    return sorted(
        path.parent.name.replace("_", "-") for path in generated().glob("*/manifest.json") if not is_component(path)
    )


def is_component(manifest: Path) -> bool:
    """Whether the folder holds C that comes from no model, as the detectors; its binding is its own."""
    try:
        return "component" in json.loads(manifest.read_text())
    except (OSError, ValueError):
        return False  # what cannot be read is reported by who reads it


def folder_of(model: str | Path) -> Path:
    """The generated folder of a built-in model's name, or the folder given."""
    if isinstance(model, str) and (generated() / model.replace("-", "_") / "manifest.json").is_file():
        return generated() / model.replace("-", "_")
    if (Path(model) / "manifest.json").is_file():
        return Path(model)
    raise BoresightError(
        f"no generated model {str(model)!r}{did_you_mean(str(model), built_in())}; built in are "
        f"{', '.join(built_in())}; for your own, give the folder that 'boresight generate FILE.py:NAME' wrote"
    )


def read_manifest(folder: Path) -> dict[str, Any]:
    """The folder's manifest, once every file it lists is found unchanged."""
    unpacked_here = folder.parent.name.startswith("generated-")
    remedy = f"delete {folder.parent}, which is unpacked again" if unpacked_here else "run 'boresight generate'"
    try:
        manifest = json.loads((folder / "manifest.json").read_text())
        files = manifest["files"]
    except (ValueError, KeyError, OSError) as error:
        raise BoresightError(f"{folder}/manifest.json cannot be read ({error}); {remedy}") from None
    for path, digest in files.items():
        try:
            content = (folder / path).read_bytes()
        except OSError:
            raise BoresightError(f"{folder / path} is missing; {remedy}") from None
        if hashlib.sha256(content).hexdigest() != digest:
            raise BoresightError(
                f"{folder / path} was edited since it was generated; change the model instead, delete the file, "
                f"and {remedy}"
            )
    return manifest


def sources(folder: Path, files: Iterable[str]) -> list[Path]:
    """Of a manifest's files what evidence depends on: C, headers, self-test; not what tells the version alone."""
    used = (name for name in sorted(files) if not name.endswith("_identity.h"))
    listed = [(place, name) for name in used for place in EVIDENT if name.startswith(place)]
    return [folder / name for _, name in sorted(listed, key=lambda one: EVIDENT.index(one[0]))]


def cache_folder() -> Path:
    """Where compiled libraries are kept: BORESIGHT_CACHE, or the user's cache folder."""
    given = os.environ.get("BORESIGHT_CACHE")
    return Path(given) if given else user_cache_path("boresight", appauthor=False)
