"""Rolling as its author named it: what a wheel, a ball or an ellipsoid has to be on its plane.

    Q = C - S n / sqrt(n . S n)                        a ball, an ellipsoid, a wheel, on a plane (1)
    v_C + w x (Q - C) = v_P + w_P x (Q - P)            its material at the contact Q does not slip
                                                       on that of the parent P                   (2)
    F . v + T . w = 0                                  on each turn of the kind about Q          (3)

A wheel that stands on nothing else is placed by exponentials of matrices, in the order yaw, lean,
spin; nothing of `mechanics.scene.joints` is used.
"""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

from flint import arb, arb_mat

from mechanics.checks.as_declared import Motion, cross, dot
from mechanics.checks.joint_rows import (
    AXES,
    LETTERS,
    NONE,
    number,
    place,
    rotation,
    same,
    turn,
    unit,
)
from mechanics.checks.virtual_power import Row
from mechanics.scene import Joint


@dataclass(frozen=True)
class _Wheel:
    """What the arguments say.

    Attributes
    ----------
    frame, hub : arb_mat
        Rotations of the child, and of what yaws and leans with it.
    directions : mapping of str to arb_mat
        Of the forces and couples, by what their names end in; the contact presses along "normal".
    turns : tuple of arb_mat
        About which the child may turn at the contact.
    axle : arb_mat or None
        Along which a leaning wheel spins.
    """

    contact: arb_mat
    centre: arb_mat
    frame: arb_mat
    hub: arb_mat
    directions: Mapping[str, arb_mat]
    turns: tuple[arb_mat, ...]
    axle: arb_mat | None = None


def rolling(motion: Motion, joint: Joint) -> Iterator[Row]:
    """Statements (1) to (3) of one joint at one virtual motion that the scene admits."""
    name, given = joint.name, joint.given
    if given["onto"] is not None:
        wheel = _touching(motion, joint)
        gap = wheel.contact - place(motion, joint.at)
        yield f"{name}: the gap", dot(wheel.directions["normal"], gap), arb(0)
    elif given["inside"] is not None or given["outside"] is not None:
        wheel = _in_a_ring(motion, joint)
    else:
        wheel = _upright(motion, joint) if given["axis"] is not None else _leaning(motion, joint)
    yield from same(f"{name}: its centre", place(motion, joint.point), wheel.centre)
    yield from same(f"{name}: its frame", rotation(motion, joint.frame), wheel.frame)
    if joint.contact is not None and joint.hub is not None:
        yield from same(f"{name}: the contact", place(motion, joint.contact), wheel.contact)
        yield from same(f"{name}: the hub", rotation(motion, joint.hub), wheel.hub)
    slip = _material(motion, joint.child, wheel) - _material(motion, joint.parent, wheel)
    yield from same(f"{name}: it does not slip", slip, NONE)
    yield from _forces(motion, joint, wheel)
    yield from _speeds(motion, joint, wheel)


def _material(motion: Motion, body: str | None, wheel: _Wheel) -> arb_mat:
    """Velocity of what a body has at the contact."""
    if body is None:
        return NONE
    here, velocity, *_ = motion.centre(body).parts
    omega, _ = motion.spin(body)
    return velocity + cross(omega, wheel.contact - here)


def _forces(motion: Motion, joint: Joint, wheel: _Wheel) -> Iterator[Row]:
    """Statement (3), where forces act and along what."""
    named = {own.name: own for own in joint.reactions}
    for name, own in motion.reactions():
        if name not in named or own.body != joint.child:
            continue
        word = name.removeprefix(f"{joint.name}_")
        force = named[name].at is not None
        along = own.force if force else own.couple
        if force:
            yield from same(f"{name}: where it acts", own.at, wheel.contact)
        direction = wheel.directions[word if force else word.removeprefix("m")]
        if word == "normal":
            yield from same(f"{name}: it presses", along, direction)
        yield from same(f"{name}: its direction", cross(along, direction), NONE)
        for omega in wheel.turns:
            moved = cross(omega, own.at - wheel.contact)
            power = dot(own.force, moved) + dot(own.couple, omega)
            yield f"{name}: power on the joint's own motion", power, arb(0)


