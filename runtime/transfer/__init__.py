"""Transfer alignment in flight: a slave's increments in, a master's late and irregular messages in, corrections out.

`Transfer` flies the model `velocity-attitude`, or a composition of it.  It keeps the slave's last half second or so, so
that a message is held against the slave as it was when the master measured; what it does with a message that it cannot
use, and with a slave at full scale, are the rules of docs/transfer-alignment.md.  Nothing is printed: each message gets
a verdict, each change of verdict one line in `notes`.

Axes: `runs`, the leading axes of P, then components.  The slave's clock is one for all runs; the master's messages have
their own times, run by run.  Units SI and rad, NED and front-right-down.
"""

from boresight.runtime.transfer import sensors
from boresight.runtime.transfer.filter import Transfer
from boresight.runtime.transfer.headings import Headings
from boresight.runtime.transfer.lever import LeverSeen
from boresight.runtime.transfer.messages import Message, Note, Result, Verdict
from boresight.runtime.transfer.rules import Rules
from boresight.runtime.transfer.start import Increments, again, first

__all__ = [
    "Headings",
    "Increments",
    "LeverSeen",
    "Message",
    "Note",
    "Result",
    "Rules",
    "Transfer",
    "Verdict",
    "again",
    "first",
    "sensors",
]
