"""Robots in MJCF: MuJoCo's own compiler reads the file, and what is smooth comes in.

    body frame = parent's moved by body_pos, turned by body_quat
    joints of a body in their order, each about its anchor
    tau = actuators - damping q' - stiffness (q - springref),   M + diag(armature)

Equality constraints are held exactly; MuJoCo lets them give. What has no smooth equations is named,
and left out only when that is asked for. Source: mujoco.readthedocs.io, Computation, XML reference.
"""

from collections.abc import Collection, Iterator
from fractions import Fraction
from math import prod
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

from sympy import Expr, ImmutableMatrix, Integer, Rational, pi

from mechanics.errors import InputError
from mechanics.importers.assemble import SYMBOLIC, assemble
from mechanics.importers.decimals import Notes
from mechanics.importers.robot import (
    ALONG_X,
    MOST_LINKS,
    STRAIGHT,
    ZERO,
    Actuation,
    Cable,
    Closure,
    Column,
    Connection,
    Coupling,
    Inertial,
    Limits,
    Link,
    Polynomial,
    Robot,
)
from mechanics.importers.rotations import from_doubles
from mechanics.scene import Scene, parameters
from mechanics.scene.declaration import DROP

ROUGH = ("actuators", "armature", "contact", "equality", "fluid", "friction", "gravcomp", "plugins",
         "springs", "tendons")  # fmt: skip
"""What may be left out."""
FREE, BALL, SLIDE, HINGE = range(4)
LARGEST = 16_000_000
SIDES = ("nrow", "ncol", "width", "height")
"""Of height fields and textures."""
NAMING = frozenset({"name", "class", "childclass"})
NOT_FINITE = frozenset({"nan", "+nan", "-nan", "inf", "+inf", "-inf", "infinity", "-infinity"})


def from_mjcf(
    path: str | Path, symbolic: Collection[str] = SYMBOLIC, leave_out: Collection[str] = ()
) -> Scene:
    """The scene of a model in MuJoCo's XML.

    Coordinates have the names of the joints, inputs those of the actuators. Quaternions have the
    scalar first, angular velocities are those in the frame of the body, as in MuJoCo.

    Parameters
    ----------
    path : str or Path
    symbolic : tuple of str
        Which numbers become parameters, as in `from_urdf`.
    leave_out : tuple of str
        What has no smooth equations here and may be missing: ``"contact"``, ``"friction"``
        (frictionloss), ``"fluid"``, ``"actuators"`` (with states, muscles, at sites), ``"tendons"``
        (that wrap, limited or with slack), and others that the refusal names.

    Returns
    -------
    Scene
        Its `notes` tell what was left out, and which turns were taken as multiples of pi/12. It is
        ``redundant="drop"``: MuJoCo does not mind what follows from other constraints.

    Raises
    ------
    InputError
        When MuJoCo is missing or refuses the file, or for what `leave_out` does not name.

    Examples
    --------
    >>> from pathlib import Path
    >>> rod = '<geom type="capsule" size="0.02" fromto="0 0 0 0 0 -1" mass="1"/>'
    >>> body = f'<body name="rod"><joint name="q" axis="0 1 0"/>{rod}</body>'
    >>> _ = Path("rod.xml").write_text(f"<mujoco><worldbody>{body}</worldbody></mujoco>")
    >>> from_mjcf("rod.xml", symbolic=()).coordinates
    (q(t),)
    """
    robot, field, notes = read_mjcf(path, leave_out)
    return assemble(robot, "fixed", symbolic, field, notes, DROP)


def read_mjcf(
    path: str | Path, leave_out: Collection[str] = ()
) -> tuple[Robot, tuple[Expr, Expr, Expr], tuple[str, ...]]:
    """The robot, gravity, and notes; see `from_mjcf`."""
    path = Path(path)
    unknown = [kind for kind in leave_out if kind not in ROUGH]
    if unknown or isinstance(leave_out, str):
        raise InputError(f"leave_out={leave_out!r}: give a tuple of some of {ROUGH}")
    reader = _Reader(_compiled(path))
    robot = reader.robot(path.stem)
    field = reader.field()
    rough = {kind: names for kind, names in sorted(reader.rough.items()) if kind not in leave_out}
    if rough:
        told = "; ".join(f"{kind}: {_some(names)}" for kind, names in rough.items())
        every = tuple(sorted({*leave_out, *rough}))
        raise InputError(
            f"file {path}: it has parts that are not smooth or not supported ({told}): leave them"
            f" out with leave_out={every!r}, or as {path.name}:{','.join(every)}"
        )
    for kind, names in sorted(reader.rough.items()):
        reader.notes.add(f"{kind} left out", _some(names))
    return robot, field, reader.notes.lines()


