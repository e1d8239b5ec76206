"""Programs built from generated C, as an engineer builds them; and generated C that is spoilt."""

import hashlib
import json
import subprocess

from boresight.evidence.targets import WARNINGS
from boresight.runtime import compiler
from boresight.runtime.manifest import folder_of

STRICT = (*WARNINGS, "-O1")


def run(*command, cwd=None):
    """The process when it has ended; who asks judges its status."""
    return subprocess.run([str(word) for word in command], cwd=cwd, capture_output=True, text=True, check=False)


def c_files(folder, *names):
    return [path for name in names for path in sorted((folder / name).glob("*.c"))]


def program(out, sources, *flags, cc="cc"):
    """The sources, compiled below `out` and linked; raises BoresightError with the first error."""
    objects = compiler.compile_sources([cc, *flags], dict.fromkeys(sources, ()), out)
    compiler.run([cc, *flags, *objects.values(), "-lm", "-o", out / "program"])
    return out / "program"


def spoil(folder, path, old, new):
    """Edit a generated file and sign the edit in the manifest, as if the generator had made it."""
    text = (folder / path).read_text()
    assert old in text, f"{old} is not in {path}"
    (folder / path).write_text(text.replace(old, new))
    manifest = json.loads((folder / "manifest.json").read_text())
    manifest["files"][path] = hashlib.sha256((folder / path).read_bytes()).hexdigest()
    (folder / "manifest.json").write_text(json.dumps(manifest))


def exported_c(model, out, precision="double", places=()):
    """The folder `out`: a committed one as `export` writes it, who first makes it again to see that it is up to date;
    that it does so is tested once."""
    from boresight.codegen.export import exported

    exported(folder_of(model), out, precision, model, places)
    return out


def self_test(folder, out, *flags, cc="cc"):
    """The folder's self-test, built with its batch forms and run; who asks judges its status."""
    return run(program(out, c_files(folder, "src", "selftest", "batch"), *flags, "-I", folder / "include", cc=cc))


def passed(folder):
    """The last line of a self-test that passes: every source has a test, but the one that says what the folder is; and
    so has the probe."""
    units = [path for path in c_files(folder, "src") if not path.stem.endswith("_identity")]
    return f"{len(units) + 1} passed, 0 failed"
