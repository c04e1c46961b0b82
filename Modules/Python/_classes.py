# SPDX-License-Identifier: BSD-3-Clause
"""Every wrapped class of the modules."""

# VTK's own modules first: the classes below derive from theirs.
import vtkmodules.vtkCommonDataModel
import vtkmodules.vtkCommonExecutionModel
import vtkmodules.vtkRenderingCore

from .ShadowConesSources import *
from .ShadowConesFilters import *
from .ShadowConesImaging import *
from .ShadowConesWords import *
from .ShadowConesPage import *
