"""Wedges as they look: both halves of the plane through the axis."""

import numpy as np

from cosserat.case import Case

#: Fields about the normal of the plane, which is the other way round behind
#: the axis
ABOUT_NORMAL = ("omega",)


class Mirrored(Case):
    """A case on a wedge with its half mirrored at the axis: cells, points and
    fields twice, the mirrored ones behind."""

    def __init__(self, path):
        super().__init__(path)
        self._radial = self._direction()

    def _direction(self):
        """The coordinate away from the axis."""
        corners = next(faces[0] for kind, faces in
                       super().patch_faces().values() if kind == "wedge")
        ways = corners[1:] - corners[0]
        normal = np.abs(np.cross(ways[:-1], ways[1:]).sum(axis=0))
        return max(self.plane(), key=lambda i: normal[i])

    def _both(self, places):
        """Places (..., 3) and those behind the axis."""
        other = np.array(places, float)
        other[..., self._radial] *= -1
        return other

    def polygons(self):
        """Corners of each cell: list of arrays."""
        half = super().polygons()
        return half + [self._both(corners) for corners in half]

    def boundary_edges(self):
        """Edges of walls and openings."""
        half = super().boundary_edges()
        return half + [(self._both(a), self._both(b)) for a, b in half]

    def field(self, name, time=None):
        """Values by cell."""
        half = super().field(name, time)
        other = half.copy()
        if name in ABOUT_NORMAL:
            other *= -1
        elif half.ndim == 2 and half.shape[1] == 3:
            other = self._both(half)
        elif half.ndim == 2 and half.shape[1] == 9:
            sign = np.ones(3)
            sign[self._radial] = -1
            other = half*np.outer(sign, sign).ravel()
        return np.concatenate([half, other])

    def cloud(self, name, time=None, cloud="materialPoints"):
        """Field of a cloud, one row or number per point."""
        half = super().cloud(name, time, cloud)
        return np.concatenate([half, self._both(half) if name == "positions"
                               else half])


def opened(path, half=False):
    """A case; of a wedge both halves unless one is asked for."""
    case = Case(path)
    return Mirrored(path) if case.wedge() and not half else case
