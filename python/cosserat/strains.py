"""True errors of the strains of a case, cell by cell, in the energy of the
flow: what the function object errorIndicator estimates."""

import numpy as np

#: For a case: what its controlDict needs for errors() after the run
FUNCTIONS = """
functions
{
    error
    {
        type            errorIndicator;
        libs            (cosseratFunctionObjects);
        executeControl  writeTime;
        writeControl    writeTime;
        gradients       yes;
    }
    viscosities
    {
        type            writeObjects;
        libs            (utilityFunctionObjects);
        writeControl    writeTime;
        objects         (eta etaC M);
    }
}
"""


def switch_on(case):
    """Add the function objects to a case; its controlDict merges dictionaries
    of the same name."""
    with (case.path/"system/controlDict").open("a") as text:
        text.write(FUNCTIONS)


def strains(gradient, omega, curvature):
    """Rows xx - yy, xy, relative rotation and grad omega; gradient[j][i] is
    d_j u_i, curvature[j] is d_j omega."""
    (xx, xy), (yx, yy) = gradient
    return np.array([xx - yy, (xy + yx)/2, omega - (xy - yx)/2, *curvature])


def quadrature(polygons):
    """Points, weights and cells by which polynomials of second order are
    integrated over polygons: three points in each triangle that an edge and
    the mean of the corners make."""
    points, weights, cells = [], [], []
    for cell, corners in enumerate(polygons):
        middle = corners.mean(axis=0)
        for a, b in zip(corners, np.roll(corners, -1, axis=0)):
            (ax, ay), (bx, by) = a - middle, b - middle
            total = a + b + middle
            points += [total/6 + end/2 for end in (a, b, middle)]
            weights += [abs(ax*by - ay*bx)/6]*3
            cells += [cell]*3
    return np.array(points), np.array(weights), np.array(cells)


def differences(fields, step):
    """Function (x, y) -> values of the fields u, v, omega and their gradients
    [j, i], by central differences, of a function (x, y) -> (u, v, omega)."""
    def at(x, y):
        ways = [(step, 0), (0, step)]
        return np.array(fields(x, y)), np.array([
            (np.array(fields(x + dx, y + dy))
             - np.array(fields(x - dx, y - dy)))/(2*step) for dx, dy in ways])
    return at


def errors(case, exact):
    """Power of the error of the strains in each cell [W] at the last time of
    a case with FUNCTIONS, by the viscosities of the cell; exact: like
    differences()."""
    eta, etaC, M = (case.field(name) for name in ("eta", "etaC", "M"))
    grad, curvature = case.field("gradU"), case.field("gradOmega")
    own = strains(((grad[:, 0], grad[:, 1]), (grad[:, 3], grad[:, 4])),
                  case.field("omega"), curvature[:, :2].T)

    points, weights, cells = quadrature(
        [np.asarray(corners)[:, :2] for corners in case.polygons()])
    values, gradients = exact(*points.T)
    true = strains(gradients[:, :2], values[2], gradients[:, 2])

    free = (etaC > 0) & (M > 0)
    viscosities = np.array([eta, 4*eta, 4*etaC*free, M*free, M*free])
    squares = viscosities[:, cells]*(true - own[:, cells])**2
    # Where there is no microrotation, nor beside it in a cell, the reference
    # may have none
    power = np.bincount(cells, weights*np.nansum(squares, axis=0))
    return power/np.bincount(cells, weights)*case.volumes()


def rank_correlation(a, b):
    """Spearman's, of positive numbers; below 1e-12 of the largest all are
    alike."""
    def ranks(values):
        values = np.round(np.log(values/values.max() + 1e-12), 6)
        order = np.unique(values, return_inverse=True)[1]
        # Equal values have the mean of their places
        counts = np.bincount(order)
        return (np.cumsum(counts) - counts/2)[order]
    return float(np.corrcoef(ranks(a), ranks(b))[0, 1])


def found(indicator, true, share=0.1):
    """Part of the true error in a share of the cells, the worst by the
    indicator, over that in as many worst ones by the error itself."""
    n = max(1, round(share*len(true)))
    return float(true[np.argsort(-indicator)[:n]].sum()
                 / np.sort(true)[-n:].sum())
