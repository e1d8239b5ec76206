"""What a recording's TOML file may say.  Imported only by `recording.read`: it needs pydantic."""

import tomllib
from datetime import datetime
from pathlib import Path
from typing import Any, Literal, get_args

from pydantic import BaseModel, ConfigDict, Field, ValidationError

from boresight.errors import BoresightError, did_you_mean


class Part(BaseModel):
    model_config = ConfigDict(extra="forbid", frozen=True)


class Column(Part):
    """One quantity: a 2-D array by name, or one column for each component.

    time: where it has tags of its own, their column, in the unit of its section's time.
    """

    columns: str | list[str]
    unit: str
    time: str | None = None


class Attitude(Column):
    order: str = "roll pitch yaw"
    yaw_positive: Literal["clockwise", "counter-clockwise"] = "clockwise"
    # Of angles; must be given where the axes of [master] would say otherwise than "north" and "up".
    yaw_from: Literal["north", "east"] | None = None
    pitch_positive: Literal["up", "down"] | None = None


class Velocity(Column):
    """axes: of [master] navigation, or of [master] body; order: of the columns, where it is another one."""

    axes: Literal["navigation", "body"] = "navigation"
    order: str | None = None


class Position(Column):
    """Latitude, longitude and height in this order, or in `order`; `unit` is that of the angles.

    Where `unit` is one of length: metres in the axes of [master] navigation from [master] origin.
    """

    height_unit: str = "m"
    order: str | None = None


class Step(Part):
    """A clock that was set: what to take off all tags that follow a tag, as `--check` shows it."""

    after: float | str
    by: float | str


class Time(Column):
    """wraps: the time after which a counter begins at 0 again; shift: what is added to every tag."""

    wraps: float | str | None = None
    steps: list[Step] = []
    shift: float | str = 0.0


class Origin(Part):
    """Where local metres begin: deg and m, or a column whose first number it is."""

    latitude: float | str
    longitude: float | str = 0.0
    height: float | str = 0.0


class Source(Part):
    """Where a section's columns are, if not in the description's `file`."""

    file: str | None = None


class Timed(Source):
    """Where rows stand in time: by tags, or by a rate from `start` on; and rows that are none of the sensor's."""

    time: Time | None = None
    rate: float | str | None = None
    start: float | str = 0.0
    clock: Literal["as tagged", "regular"] = "as tagged"
    repeats: Literal["keep", "drop"] = "keep"
    interpolated_from: float | str | None = None


class ImuPart(Timed):
    kind: Literal["rates", "increments"]
    time_marks: Literal["start", "middle", "end", "point"]
    body: str
    interval: Column | None = None  # of increments: what each of them covers, where tags are further apart
    gyro: Column
    accel: Column
    temperature: Column | None = None


class MasterPart(Timed):
    body: str
    navigation: str
    attitude: Attitude
    velocity: Velocity | None = None
    position: Position | None = None
    origin: Origin | None = None


class Known(Part):
    """Numbers in the slave's body axes as [imu] names them: an array of the file, or written here."""

    columns: str | None = None
    values: list[float] | list[list[float]] | None = None
    unit: str


class CalibrationPart(Source):
    """What is taken off every sample when it is read: true = matrix @ ((delivered - bias) / (1 + scale))."""

    gyro_bias: Known | None = None
    accel_bias: Known | None = None
    gyro_scale: Known | None = None
    accel_scale: Known | None = None
    gyro_matrix: Known | None = None
    accel_matrix: Known | None = None


class ReferencePart(Source):
    """What is known of the slave from elsewhere, to be held against what a filter estimates."""

    gyro_bias: Known | None = None
    accel_bias: Known | None = None
    misalignment: Known | None = None
    lever_arm: Known | None = None


class StopsPart(Part):
    """Of a slave without a master, for detection and zero-velocity updates.

    rest: from when to when it is known to stand still.  window: of the detectors.  sway: factor on the threshold, for
    updates, since a loaded foot is never as quiet as a floor.  latitude: deg, where no file has it.
    """

    rest: list[float | str] | None = None
    window: float | str | None = None
    sway: float | None = None
    latitude: float | None = None


