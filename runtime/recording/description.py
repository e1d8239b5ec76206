"""What a recording's TOML file may say.  Imported only by `recording.read`: it needs pydantic."""

import tomllib
from pathlib import Path
from typing import Literal

from pydantic import BaseModel, ConfigDict, ValidationError

from boresight import BoresightError


class Part(BaseModel):
    model_config = ConfigDict(extra="forbid", frozen=True)


class Column(Part):
    """One quantity: a 2-D array by name, or one column for each component."""

    columns: str | list[str]
    unit: str


class Attitude(Column):
    order: str = "roll pitch yaw"
    yaw_positive: Literal["clockwise", "counter-clockwise"] = "clockwise"


class Position(Column):
    """Latitude, longitude and height in this order; `unit` is that of the angles."""

    height_unit: str = "m"


class Source(Part):
    """Where a section's columns are, if not in the description's `file`."""

    file: str | None = None


class ImuPart(Source):
    kind: Literal["rates", "increments"]
    time_marks: Literal["start", "middle", "end"]
    body: str
    time: Column
    gyro: Column
    accel: Column


class MasterPart(Source):
    body: str
    navigation: str
    time: Column
    attitude: Attitude
    velocity: Column | None = None
    position: Position | None = None


class ReferencePart(Source):
    """What is known of the slave from elsewhere, in the slave's body axes as [imu] names them."""

    gyro_bias: Column | None = None
    accel_bias: Column | None = None
    misalignment: Column | None = None
    lever_arm: Column | None = None


class Description(Part):
    title: str = ""
    recognised_by: list[str] = []  # all arrays of a file that this description serves without being named
    file: str | None = None
    delimiter: str = ","
    header: bool = True
    imu: ImuPart
    master: MasterPart | None = None
    reference: ReferencePart | None = None


def load(path: Path) -> Description:
    """The description in a TOML file; raises BoresightError naming the file and the key."""
    try:
        return Description.model_validate(tomllib.loads(path.read_text(encoding="utf-8")))
    except (tomllib.TOMLDecodeError, UnicodeDecodeError) as error:
        raise BoresightError(f"{path}: not TOML: {error}; compare with 'boresight replay --template'") from None
    except OSError as error:
        raise BoresightError(f"{path}: cannot be read: {error.strerror}") from None
    except ValidationError as error:
        first = error.errors()[0]
        key = ".".join(str(part) for part in first["loc"] if part not in ("str", "list[str]"))
        what = {"missing": "is missing", "extra_forbidden": "is not a key that a description has"}
        says = what.get(first["type"], f"is {first['input']!r}: {first['msg'].lower()}")
        raise BoresightError(f"{path}: {key} {says}; compare with 'boresight replay --template'") from None