def _compiled(path: Path) -> Any:
    if not path.is_file():
        raise InputError(f"file {path}: there is no such file")
    if path.stat().st_size > LARGEST:
        raise InputError(f"file {path}: it is larger than {LARGEST // 1_000_000} MB")
    if b"<!DOCTYPE" in path.read_bytes():
        raise InputError(
            f"file {path}: it has a DOCTYPE, which a model does not need: leave it out"
        )
    _refuse_hostile(path)
    try:
        import mujoco
    except ImportError:
        raise InputError(
            f"file {path}: MuJoCo reads such models and is not installed: pip install"
            " 'mechanics[mujoco]'"
        ) from None
    try:
        model = mujoco.MjModel.from_xml_path(str(path))
    except ValueError as error:
        words = " ".join(str(error).split())
        raise InputError(f"file {path}: MuJoCo refuses it: {words[:300]}") from None
    if model.nbody - 1 > MOST_LINKS:
        raise InputError(f"file {path}: {model.nbody - 1} bodies: at most {MOST_LINKS} are read")
    return model


def _refuse_hostile(path: Path) -> None:
    """More bodies than are read, before MuJoCo makes them; NaN, which it takes for nothing."""
    try:
        waiting, bodies = [(ElementTree.parse(path).getroot(), 1)], 0
    except ElementTree.ParseError as error:
        raise InputError(f"file {path}: it is no XML: {error}") from None
    while waiting:
        element, times = waiting.pop()
        for key, value in element.items():
            if key not in NAMING and not NOT_FINITE.isdisjoint(value.lower().split()):
                what = f"{element.tag} {key}={value[:40]!r}"
                raise InputError(f"file {path}: {what}: give finite numbers")
        times *= _product(element.get("count", "1"))
        bodies += times * (element.tag in ("body", "composite", "flexcomp"))
        if prod(_product(element.get(side, "1")) for side in SIDES) > LARGEST:
            raise InputError(f"file {path}: a {element.tag} of more than {LARGEST} entries")
        waiting += [(child, times) for child in element]
    if bodies > MOST_LINKS:
        raise InputError(f"file {path}: {bodies} bodies: at most {MOST_LINKS} are read")


def _product(text: str) -> int:
    """Of whole numbers; what is none MuJoCo refuses."""
    return prod(int(one) for one in text.split() if one.isdecimal() and len(one) < 20)


def _some(names: list[str]) -> str:
    rest = f" and {len(names) - 3} more" if len(names) > 3 else ""
    return ", ".join(names[:3]) + rest


