"""What a contributor reads and what guards his commits: files, commands and versions that are there."""

import re
import tomllib

import yaml
from conftest import ROOT

from boresight import __version__

PAGE = (ROOT / "CONTRIBUTING.md").read_text()


def test_the_page_is_short_and_names_ten_files_that_exist():
    assert len(PAGE.splitlines()) <= 200
    files = re.findall(r"^\| \d+ \| \[(.*?)\]\((.*?)\)", PAGE, re.MULTILINE)
    assert len(files) == 10 and all(name == link and (ROOT / link).is_file() for name, link in files)
    rooms = re.findall(r"^\| `(\w+/)`", PAGE, re.MULTILINE)
    assert len(rooms) == 9 and all((ROOT / room).is_dir() for room in rooms)
    for name in re.findall(r"`((?:derive|runtime|codegen|studies|evidence|tests|docs)/[\w/]+\.\w+)`", PAGE):
        assert (ROOT / name).is_file(), name


def test_the_arrows_of_the_page_are_those_of_the_test():
    from test_imports import ARROWS

    for room, arrows in ARROWS.items():
        (may,) = re.findall(rf"^\| `{room}/` \|.*\| (.*?) \|$", PAGE, re.MULTILINE)
        assert set(may.replace("nothing", "").replace(",", " ").split()) == arrows


def test_a_hook_runs_from_the_environment_and_needs_no_network():
    (repository,) = yaml.safe_load((ROOT / ".pre-commit-config.yaml").read_text())["repos"]
    assert repository["repo"] == "local"
    for hook in repository["hooks"]:
        assert hook["language"] == "system" and ".venv/bin/" in hook["entry"]
    (generate,) = (hook for hook in repository["hooks"] if hook["id"] == "generate")
    models = {path.name for path in (ROOT / "derive" / "models").glob("*.py")}
    edited = {name for name in models if re.search(generate["files"], f"derive/models/{name}")}
    assert models - edited == {"__init__.py", "variables.py"}


def test_the_version_to_cite_is_the_one_that_is_installed():
    cited = yaml.safe_load((ROOT / "CITATION.cff").read_text())
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
    assert cited["version"] == project["version"] == __version__ and cited["license"] == project["license"]
