"""A slot whose frictional walls slide up along its filling, which stands on the
bottom: the scene of Janssen's pressure (cosserat.yielding)."""

from cosserat.case import cpu_seconds
from cosserat.scenes.box import Box, SIDES
from cosserat.scenes.yielding import entries, steps

#: Slip velocity of the walls over their speed
CREEP = 1e-4


class Plug(Box):
    """The slot: width 1, given depth, weight 1, n x down cells. The walls move
    at the speed 1, the top is open. material: further constants; omega: of the
    walls."""

    def __init__(self, path, n=1, down=100, depth=5, mu=0.3, adhesion=0,
                 eta=1e3, material=None, omega="type zeroGradient;", **box):
        friction = {"type": "coulombFriction", "mu": mu, "adhesion": adhesion,
                    "slipVelocity": CREEP, "velocity": "uniform (0 1 0)",
                    "value": "uniform (0 0 0)"}
        side = (entries(friction), omega)
        self.depth, self.down = depth, down
        super().__init__(path, n, materials={
            "a": {"rho": 1, "eta": eta, "etaC": 0, "R": 0,
                  **(material or {})}}, g=(0, -1, 0),
            walls={"left": side, "right": side,
                   "bottom": ("type noSlip;", "type zeroGradient;"),
                   "top": ("type zeroGradient;", "type zeroGradient;",
                           "type prghPressure; p uniform 0;")}, **box)

    def mesh(self):
        patches = "".join(f"{side} {{ type wall; faces ({face}); }}\n"
                          for side, face in SIDES.items())
        vertices = " ".join(f"({x} {y} {z})" for z in (0, 0.1)
                            for x, y in ((0, -self.depth), (1, -self.depth),
                                         (1, 0), (0, 0)))
        self.file("system/blockMeshDict", f"""
scale 1; vertices ({vertices});
blocks (hex (0 1 2 3 4 5 6 7) ({self.n} {self.down} 1)
    simpleGrading (1 1 1));
edges (); boundary ( {patches} );
defaultPatch {{ name frontAndBack; type empty; }}
""")

    def write(self):
        case = super().write()
        return case.measure("load", "wallLoad")


def solve(case, ranks=1, **parts):
    """Run it. Returns what the log says of steps and costs of its first solve,
    from rest."""
    case.solve(ranks, **parts)
    log = case.log()
    return {**steps(log.split("\nTime = ")[0]), "cpu": cpu_seconds(log)}