class _Reader:
    """Arrays of a compiled model; `rough` collects what is not smooth."""

    def __init__(self, model: Any) -> None:
        import mujoco

        self.m, self.mj, self.notes = model, mujoco, Notes()
        self.rough: dict[str, list[str]] = {}

    def robot(self, name: str) -> Robot:
        """Links, joints and couplings."""
        self._contacts()
        self._others()
        links, joints = [Link("world")], []
        for body in range(1, self.m.nbody):
            own, links_of_joints = self._body(body)
            joints += own
            links += links_of_joints
        return Robot(name, tuple(links), tuple(joints), tuple(self._couplings()))

    def field(self) -> tuple[Expr, Expr, Expr]:
        """Gravity; along -z a parameter g."""
        x, y, z = self._column(self.m.opt.gravity)
        if self.m.opt.disableflags & int(self.mj.mjtDisableBit.mjDSBL_GRAVITY):
            return ZERO, ZERO, ZERO
        if x == 0 and y == 0 and z < 0:
            (g,) = parameters("g", "m/s^2", str(-z))
            return ZERO, ZERO, -g
        return x, y, z

    # ------------------------------------------------------------------ bodies and joints

    def _body(self, body: int) -> tuple[list[Connection], list[Link]]:
        """The joints of a body in their order, with a link without mass between two of them."""
        m, name, parent = self.m, self._name("BODY", body), int(self.m.body_parentid[body])
        place, turn = self._column(m.body_pos[body]), self._turn(m.body_quat[body], f"body {name}")
        own = Inertial(
            _number(m.body_mass[body]), self._column(m.body_ipos[body]),
            self._turn(m.body_iquat[body], f"inertia of {name}"),
            (*self._column(m.body_inertia[body]), ZERO, ZERO, ZERO),
        )  # fmt: skip
        if m.body_gravcomp[body]:
            self._not_smooth("gravcomp", name)
        below = self._name("BODY", parent)
        count, first = int(m.body_jntnum[body]), int(m.body_jntadr[body])
        if not count:
            fixed = Connection(f"{name}_fixed", "fixed", below, name, place, turn, driven=False)
            return [fixed], [Link(name, own)]
        joints, links = [], []
        for j in range(first, first + count):
            last = j == first + count - 1
            child = name if last else f"{name}_{self._name('JOINT', j)}"
            joints.append(self._joint(j, below, child, place, turn))
            links.append(Link(child, own if last else None))
            below, place, turn = child, (ZERO, ZERO, ZERO), STRAIGHT
        return joints, links

    def _joint(
        self, j: int, parent: str, child: str, place: Column, turn: ImmutableMatrix
    ) -> Connection:
        m, name, kind = self.m, self._name("JOINT", j), int(self.m.jnt_type[j])
        dof, address = int(m.jnt_dofadr[j]), int(m.jnt_qposadr[j])
        count = {FREE: 6, BALL: 3}.get(kind, 1)
        armature, loss, damping = (
            m.dof_armature[dof : dof + count], m.dof_frictionloss[dof : dof + count],
            m.dof_damping[dof : dof + count],
        )  # fmt: skip
        for array in ("dof_dampingpoly", "jnt_stiffnesspoly"):
            row = getattr(m, array, None)
            if row is not None and row[dof if "dof" in array else j].any():
                self._not_smooth("springs", name)
        if loss.any():
            self._not_smooth("friction", name)
        if kind in (FREE, BALL) and armature.any():
            self._not_smooth("armature", name)
        if kind in (FREE, BALL) and m.jnt_stiffness[j]:
            self._not_smooth("springs", name)
        if kind == FREE:
            if damping.any():
                self._not_smooth("springs", name)
            # Its coordinates are those in the world.
            return Connection(name, "floating", parent, child, driven=False)
        anchor = self._column(m.jnt_pos[j])
        at = ImmutableMatrix(3, 1, place) + turn * ImmutableMatrix(3, 1, anchor)
        back = tuple(-entry for entry in anchor)
        one = {"place": tuple(at), "turn": turn, "offset": back, "driven": False,
               "damping": _number(damping[0])}  # fmt: skip
        if kind == BALL:
            return Connection(name, "ball", parent, child, **one)
        zero = _number(m.qpos0[address])
        if zero and kind == HINGE:
            zero = _multiple(float(m.qpos0[address])) or zero
        lower, upper = (_number(e) for e in m.jnt_range[j]) if m.jnt_limited[j] else (None, None)
        if m.jnt_limited[j]:
            self.notes.add("limits of joints are conditions, not forces", name)
        return Connection(
            name, "turn" if kind == HINGE else "slide", parent, child, **one,
            axis=_axis(m.jnt_axis[j]), limits=Limits(lower, upper), zero=zero,
            stiffness=_number(m.jnt_stiffness[j]), rest=_number(m.qpos_spring[address]),
            armature=_number(armature[0]),
        )  # fmt: skip

    # ------------------------------------------------------------------ couplings

    def _couplings(self) -> Iterator[Coupling]:
        for k in range(self.m.nu):
            yield from self._actuator(k)
        for k in range(self.m.ntendon):
            yield from self._tendon(k)
        for k in range(self.m.neq):
            if self.m.eq_active0[k]:
                yield from self._equality(k)

    def _actuator(self, k: int) -> Iterator[Actuation]:
        m, mj, name = self.m, self.mj, self._name("ACTUATOR", k)
        joint, gear = int(m.actuator_trnid[k][0]), m.actuator_gear[k]
        trn, kinds = int(m.actuator_trntype[k]), (int(m.actuator_gaintype[k]),
                                                  int(m.actuator_biastype[k]))  # fmt: skip
        smooth = (
            int(m.actuator_dyntype[k]) == int(mj.mjtDyn.mjDYN_NONE)
            and kinds[0] in (int(mj.mjtGain.mjGAIN_FIXED), int(mj.mjtGain.mjGAIN_AFFINE))
            and kinds[1] in (int(mj.mjtBias.mjBIAS_NONE), int(mj.mjtBias.mjBIAS_AFFINE))
        )
        for array in ("actuator_armature", "actuator_damping", "actuator_dampingpoly"):
            row = getattr(m, array, None)
            smooth = smooth and (row is None or not row[k].any())
        if trn == int(mj.mjtTrn.mjTRN_TENDON):
            terms = self._path(joint)
        elif trn in (int(mj.mjtTrn.mjTRN_JOINT), int(mj.mjtTrn.mjTRN_JOINTINPARENT)):
            turns = int(m.jnt_type[joint]) in (SLIDE, HINGE)
            terms = ((self._name("JOINT", joint), Integer(1)),) if turns else None
        else:
            terms = None
        if not smooth or terms is None:
            self._not_smooth("actuators", name)
            return
        if m.actuator_forcelimited[k] or m.actuator_ctrllimited[k]:
            self.notes.add("limits of actuators are not kept", name)
        factor = _number(gear[0])
        gain, bias = self._column(m.actuator_gainprm[k]), self._column(m.actuator_biasprm[k])
        if kinds[0] == int(mj.mjtGain.mjGAIN_FIXED):
            gain = (gain[0], ZERO, ZERO)
        if kinds[1] == int(mj.mjtBias.mjBIAS_NONE):
            bias = (ZERO, ZERO, ZERO)
        yield Actuation(name, tuple((one, factor * c) for one, c in terms), gain, bias)

    def _path(self, k: int) -> tuple[tuple[str, Expr], ...] | None:
        """Joints of a tendon with their coefficients; None where it runs over sites."""
        m, found = self.m, []
        for w in range(m.tendon_adr[k], m.tendon_adr[k] + m.tendon_num[k]):
            if int(m.wrap_type[w]) != int(self.mj.mjtWrap.mjWRAP_JOINT):
                return None
            joint = self._name("JOINT", int(m.wrap_objid[w]))
            found.append((joint, _number(m.wrap_prm[w])))
        return tuple(found)

    def _tendon(self, k: int) -> Iterator[Coupling]:
        m, name = self.m, self._name("TENDON", k)
        stiffness, damping = _number(m.tendon_stiffness[k]), _number(m.tendon_damping[k])
        low, high = map(_number, m.tendon_lengthspring[k])
        rough = m.tendon_limited[k] or m.tendon_frictionloss[k] or (stiffness and low != high)
        for array in ("tendon_stiffnesspoly", "tendon_dampingpoly", "tendon_armature"):
            row = getattr(m, array, None)
            rough = rough or (row is not None and row[k].any())
        if rough:
            self._not_smooth("tendons", name)
            return
        if not stiffness and not damping:
            return
        if terms := self._path(k):
            yield Actuation(name, terms, None, (stiffness * low, -stiffness, -damping))
            return
        way = range(m.tendon_adr[k], m.tendon_adr[k] + m.tendon_num[k])
        if len(way) != 2 or any(
            int(m.wrap_type[w]) != int(self.mj.mjtWrap.mjWRAP_SITE) for w in way
        ):
            self._not_smooth("tendons", name)
            return
        one, two = (self._site(int(m.wrap_objid[w])) for w in way)
        yield Cable(name, (one, two), stiffness, low, damping)

    def _site(self, site: int) -> tuple[str, Column]:
        body = self._name("BODY", int(self.m.site_bodyid[site]))
        return body, self._column(self.m.site_pos[site])

    def _equality(self, k: int) -> Iterator[Coupling]:
        m, mj, name = self.m, self.mj, self._name("EQUALITY", k)
        kind, one, two = int(m.eq_type[k]), int(m.eq_obj1id[k]), int(m.eq_obj2id[k])
        data = m.eq_data[k]
        of_bodies = int(m.eq_objtype[k]) == int(mj.mjtObj.mjOBJ_BODY)
        self.notes.add("equality constraints are held exactly", name)
        if kind == int(mj.mjtEq.mjEQ_JOINT):
            if any(int(m.jnt_type[j]) not in (SLIDE, HINGE) for j in (one, two) if j >= 0):
                self._not_smooth("equality", name)
                return
            rests = [_number(m.qpos0[m.jnt_qposadr[j]]) if j >= 0 else ZERO for j in (one, two)]
            numbers = [_number(e) for e in data[:5]]
            other = self._name("JOINT", two) if two >= 0 else None
            rest = rests[0] + (numbers[0] if other is None else ZERO)
            yield Polynomial(name, self._name("JOINT", one), other, rest, rests[1], tuple(numbers))
        elif kind == int(mj.mjtEq.mjEQ_CONNECT) and of_bodies:
            bodies = [self._name("BODY", body) for body in (one, two)]
            places = self._column(data[:3]), self._column(data[3:6])
            yield Closure(name, (bodies[0], places[0]), (bodies[1], places[1]), None)
        elif kind == int(mj.mjtEq.mjEQ_WELD) and of_bodies:
            bodies = [self._name("BODY", body) for body in (one, two)]
            turn = self._turn(data[6:10], f"weld {name}")
            place = self._column(data[3:6])
            yield Closure(name, (bodies[0], place), (bodies[1], (ZERO, ZERO, ZERO)), turn)
        else:
            self._not_smooth("equality", name)

    # ------------------------------------------------------------------ what is not smooth

    def _not_smooth(self, kind: str, name: str) -> None:
        names = self.rough.setdefault(kind, [])
        if name not in names:
            names.append(name)

    def _contacts(self) -> None:
        """Geoms that may touch: MuJoCo's own rule of types, affinities and neighbours."""
        m = self.m
        flags = self.mj.mjtDisableBit
        off = int(flags.mjDSBL_CONTACT) | int(flags.mjDSBL_CONSTRAINT)
        if m.opt.disableflags & off:
            return
        for pair in range(m.npair):
            self._not_smooth("contact", self._name("PAIR", pair))
        active = [g for g in range(m.ngeom) if m.geom_contype[g] or m.geom_conaffinity[g]]
        weld, signatures = m.body_weldid, {int(s) for s in m.exclude_signature}
        for i, g in enumerate(active):
            for h in active[i + 1 :]:
                a, b = int(m.geom_bodyid[g]), int(m.geom_bodyid[h])
                touch = (m.geom_contype[g] & m.geom_conaffinity[h]) or (
                    m.geom_contype[h] & m.geom_conaffinity[g]
                )
                near = weld[a] == weld[b] or (
                    weld[a] and weld[b]
                    and (weld[m.body_parentid[weld[a]]] == weld[b]
                         or weld[m.body_parentid[weld[b]]] == weld[a])
                )  # fmt: skip
                excluded = {(a << 16) + b, (b << 16) + a} & signatures
                if touch and not near and not excluded:
                    names = (self._name("GEOM", g), self._name("GEOM", h))
                    self._not_smooth("contact", " and ".join(names))

    def _others(self) -> None:
        m = self.m
        if (m.opt.density or m.opt.viscosity) and m.nbody > 1:
            self._not_smooth("fluid", "density or viscosity")
        if m.nplugin:
            self._not_smooth("plugins", f"{m.nplugin} of them")
        if getattr(m, "nflex", 0):
            self._not_smooth("plugins", "flexible bodies")

    # ------------------------------------------------------------------ numbers and names

    def _name(self, kind: str, index: int) -> str:
        name = self.mj.mj_id2name(self.m, getattr(self.mj.mjtObj, f"mjOBJ_{kind}"), index)
        return name or f"{kind.lower()}{index}"

    def _column(self, values: Any) -> Column:
        x, y, z = (_number(value) for value in values[:3])
        return x, y, z

    def _turn(self, quaternion: Any, where: str) -> ImmutableMatrix:
        matrix, words = from_doubles([float(entry) for entry in quaternion])
        if words:
            self.notes.add(f"read an angle as {words}", where)
        return matrix


def _number(value: float) -> Rational:
    """A double as the shortest decimal that gives it."""
    return Rational(Fraction(repr(float(value))))


def _multiple(value: float) -> Expr | None:
    """A multiple of pi/12 that a double is."""
    count = round(value * 12 / float(pi))
    return Rational(count, 12) * pi if abs(value - count * float(pi) / 12) < 1e-14 else None


def _axis(axis: Any) -> tuple[Rational, Rational, Rational]:
    """Along a coordinate axis exactly where it is to 15 digits; by its ratios."""
    largest = max(abs(float(e)) for e in axis)
    x, y, z = (_number(round(float(e) / largest, 16)) for e in axis)
    x, y, z = (ZERO if abs(e) < Rational(1, 10**15) else e for e in (x, y, z))
    return (x, y, z) if (x, y, z) != (0, 0, 0) else ALONG_X
