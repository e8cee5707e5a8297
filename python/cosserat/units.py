"""Units of fields, as one writes them at an axis."""

import re

#: Exponents of kg, m, s, K, mol, A, cd
NAMES = {
    (0, 0, 0): "", (0, 1, 0): "m", (0, 2, 0): "m$^2$", (0, 3, 0): "m$^3$",
    (0, 0, 1): "s", (0, 0, -1): "1/s", (0, 1, -1): "m/s",
    (0, 1, -2): "m/s$^2$", (0, 2, -1): "m$^2$/s", (0, 3, -1): "m$^3$/s",
    (1, -3, 0): "kg/m$^3$", (1, -1, -2): "Pa", (1, 0, -2): "Pa m",
    (1, -2, -2): "N/m$^3$", (1, 1, -2): "N", (1, 2, -2): "N m",
    (1, -1, -1): "Pa s", (1, 1, -1): "Pa s m$^2$", (-1, 1, 1): "1/(Pa s)",
    (1, -1, -3): "W/m$^3$", (1, 2, -3): "W",
}

BASE = ("kg", "m", "s", "K", "mol", "A", "cd")


def unit(dimensions):
    """Unit of the dimensions of a file, exponents or names."""
    if re.search("[A-Za-z]", dimensions):
        return re.sub(r"\^\(?(-?[\d.]+)\)?", r"$^{\1}$", dimensions.strip())
    powers = [float(x) for x in dimensions.split()]
    powers += [0.0]*(7 - len(powers))
    if not any(powers[3:]) and tuple(powers[:3]) in NAMES:
        return NAMES[tuple(powers[:3])]
    return " ".join(name if power == 1 else f"{name}$^{{{power:g}}}$"
                    for name, power in zip(BASE, powers) if power)


def label(name, dimensions):
    """Name of a quantity with its unit."""
    text = unit(dimensions)
    return f"{name} [{text}]" if text else name
