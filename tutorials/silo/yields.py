#!/usr/bin/env python3
"""The silo whose fill yields, beside the viscous one: runs in results/, and a
picture with what stagnates outlined."""

from pathlib import Path

from cosserat.case import Case
from cosserat.scenes.silo import COARSE
from cosserat.yieldPictures import compare

compare(Case(Path(__file__).resolve().parent), (0, 0.1, 2), 9.5e-4, COARSE, "m2")
