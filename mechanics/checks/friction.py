"""What friction does.

    sum F . v = -mu N |v|         over both bodies

That is a loss, because N > 0 is a condition of the scene.
"""

from sympy import Abs, Add, Symbol

from mechanics.checks.agreement import proof_pays
from mechanics.checks.laws import power_of
from mechanics.exact import Finding, prove_equal
from mechanics.kinematics import chain
from mechanics.scene import Scene
from mechanics.scene.actions import frictions, load_actions


def check_friction(scene: Scene) -> tuple[Finding, ...]:
    """Each friction: it takes out mu N |v|."""
    motions = {motion.body.name: motion for motion in chain.body_motions(scene)}
    found = []
    for load in frictions(scene):
        power = Add(*(power_of(motions[a.body], a) for a in load_actions(scene, load)))
        size = scene.plain(load.coefficient, load.name) * Symbol(load.normal, real=True)
        lost = -size * Abs(scene.plain(load.sliding, load.name))
        subject = f"load {load.name}: power = -mu N |sliding|"
        found.append(prove_equal(subject, power, lost, try_normal=proof_pays(scene)))
    return tuple(found)