def _speeds(motion: Motion, joint: Joint, wheel: _Wheel) -> Iterator[Row]:
    """The total spin rate, and the velocity of the contact forward and to the side."""
    if wheel.axle is None or joint.contact is None:
        return
    ahead = motion.position(joint.contact).parts[1]
    omega, _ = motion.spin(joint.child)
    rates = (dot(omega, wheel.axle), dot(ahead, wheel.directions["forward"]),
             dot(ahead, wheel.directions["side"]))  # fmt: skip
    for (_, u, definition), rate in zip(joint.own, rates, strict=False):
        yield f"{joint.name}: the speed {u}", motion.number(definition), rate


def _base(motion: Motion, joint: Joint) -> tuple[arb_mat, list[arb_mat], int]:
    """The parent's frame, its axes with that of the normal last, and the normal's sign."""
    ((column, frame),) = joint.given["normal"].args
    (k,) = (k for k in range(3) if column[k] != 0)
    sign = 1 if column[k].is_positive else -1
    return rotation(motion, frame), [AXES[(k + 1 + i) % 3] for i in range(3)], sign


def _in_plane(R: arb_mat) -> dict[str, arb_mat]:
    return {letter: R * axis for letter, axis in zip(LETTERS, AXES, strict=True)}


def _leaning(motion: Motion, joint: Joint) -> _Wheel:
    R, (e1, e2, e3), sign = _base(motion, joint)
    x, y = (number(motion, q) for q in joint.given["coordinates"])
    yaw, lean, spin = (number(motion, q) for q in joint.given["angles"])
    heading = R * turn(e3, yaw)
    hub = heading * turn(e1, lean)
    contact = place(motion, joint.at) + R * (e1 * x + e2 * y)
    directions = {"normal": R * e3 * sign, "forward": heading * e1, "side": heading * e2}
    centre = contact + hub * e3 * (sign * number(motion, joint.given["radius"]))
    return _Wheel(
        contact, centre, hub * turn(e2, spin), hub, directions | _in_plane(R), AXES, hub * e2
    )  # fmt: skip


def _upright(motion: Motion, joint: Joint) -> _Wheel:
    R, (e1, e2, e3), sign = _base(motion, joint)
    axle = R.transpose() * unit(motion, joint.given["axis"])
    (x,), (angle,) = joint.given["coordinates"], joint.given["angles"]
    along, up = e1 if dot(e1, axle) == 0 else e2, e3 * sign
    contact = place(motion, joint.at) + R * along * number(motion, x)
    centre = contact + R * up * number(motion, joint.given["radius"])
    directions = {"normal": R * up, "forward": R * along, "side": R * axle}
    frame = R * turn(axle, number(motion, angle))
    return _Wheel(contact, centre, frame, R, directions, (R * axle,))


def _in_a_ring(motion: Motion, joint: Joint) -> _Wheel:
    given, (R, (_, _, e3), sign) = joint.given, _base(motion, joint)
    axle = R.transpose() * unit(motion, given["axis"])
    phi, angle = (number(motion, q) for q in given["angles"])
    inside = given["inside"] is not None
    big = number(motion, given["inside"] if inside else given["outside"])
    reach = big + number(motion, given["radius"]) * (-1 if inside else 1)
    hub, at = R * turn(axle, phi), place(motion, joint.at)
    out = hub * e3 * sign
    directions = {"normal": -out if inside else out, "side": R * axle,
                  "forward": cross(R * axle, out)}  # fmt: skip
    frame = R * turn(axle, angle)
    return _Wheel(at + out * big, at + out * reach, frame, hub, directions, (R * axle,))


def _touching(motion: Motion, joint: Joint) -> _Wheel:
    """Equation (1): S = r^2, a^2 e1 e1 + b^2 e2 e2 + c^2 e3 e3, or r^2 (1 - a a) of axle a."""
    given, (R, _, _) = joint.given, _base(motion, joint)
    (point, frame), radius = given["onto"], given["radius"]
    n, own = unit(motion, given["normal"]), rotation(motion, frame)
    sizes = radius if isinstance(radius, tuple | list) else (radius,) * 3
    local = own.transpose() * n
    squares = [number(motion, size) ** 2 for size in sizes]
    S_n = own * arb_mat(3, 1, [squares[k] * local[k, 0] for k in range(3)])
    if given["axis"] is not None:
        axle = unit(motion, given["axis"])
        S_n = S_n - axle * (squares[0] * dot(n, axle))
    centre = place(motion, point)
    contact = centre - S_n * (1 / dot(n, S_n).sqrt())
    return _Wheel(contact, centre, own, R, {"normal": n} | _in_plane(R), AXES)
