"""Contact dynamics and its derivatives in any reference frame, and optimal control on top.

Values (specifications, results) are dataclasses; what computes is a class. SI units, linear parts
first, quaternions x y z w, placements as 4 x 4 arrays."""

from . import campaign, dataset, plot, polishing, press_hold, push_wall, residual, stand
from ._core import __version__ as __version__
from .base import *
from .contact import *
from .derivatives import *
from .dynamics import *
from .estimate import *
from .files import *
from .identification import *
from .model import *
from .mpc import *
from .ocp import *
from .pressing import *
from .report import *
from .sim import *
from .solver import *
