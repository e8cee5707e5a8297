"""Stiff and soft bodies by finite elements: the scenes `disc` and `block` of
cosserat.scenes.jumps, whose cells follow the body's edge.

    python3 -m cosserat.finiteElements.jumps [NAME ...]

prints every number of cosserat.references.JUMPS, on two meshes. The box is
that of the scenes, |x| < 1/2 and |y| < 1/2, all its walls of free slip,
viscosity 1 around the body, whose weight is 1 N/m3.
"""

import sys
from time import process_time

import numpy as np

from cosserat.finiteElements.flow import Flow
from cosserat.finiteElements.mesh import Mesh, graded_lines
from cosserat.finiteElements.tutorials import CENTRE, RADIUS, at, disc_flow, slip

#: Half the side of the block [m], and the internal length of Cosserat media
HALF, R = 1/8, 0.05


def block_flow(degree, contrast, cosserat=False, size=1/16, smallest=1e-12):
    """Flow around the square |x|, |y| < HALF; cosserat: etaC = eta, R in both
    media."""
    x = graded_lines([-0.5, -HALF, HALF, 0.5], size, [-HALF, HALF],
                     size/8, 0.5)
    mesh = Mesh.tensor(x, x)
    mesh.grade([(a, b) for a in (-HALF, HALF) for b in (-HALF, HALF)],
               smallest)

    def inside(value, other):
        return lambda x, y: np.where(
            (np.abs(x) < HALF) & (np.abs(y) < HALF), value, other)

    def modulus(factor):
        return inside(factor*contrast, factor) if factor else 0.0

    return Flow(
        mesh, degree, modulus(1.0), modulus(float(cosserat)),
        modulus(2*R**2*cosserat), force=(0.0, inside(-1.0, 0.0)),
        walls=[slip(at(x=-0.5), at(x=0.5), at(y=-0.5), at(y=0.5))])


def block(fine, contrast, cosserat=False):
    """Mean velocity along y [m/s] of the block, its largest difference in the
    block over the mean, and difference [Pa] of the pressure at y = 0.04 and
    -0.04 on the axis."""
    flow = block_flow(4 if fine else 3, contrast, cosserat)
    p = [flow.at(1e-9, y)[3] for y in (0.04, -0.04)]
    u = -flow.power()/(2*HALF)**2
    v = flow.u[(np.abs(flow.xy) < HALF + 1e-9).all(axis=1), 1]
    return {"u": u, "spread": np.ptp(v)/abs(u), "pressure": p[0] - p[1]}


def disc(fine, contrast, cosserat=False):
    """Mean velocity along y [m/s] of the disc, that in its middle and, of a
    Cosserat medium, the microrotation there."""
    flow = disc_flow(fine, *((eta, eta*cosserat, R)
                             for eta in (1.0, contrast)))
    _, v, omega, _ = flow.at(*CENTRE)
    values = {"u": -flow.power()/(np.pi*RADIUS**2), "uCentre": v}
    return {**values, "omega": omega} if cosserat else values


#: Name: function, Cosserat, contrasts
SCENES = {
    "block": (block, False, (1e-4, 1e-2, 1e2, 1e3, 1e6)),
    "block, Cosserat": (block, True, (1e3, 1e6)),
    "disc": (disc, False, (0.01, 0.1, 10.0, 1e3, 1e6)),
    "disc, Cosserat": (disc, True, (0.01, 0.1, 10.0, 1e3, 1e6)),
}


def main(names):
    """Print the numbers, and how far the two meshes differ."""
    for name in names or SCENES:
        scene, cosserat, contrasts = SCENES[name]
        for contrast in contrasts:
            start = process_time()
            coarse, fine = (scene(fine, contrast, cosserat)
                            for fine in (False, True))
            for quantity, value in fine.items():
                print(f'("{name}", {contrast:g}, "{quantity}", {value:.8g},'
                      f" {abs(coarse[quantity] - value):.1g}),"
                      f"  # {process_time() - start:.1f} s", flush=True)


if __name__ == "__main__":
    main(sys.argv[1:])
