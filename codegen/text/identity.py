"""What a folder says of itself: version, hash of its C, and the names of its functions in single precision."""

import hashlib
import re
from typing import Any

from boresight import __version__

# What tells a precision or a version, and computes nothing: an export in either precision has the same hash.
BESIDE = re.compile(r"include/(\w+_identity|boresight_precision)\.h")
STATUS = re.compile(r"^bs_status (\w+)\(", re.MULTILINE)
FORMS = (  # of the names that hang on precision and form: their ending, and when
    ("", "!defined(BORESIGHT_FLOAT) && !BORESIGHT_UD"),
    ("_ud", "!defined(BORESIGHT_FLOAT) && BORESIGHT_UD"),
    ("_f32", "defined(BORESIGHT_FLOAT) && BORESIGHT_UD"),
    ("_f32_joseph", "defined(BORESIGHT_FLOAT) && !BORESIGHT_UD"),
)
PLAIN = (("", "!defined(BORESIGHT_FLOAT)"), ("_f32", "defined(BORESIGHT_FLOAT)"))
PROTOTYPE = re.compile(r"^(?!typedef|static|extern)\w[\w *]*?\b(\w+)\(", re.MULTILINE)


def model_hash(files: dict[str, str]) -> str:
    """SHA-256 of what sha256sum prints of src/ and include/, files in the order of their names.

    files: path below the folder -> text.
    """
    lines = [
        f"{hashlib.sha256(files[path].encode()).hexdigest()}  {path}\n"
        for path in sorted(files)
        if path.startswith(("include/", "src/")) and not BESIDE.fullmatch(path)
    ]
    return hashlib.sha256("".join(lines).encode()).hexdigest()


def public_functions(files: dict[str, str], prefix: str) -> list[str]:
    """Names of the functions that the headers in include/ declare, sorted; a static one is no symbol of the linker."""
    headers = "\n".join(text for path, text in files.items() if path.startswith("include/"))
    return sorted({name for name in PROTOTYPE.findall(headers) if name.startswith(f"{prefix}_")})


def numbers(version: str = __version__) -> list[int]:
    """Major, minor and patch: "0.2.0.dev1" has 0, 2, 0."""
    found = [int(word) for word in re.findall(r"\d+", version)[:3]]
    return found + [0] * (3 - len(found))


def identity_view(
    files: dict[str, str], m: dict[str, Any], has_filter: bool, exported: str = "", form: str = ""
) -> dict[str, Any]:
    """What the headers of identity and precision ask for.

    files: all C of the folder.  m: `name`, `snake`, `prefix`.  exported, form: of an export, or nothing.
    """
    major, minor, patch = numbers()
    headers = "\n".join(text for path, text in files.items() if path.startswith("include/"))
    names = sorted({*public_functions(files, m["prefix"]), f"{m['prefix']}_identity"})
    return {
        "m": {key: m[key] for key in ("name", "snake", "prefix")},
        "filter": has_filter,
        "exported": exported,
        "form": form,
        "hash": model_hash(files),
        "version": f"{major}.{minor}.{patch}",
        "numbers": [major, minor, patch],
        "number": 10000 * major + 100 * minor + patch,
        "names": names,
        "timed": sorted({*STATUS.findall(headers)} & {*names}),
        "forms": FORMS if has_filter else PLAIN,
        "of_form": [name for name in names if name.startswith((f"{m['prefix']}_filter_", f"{m['prefix']}_live_"))],
    }
