"""Mass matrix by composite bodies.

    m, h, E of a link and all that is carried by it, about its root               (1)
    F = m e        or  e x h,     N = h x e  or  (tr(E) 1 - E) e                   (2)
    M_kk = e . F   or  e . N                                                       (3)
    M_jk = e_j . F or  e_j . N    with F, N taken inwards to the root of j         (4)

The first form is that of a slide along e, the second that of a turn about it. (2) is what moves the
composite body with u_k' = 1, all else at rest. A link that does not turn with its parent brings its
mass alone, and no couple. Featherstone, Rigid Body Dynamics Algorithms, 2008, section 6.2.
"""

from collections.abc import Sequence

from mechanics.mechanism import GROUND, Mechanism
from mechanics.program.builder import Node
from mechanics.program.vectors import Matrix, Vector, add, cross, dot, scale, times, transpose
from mechanics.recursions.frames import common, express
from mechanics.recursions.joints import Link, rotated
from mechanics.recursions.pseudo_inertia import outer


def mass_matrix(mechanism: Mechanism, links: Sequence[Link]) -> tuple[tuple[Node, ...], ...]:
    """M in q, rows and columns in the order of u.

    Parameters
    ----------
    links : sequence of Link
        Of `joint_tree`.
    """
    size, zero = len(mechanism.u), mechanism.builder.zero
    matrix = [[zero] * size for _ in range(size)]
    for k, (mass, first, second) in enumerate(composites(mechanism, links)):
        link = links[k]
        force, couple = moved(link, mass, first, second)
        matrix[link.coordinate][link.coordinate] = dot(link.axis, couple if link.turning else force)
        child, home = link, link.frame
        while child.parent != GROUND:
            parent = links[child.parent]
            inner = common(mechanism, (home, parent.frame))
            force, home = express(mechanism, force, home, inner), inner
            arm = cross(child.offset, express(mechanism, force, home, parent.frame))
            if child.carried:
                couple = add(express(mechanism, couple, child.frame, parent.frame), arm)
            else:
                couple = arm
            if parent.turning:
                entry = dot(parent.axis, couple)
            else:
                entry = dot(parent.axis, express(mechanism, force, home, parent.frame))
            matrix[link.coordinate][parent.coordinate] = entry
            matrix[parent.coordinate][link.coordinate] = entry
            child = parent
    return tuple(map(tuple, matrix))


def composites(
    mechanism: Mechanism, links: Sequence[Link]
) -> tuple[tuple[Node, Vector, Matrix], ...]:
    """Equation (1) for each link."""
    masses = [link.mass for link in links]
    firsts = [link.first for link in links]
    seconds = [link.second for link in links]
    for k in reversed(range(len(links))):
        link = links[k]
        parent = link.parent
        if parent == GROUND:
            continue
        arm, mass = link.offset, masses[k]
        weighed = scale(mass, arm)
        second = outer(weighed, arm)
        if link.carried:
            first = express(mechanism, firsts[k], link.frame, links[parent].frame)
            turned = rotated(mechanism, seconds[k], link.frame, links[parent].frame)
            across = outer(arm, first)
            parts = (second, turned, across, transpose(across))
            second = tuple(add(*rows) for rows in zip(*parts, strict=True))
            weighed = add(weighed, first)
        masses[parent] = masses[parent] + mass
        firsts[parent] = add(firsts[parent], weighed)
        pairs = zip(seconds[parent], second, strict=True)
        seconds[parent] = tuple(add(a, b) for a, b in pairs)
    return tuple(zip(masses, firsts, seconds, strict=True))


def moved(link: Link, mass: Node, first: Vector, second: Matrix) -> tuple[Vector, Vector]:
    """Force at the root and couple of a composite body, equation (2)."""
    if not link.turning:
        return scale(mass, link.axis), cross(first, link.axis)
    return cross(link.axis, first), times(inertia(second), link.axis)


def inertia(second: Matrix) -> Matrix:
    """tr(E) 1 - E."""
    diagonal = [second[i][i] for i in range(3)]
    return tuple(
        tuple(diagonal[i - 1] + diagonal[i - 2] if i == j else -second[i][j] for j in range(3))
        for i in range(3)
    )
