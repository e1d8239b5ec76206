# Made from the table in __init__.py by tests/test_front_door.py.
from boresight import mechanics as mechanics
from boresight import models as models
from boresight import simulation as simulation
from boresight.analysis import observability as observability
from boresight.analysis.consistency import Consistency as Consistency
from boresight.analysis.record import Record as Record
from boresight.codegen.export import export as export
from boresight.codegen.generate import generate as generate
from boresight.codegen.verify import verify as verify
from boresight.derive.constant import constant as constant
from boresight.derive.mechanics.earth import ENU as ENU
from boresight.derive.mechanics.earth import NED as NED
from boresight.derive.model import FirstOrder as FirstOrder
from boresight.derive.model import Function as Function
from boresight.derive.model import Measurement as Measurement
from boresight.derive.model import Mechanics as Mechanics
from boresight.derive.model import Model as Model
from boresight.derive.model import Output as Output
from boresight.derive.model import Struct as Struct
from boresight.derive.model import Variable as Variable
from boresight.derive.model import variable as variable
from boresight.derive.models import variables as variables
from boresight.derive.named import named as named
from boresight.errors import BoresightError as BoresightError
from boresight.runtime import detector as detector
from boresight.runtime import frames as frames
from boresight.runtime import rotation as rotation
from boresight.runtime import transfer as transfer
from boresight.runtime import units as units
from boresight.runtime.clock import Clock as Clock
from boresight.runtime.filter import CompiledFilter as CompiledFilter
from boresight.runtime.filter import Epoch as Epoch
from boresight.runtime.filter import Filter as Filter
from boresight.runtime.filter import Innovation as Innovation
from boresight.runtime.library import Library as Library
from boresight.runtime.library import load as load
from boresight.runtime.live import Live as Live
from boresight.runtime.recording import read as read
from boresight.runtime.runs import Experiment as Experiment
from boresight.runtime.runs import Goal as Goal
from boresight.runtime.runs import many as many
from boresight.runtime.transfer import Message as Message
from boresight.runtime.transfer import Rules as Rules
from boresight.runtime.transfer import Transfer as Transfer

__version__: str
PUBLIC: dict[str, str]
