"""The silo at rest and the relatives of its corner by finite elements:
recomputes the reference numbers of cosserat.references."""

from cosserat.finiteElements.relatives import relative_values
from cosserat.finiteElements.silo import silo_limit, silo_rate
from cosserat.references import RELATIVES, SILO, SILO_SCENES
from cosserat.scenes.relatives import SCENES

#: Depths of grading where a fluid's surface ends in a corner
DEPTHS = (1e-40, 1e-70, 1e-100)


def row(scene, degree, smallest, value, reference):
    """One row."""
    result = {"scene": scene, "degree": degree, "smallest": smallest,
              "value": value, "reference": reference.value,
              "difference": value/reference.value - 1,
              "uncertainty": reference.uncertainty/abs(reference.value)}
    print(result, flush=True)
    return result


def study():
    """Rows: scene, degree, smallest (relative size of the innermost ring of
    cells; 0: limit of three), value (m2/s for the silo), reference,
    difference and uncertainty (both relative)."""
    rows = []
    for name, scene in SILO_SCENES.items():
        rates, limit = silo_limit(scene, 4, DEPTHS)
        finer = (silo_rate(scene, 5, contact=1e-20)
                 / silo_rate(scene, 4, contact=1e-20))
        for smallest, value in (*zip(DEPTHS, rates), (0, limit*finer)):
            rows.append(row(name, 4 if smallest else 5, smallest, value,
                            SILO[name]))
    for name, scene in SCENES.items():
        for degree in (4, 5):
            for quantity, value in relative_values(scene,
                                                   degree=degree).items():
                rows.append(row(f"{name}: {quantity}", degree, 1e-20, value,
                                RELATIVES[name, quantity]))
    return rows
