"""A trade as plain data, from which each of its figures can be made again."""

from dataclasses import asdict
from typing import Any

import numpy as np

from mechanics.trade.choice import Choice
from mechanics.trade.least import LeastModel
from mechanics.trade.measure import Measurement
from mechanics.trade.recommend import Recommendation
from mechanics.trade.result import Trade


def to_record(found: Trade) -> dict[str, Any]:
    """The layout of ``mechanics trade --json``.

    Times are in s for a second of motion, every repetition; errors are in the norm that is stated
    in the record, `null` where a run did not reach the end.
    """
    stick, around = found.yardstick, found.family
    front = {m.choice for m in found.front}
    return {
        "name": found.title,
        "horizon": found.horizon,
        "asked": found.asked,
        "start": found.start,
        "parameters": found.parameters,
        "backend": found.backend,
        "reference": {
            "norm": stick.norm,
            "scale": {n: {"value": v, "unit": u} for n, (v, u) in stick.scale.items()},
            "digits": stick.digits,
            "verified_by": list(stick.verified_by),
            "growth": stick.growth,
            "growth_factor": number(stick.growth_factor),
            "meaningful_until": number(stick.meaningful_until),
            "end": dict(zip(found.start, stick.end, strict=True)),
        },
        "measurements": [
            _measurement(m, found.bound(m.choice), m.choice in front) for m in found.measurements
        ],
        "states": {
            "description": around.words,
            "seed": around.seed,
            "spread": around.spread,
            "compared_with": _choice(around.first),
            "and_with": _choice(around.second),
            "starts": around.starts.tolist(),
            "errors": [
                {"choice": _choice(t.choice), "errors": [number(e) for e in t.errors]}
                for t in found.trained
            ],
        },
        "recommendations": [_pick(found, pick) for pick in found.recommendations],
        "embedded": [_pick(found, pick) for pick in found.embedded],
        "least_model": None if found.least is None else _least(found.least),
        "notes": list(found.notes),
        "left_out": found.left_out,
    }


def _pick(found: Trade, pick: Recommendation) -> dict[str, Any]:
    return {
        "target": pick.target,
        "choice": None if pick.choice is None else _choice(pick.choice),
        "bound": number(pick.bound),
        "cost": None if pick.choice is None else asdict(found.costs[pick.choice]),
        "reason": pick.reason,
    }


def number(value: float) -> float | None:
    """A number that JSON has: None for what is infinite or not known."""
    return float(value) if np.isfinite(value) else None


def _choice(choice: Choice) -> dict[str, Any]:
    setting, variant = choice.setting, choice.variant
    return {
        "words": choice.words,
        "integrator": setting.integrator,
        "tolerance": setting.tolerance,
        "step": setting.step,
        "arithmetic": setting.arithmetic,
        "form": variant.form,
        "flags": variant.flags,
        "model": variant.model,
    }


def _measurement(m: Measurement, bound: float | None, front: bool) -> dict[str, Any]:
    return {
        **_choice(m.choice),
        "error_end": number(m.error_end),
        "error_largest": number(m.error_largest),
        "evaluations": m.evaluations,
        "jacobians": m.jacobians,
        "energy_drift": None if m.energy_drift is None else number(m.energy_drift),
        "seconds": list(m.seconds),
        "noisy": m.noisy,
        "bound": None if bound is None else number(bound),
        "front": front,
        "failure": m.failure,
    }


def _least(found: LeastModel) -> dict[str, Any]:
    return {
        "integrated_by": _choice(found.choice),
        "models": [
            {
                "name": f.name,
                "operations": f.operations,
                "seconds": list(f.seconds),
                "error": number(f.error),
                "words": f.words,
            }
            for f in found.fidelities
        ],
        "amplitudes": [
            {
                "coordinate": a.coordinate,
                "unit": a.unit,
                "equilibrium": a.place,
                "limit": number(a.limit),
                "curve": [[number(x), number(e)] for x, e in a.curve],
                "words": a.words,
            }
            for a in found.amplitudes
        ],
        "notes": list(found.notes),
    }
