"""Names of regions."""

import enum


class Region(enum.IntEnum):
    """What a point, or a face of a receiver, receives of a light; the numbers in arrays of regions."""

    LIT = 0
    PENUMBRA = 1
    UMBRA = 2
    UNLIT = 3
    UNRESOLVED_EEE = 4
