"""C that is loops rather than instruction lists: templates, rendered into a folder laid out like a model's."""

import hashlib
import importlib
import json
from typing import Any

KERNELS = ("stationary-detector",)


def make_kernel(name: str, versions: dict[str, str]) -> tuple[dict[str, str], dict[str, int], dict[str, str]]:
    """All files of the kernel, and of each of its sources the number of lines and the hash."""
    from boresight.codegen.emit import snake, templates

    stem = snake(name)
    described: dict[str, Any] = importlib.import_module(f"boresight.codegen.kernels.{stem}").description()
    units = [{"file": stem, "c_name": stem}]
    m = described | {"name": name, "snake": stem, "units": units, "parts": []}
    names = {
        "include/boresight.h": "boresight.h.j2",
        f"include/{stem}.h": f"{stem}.h.j2",
        f"src/{stem}.c": f"{stem}.c.j2",
        f"batch/{m['prefix']}_batch.c": f"{stem}_batch.c.j2",
        "selftest/selftest.h": "selftest.h.j2",
        "selftest/selftest.c": "selftest.c.j2",
        f"selftest/test_{stem}.c": f"test_{stem}.c.j2",
        "CMakeLists.txt": "CMakeLists.txt.j2",
    }
    files = {path: templates().get_template(template).render(m=m, f=None) for path, template in names.items()}
    source = files[f"src/{stem}.c"]
    lines, digest = len(source.splitlines()), hashlib.sha256(source.encode()).hexdigest()
    document = {
        "model": name,  # what a folder is called, whether a model or a kernel
        "kernel": described["manifest"],
        "title": described["title"],
        "c_prefix": described["prefix"],
        "units": {stem: {"c_name": stem, "file": stem, "lines": lines, "hash": digest}},
        "files": {path: hashlib.sha256(text.encode()).hexdigest() for path, text in files.items()},
        "versions": versions,
    }
    files["manifest.json"] = json.dumps(document, indent=1, sort_keys=True) + "\n"
    return files, {stem: lines}, {stem: digest}
