# SPDX-License-Identifier: GPL-3.0-or-later
"""Constrictions of triangle meshes: simple closed curves whose length is locally minimal.

>>> surface = constrictions.Surface(V, F)
>>> for c in surface.detect():
...     print(c.length, c.points)
"""

from ._constrictions import (
    Certificate,
    Constriction,
    Constrictions,
    GeodesicLoop,
    InvalidInput,
    PlaneSection,
    Segmentation,
    Split,
    Surface,
    TightenedCurve,
    __version__,
)

__all__ = [
    "Certificate",
    "Constriction",
    "Constrictions",
    "GeodesicLoop",
    "InvalidInput",
    "PlaneSection",
    "Segmentation",
    "Split",
    "Surface",
    "TightenedCurve",
    "__version__",
]

# So they are called where they are found.
for _name in __all__:
    if isinstance(globals()[_name], type):
        globals()[_name].__module__ = __name__
del _name
