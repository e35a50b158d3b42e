"""Values that results are made of."""

from fractions import Fraction
from typing import NamedTuple


class Element(NamedTuple):
    """A vertex or an edge of a light, blocker or receiver; edge i runs from vertex i to the next."""

    of: str
    """ "light:lamp", "blocker:vase#12", "receiver:floor"."""
    number: int


class Event(NamedTuple):
    """What happens along an edge of a divided receiver."""

    kind: str
    """ "vertex_edge", "coplanar_edges", "coplanar_plane", "contact", "light_plane", "horizon", "border", "triple_edge"."""
    elements: tuple[Element, ...]
    """The vertex and the edge that are seen in line; of a triple edge three edges."""
    order: int | None
    """The lowest derivative of the visible fraction that may jump; None at the border."""
    extremal: str
    """What it bounds as far as light and one blocker decide it: "none", "occlusion", "umbra"."""


class Arc(NamedTuple):
    """An edge that is the arc of a conic: a rational quadratic Bezier curve between the edge's vertices."""

    edge: int
    control_point: tuple[float, float, float]
    """The middle one, an estimate."""
    weight: float
    """Of the middle one, an estimate: below 1 of an ellipse, above 1 of a hyperbola."""


class Plane(NamedTuple):
    """An extremal plane, named by the elements it goes through."""

    kind: str
    """ "separating_blocker_plane", "separating_light_plane", "supporting_blocker_plane"."""
    edge: int | None
    """Of the blocker; of a separating light plane an edge of the light."""
    vertex: int
    """Of the light; of a separating light plane a vertex of the blocker."""
    coefficients: tuple[float, float, float, float] | None
    """a, b, c, d, each correctly rounded: a x + b y + c z + d <= 0 is the side of the shadow. None without a volume."""
    exact: tuple[Fraction, Fraction, Fraction, Fraction] | None
    """The same, exactly."""
