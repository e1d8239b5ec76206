"""Every public name says what it takes, gives and refuses, when not to use it, and has an example that runs.

The sections are numpydoc's.  Their parameters are those of the signature, in its order.
"""

import doctest
import importlib
import inspect
import re

import pytest

import boresight

OPTIONS = doctest.ELLIPSIS | doctest.NORMALIZE_WHITESPACE
NAMES = sorted(name for name in boresight.PUBLIC if callable(getattr(boresight, name)))
MORE = {  # of the public modules
    "observability.along": "boresight.analysis.observability:along",
    **{f"noise.{name}": f"boresight.analysis.noise:{name}" for name in ("identify", "fitted", "datasheet")},
}
SECTION = re.compile(r"^(\w[\w ]*)\n-{3,}\n", re.MULTILINE)
ENTRY = re.compile(r"^(\*{0,2}\w+(?:, \*{0,2}\w+)*)(?: : .*)?$", re.MULTILINE)


def thing(name):
    if name in MORE:
        module, _, own = MORE[name].partition(":")
        return getattr(importlib.import_module(module), own)
    return getattr(boresight, name)


def sections(text):
    """Name -> body; what stands before the first is ""."""
    parts = SECTION.split(inspect.cleandoc(text))
    return {"": parts[0], **dict(zip(parts[1::2], parts[2::2], strict=True))}


def listed(body):
    """The names of a section of parameters: lines that are not indented."""
    return [one.lstrip("*") for entry in ENTRY.findall(body) for one in entry.split(", ")]


def parameters(value):
    found = inspect.signature(value).parameters.values()
    return [one.name for one in found if one.name != "self"]


def methods(value):
    """Public methods that a class defines, or overrides."""
    if not inspect.isclass(value):
        return []
    own = [name for base in value.__mro__[:-1] if base.__module__.startswith("boresight") for name in vars(base)]
    named = [name for name in dict.fromkeys(own) if not name.startswith("_")]
    return [name for name in named if inspect.isfunction(inspect.getattr_static(value, name))]


ALL = [*NAMES, *MORE]
IN_TURN = ["generate", "verify", "export"]  # of one model, which is generated once
METHODS = [(name, method) for name in NAMES for method in methods(getattr(boresight, name))]
ERROR = "BoresightError"


@pytest.mark.parametrize("name", ALL)
def test_a_public_name_has_every_section(name):
    value = thing(name)
    found = sections(value.__doc__ or "")
    assert len(found[""].splitlines()[0]) <= 96 and found[""].splitlines()[0].endswith(".")
    assert "Examples" in found and ">>> " in found["Examples"]
    if name == ERROR:
        return
    assert listed(found["Parameters"]) == parameters(value)
    assert "hen not to use it" in found["Notes"]
    if name not in ("Innovation", "Message", "Mechanics"):  # which refuse nothing by themselves
        assert "BoresightError\n" in found["Raises"]


@pytest.mark.parametrize(("name", "method"), METHODS)
def test_a_public_method_lists_its_parameters(name, method):
    value = getattr(getattr(boresight, name), method)
    text = inspect.getdoc(value)
    assert text, f"{name}.{method} has no docstring"
    found, taken = sections(text), parameters(value)
    assert listed(found.get("Parameters", "")) == taken
    if inspect.signature(value).return_annotation not in (None, "None", inspect.Signature.empty):
        assert {"Returns", "Yields"} & set(found), f"{name}.{method}: no Returns"


@pytest.mark.parametrize("names", [*([name] for name in ALL if name not in IN_TURN), IN_TURN], ids=" ".join)
def test_the_example_runs(names, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    known = {"__name__": "__main__"}
    for name in names:
        test = doctest.DocTestParser().get_doctest(inspect.getdoc(thing(name)), known, name, None, 0)
        printed = []
        done = doctest.DocTestRunner(optionflags=OPTIONS).run(test, out=printed.append, clear_globs=False)
        assert done.attempted and not done.failed, "".join(printed)
        known = test.globs


def test_a_missing_parameter_and_a_wrong_example_are_seen():
    def wrong(a, b):
        """Add.

        Parameters
        ----------
        a : int
            The first, with
            more lines.

        Examples
        --------
        >>> 1 + 1
        3
        """

    assert listed(sections(wrong.__doc__)["Parameters"]) == ["a"] != parameters(wrong)
    test = doctest.DocTestParser().get_doctest(inspect.getdoc(wrong), {}, "wrong", None, 0)
    assert doctest.DocTestRunner(optionflags=OPTIONS).run(test, out=lambda text: None).failed == 1