class NoisePart(Part):
    """What is known of the noises, each with its unit; the same as options of `boresight replay`."""

    gyro: str | None = None
    accel: str | None = None
    velocity: str | None = None
    attitude: str | None = None
    delay: str | None = None
    gyro_instability: str | None = None
    accel_instability: str | None = None
    correlation: str | None = None


class Description(Part):
    title: str = ""
    recognised_by: list[str] = []  # all arrays of a file that this description serves without being named
    serves: list[str] = []  # endings of logs that it serves wherever they have its topics
    file: str | None = None
    delimiter: str = ","
    decimal: Literal[".", ","] = "."
    header: bool | int = True  # or how many lines it has
    bad_rows: Literal["refuse", "drop"] = "refuse"
    begin: float | datetime | str | None = Field(None, alias="from")
    end: float | datetime | str | None = Field(None, alias="to")
    bridge: float | str = 0.0
    allow: list[str] = []
    imu: ImuPart
    master: MasterPart | None = None
    calibration: CalibrationPart | None = None
    reference: ReferencePart | None = None
    noise: NoisePart | None = None
    stops: StopsPart | None = None


def load(path: Path) -> Description:
    """The description in a TOML file; raises BoresightError naming the file and the key."""
    try:
        return Description.model_validate(tomllib.loads(path.read_text(encoding="utf-8")))
    except UnicodeDecodeError:
        raise BoresightError(f"{path}: not TOML: it is not text in UTF-8; save it as UTF-8") from None
    except tomllib.TOMLDecodeError as error:
        raise BoresightError(f"{path}: not TOML: {error}; compare with 'boresight replay --template'") from None
    except OSError as error:
        raise BoresightError(f"{path}: cannot be read: {error.strerror}") from None
    except ValidationError as error:
        # A key that is not known is the cause of one that is missing.
        first = min(error.errors(), key=lambda one: one["type"] != "extra_forbidden")
        parts = [str(part) for part in first["loc"] if isinstance(part, int) or not part.startswith(KINDS)]
        key = ".".join(parts)
        what = {"missing": "is missing", "extra_forbidden": "is not a key that a description has"}
        says = what.get(first["type"], f"is {first['input']!r}: {first['msg'].lower()}")
        if first["type"] == "extra_forbidden":
            says += did_you_mean(parts[-1], known := keys(parts[:-1])) + f"; there are {', '.join(known)}"
        raise BoresightError(f"{path}: {key} {says}; compare with 'boresight replay --template'") from None


KINDS = ("str", "float", "list[", "datetime")  # what pydantic adds to a place where several types may stand


def keys(place: list[str]) -> list[str]:
    """What may stand at a place of a description, as ["imu", "gyro"]."""
    part: Any = Description
    for name in place:
        if name.isdigit():  # of a list
            continue
        kind = part.model_fields[name].annotation
        part = next((one for one in get_args(kind) if one is not type(None)), kind)
    return [field.alias or name for name, field in part.model_fields.items()]


def shared(described: Description) -> str:
    """What is wrong where a column is named for two quantities, or twice for one; "" where nothing is."""
    taken: dict[tuple[str | None, str], str] = {}
    for section, part in (("imu", described.imu), ("master", described.master)):
        for name, quantity in part or ():
            if not isinstance(quantity, Column):
                continue
            what = f"{section}.{name}"
            for column in [quantity.columns] if isinstance(quantity.columns, str) else quantity.columns:
                before = taken.setdefault(((part and part.file) or described.file, column), "")
                if before == what:
                    return f"{what}: column {column!r} is named twice; name one for each component"
                if before and not (before.endswith(".time") and name == "time"):  # one clock may serve both
                    return f"column {column!r} is named for {before} and {what}; each has columns of its own"
                taken[(part and part.file) or described.file, column] = what
    return ""


def named(part: Any) -> list[str]:
    """Every column that a description or a part of it names."""
    out: list[str] = []
    if isinstance(part, Column | Known):
        names = part.columns or []
        out += [names] if isinstance(names, str) else names
    if isinstance(part, Column) and part.time:
        out.append(part.time)
    if isinstance(part, Origin):
        out += [value for _, value in part if isinstance(value, str)]
    for _, inner in part:
        if isinstance(inner, Part):
            out += named(inner)
    return out
