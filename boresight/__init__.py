"""Boresight: from the equations of an inertial-navigation filter to C that can be flown.

State a model
    `Model`, `Variable`, `variable`, `constant`, `named`, `Struct`, `Measurement`, `FirstOrder`, `Function`,
    `Output`, `Mechanics`, the frames `NED` and `ENU`; ready parts in `mechanics`, `variables` and `models`.
Make C
    `generate`, `verify`, `export`.
Fly
    `load` gives a `Library`; `Filter`, `CompiledFilter` and `Epoch` fly it, and `update` returns an `Innovation`;
    `Consistency` and `observability` judge the flight; `budget` splits its errors by source; `Record` keeps each step
    of it, and `smooth` estimates it afterwards; `noise` is what a log at rest, or a datasheet, has of it.
Align in flight
    `Driver` takes what comes from a wire into a `Live` loop; `Headings`, `Clock`; in `transfer` a start from the
    first `Message`, and sensors that are not ideal.
Recordings
    `read`; `detector` finds where an IMU is at rest.
Many runs
    `many`, `Experiment`, `Goal`.
Arrays
    `rotation`, `frames`, `units`, and the simulators of `simulation`.
Errors
    `BoresightError`: one line, what is wrong, where, and what to do.

These names are the public interface, each imported as `from boresight import NAME`; a change of one stands in the
changelog.  Everything else, the modules that they come from included, may change without notice.

The conventions; every generated artefact prints them, docs/conventions.md explains them.

- Error = computed - true.  ``C_hat = (I - [e x]) C``: the small rotation ``e`` is what must be applied to remove it.
- ``C_b2n`` takes body components to navigation components: ``v_n = C_b2n @ v_b``.  NED with front-right-down,
  or ENU with right-front-up; never mixed.  A rate names all its frames: ``omega_ie_n``.
- SI and radians inside and in C.  Where another unit enters or leaves, it is in the name: ``gyro_bias_deg_h``.
- Quaternions are Hamilton, scalar first, body to navigation: ``q_b2n_wxyz``.
- A master's data is old by ``tau > 0``; a lever arm runs from master to slave in slave body axes.
- Matrices are row-major.
"""

import sys

from boresight.errors import BoresightError as BoresightError

__version__ = "0.1.0"

# Each public name: the module that it is, or the module that has it and its name there.  `__init__.pyi` repeats it.
PUBLIC = {
    "Model": "boresight.derive.model:Model",
    "Variable": "boresight.derive.model:Variable",
    "variable": "boresight.derive.model:variable",
    "constant": "boresight.derive.constant:constant",
    "named": "boresight.derive.named:named",
    "Struct": "boresight.derive.model:Struct",
    "Measurement": "boresight.derive.model:Measurement",
    "Function": "boresight.derive.model:Function",
    "Output": "boresight.derive.model:Output",
    "FirstOrder": "boresight.derive.model:FirstOrder",
    "Mechanics": "boresight.derive.model:Mechanics",
    "NED": "boresight.derive.mechanics.earth:NED",
    "ENU": "boresight.derive.mechanics.earth:ENU",
    "mechanics": "boresight.mechanics",
    "variables": "boresight.derive.models.variables",
    "models": "boresight.models",
    "generate": "boresight.codegen.generate:generate",
    "verify": "boresight.codegen.verify:verify",
    "export": "boresight.codegen.export:export",
    "load": "boresight.runtime.library:load",
    "Library": "boresight.runtime.library:Library",
    "Filter": "boresight.runtime.filter:Filter",
    "CompiledFilter": "boresight.runtime.filter:CompiledFilter",
    "Epoch": "boresight.runtime.filter:Epoch",
    "Innovation": "boresight.runtime.filter:Innovation",
    "Consistency": "boresight.analysis.consistency:Consistency",
    "observability": "boresight.analysis.observability",
    "Record": "boresight.analysis.record:Record",
    "smooth": "boresight.analysis.smoother:smooth",
    "budget": "boresight.analysis.budget:budget",
    "noise": "boresight.analysis.noise",
    "Message": "boresight.runtime.transfer:Message",
    "Live": "boresight.runtime.live:Live",
    "Driver": "boresight.runtime.driver:Driver",
    "Headings": "boresight.runtime.headings:Headings",
    "Clock": "boresight.runtime.clock:Clock",
    "transfer": "boresight.runtime.transfer",
    "read": "boresight.runtime.recording:read",
    "detector": "boresight.runtime.detector",
    "many": "boresight.runtime.runs:many",
    "Experiment": "boresight.runtime.runs:Experiment",
    "Goal": "boresight.runtime.runs:Goal",
    "rotation": "boresight.runtime.rotation",
    "frames": "boresight.runtime.frames",
    "units": "boresight.runtime.units",
    "simulation": "boresight.simulation",
    "BoresightError": "boresight.errors:BoresightError",
}
__all__ = list(PUBLIC)


def __getattr__(name: str) -> object:
    """A public name, imported when it is first asked for: `import boresight` loads neither NumPy nor SymPy."""
    if name not in PUBLIC:
        raise AttributeError(f"module 'boresight' has no attribute {name!r}", name=name, obj=__import__(__name__))
    from pkgutil import resolve_name

    value = globals()[name] = resolve_name(PUBLIC[name])
    return value


def __dir__() -> list[str]:
    return list(PUBLIC)


if "IPython" in sys.modules:
    from boresight.notebook import register

    register()
