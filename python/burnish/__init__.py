"""Contact dynamics and its derivatives in any reference frame, optimal control, and MPC.

Specifications and results are dataclasses. Functions and classes that compute are compiled.
All values are in SI units. Spatial vectors have the linear part first. Quaternions are x, y, z, w.
Placements are 4 x 4 arrays."""

import sys as _sys

from . import _renamed, campaign, dataset, model, plot, polishing, residual
# scripts/describe inserts the named tasks here.
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

_renamed.refuse_old_names(_sys.modules[__name__], model, Model, polishing.RunResult)
