"""Bodies in square cells: their parts of cells, and regions of points.

A fraction is a function (x, y) of the centres of cells; a region is the text
of an entry of `regions`, of material points of the material `first`.
"""

import numpy as np


def below(n, d, normal):
    """Fraction of the half plane: of a cell, of n a unit length, where
    normal . (x, y) < d; normal is a unit vector. The distance from the centre
    of points of a square is a sum of two uniform numbers, whose distribution
    this is."""
    b, a = sorted(abs(c)/(2*n) for c in normal)

    def fraction(x, y):
        t = d - normal[0]*x - normal[1]*y
        if b < 1e-6*a:
            part = (t/a + 1)/2
        else:
            part = sum(sign*np.maximum(t + shift, 0)**2
                       for sign, shift in ((1, a + b), (-1, a - b),
                                           (-1, b - a), (1, -a - b)))/(8*a*b)
        part = np.where(np.abs(t) < (a + b)*(1 - 1e-9), part, t > 0)
        return np.clip(part, 0, 1)
    return fraction


def within(n, lower, upper):
    """Function of one coordinate: part of a cell's width between two lines.
    What the digits of the coordinates leave of a face is none."""
    def part(x):
        width = (np.minimum(x + 0.5/n, upper) - np.maximum(x - 0.5/n, lower))
        part = np.clip(n*width, 0, 1)
        return np.where(np.abs(part - np.rint(part)) < 1e-8, np.rint(part),
                        part)
    return part


def rectangle(n, lower, upper):
    """Fraction of a rectangle between two corners."""
    parts = [within(n, a, b) for a, b in zip(lower, upper)]
    return lambda x, y: parts[0](x)*parts[1](y)


def disc(n, centre, radius):
    """Fraction of a disc, by 32 x 32 samples of each cell."""
    s = (np.arange(32) + 0.5)/32 - 0.5
    X, Y = (shift.ravel()/n for shift in np.meshgrid(s, s))

    def fraction(x, y):
        inside = sum(np.hypot(x + a - centre[0], y + b - centre[1]) < radius
                     for a, b in zip(X, Y))
        return inside/len(X)
    return fraction


def polygon(corners):
    """Region of a polygon."""
    return "{ type polygon; material first; points (%s); }" % " ".join(
        f"({float(x)!r} {float(y)!r} 0)" for x, y in corners)


def box(lower, upper):
    """Region of a rectangle between two corners."""
    return ("{ type box; material first; min (%r %r -1); max (%r %r 1); }"
            % (*lower, *upper))


def circle(centre, radius, corners=256):
    """Region of a disc: a polygon of its area."""
    angle = (np.arange(corners) + 0.5)*2*np.pi/corners
    r = radius*np.sqrt(2*np.pi/corners/np.sin(2*np.pi/corners))
    return polygon(zip(centre[0] + r*np.cos(angle),
                       centre[1] + r*np.sin(angle)))
