"""What walls bear, from the fields of the function object wallLoad."""

import numpy as np


def along(case, patch, time, which, axis):
    """Place along an axis and normal traction, positive against the wall, of
    those faces of a patch whose centres (x, y), rounded, are chosen; in the
    order of the places."""
    centres = case.patch_centres(patch).round(9)
    normals = case.patch_normals(patch)
    traction = (case.patch_field("wallTraction", patch, time)*normals).sum(
        axis=1)
    chosen = np.flatnonzero(which(centres[:, 0], centres[:, 1]))
    chosen = chosen[np.argsort(centres[chosen, axis])]
    return centres[chosen, axis], traction[chosen]
