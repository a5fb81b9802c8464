"""Names in drawings: none lies on another, on the head of an arrow, or beyond the frame."""

import re

import numpy as np
import pytest

from mechanics.equations import Diagram
from mechanics.mechanism import lower
from mechanics.program import Builder
from mechanics.report.coordinate_drawings import coordinate_drawings
from mechanics.report.drawing import drawing
from mechanics.report.free_body import arrows, free_body_diagram
from mechanics.report.label_places import TOUCHING, box_of, heads_of, shared
from mechanics.report.labels import TEXT, width
from mechanics.report.notation import svg_name, svg_row
from mechanics.report.projection import View, closed
from mechanics.routes import free_body
from mechanics.routes.derivation import as_program
from mechanics.scene import Scene
from systems import EVERY

SYSTEMS = {system.name: system for system in EVERY}
ON_HEAD = 40.0
"""Square pixels: a third of a head, by boxes that are larger than what is in them."""


def scene_of(name: str) -> Scene:
    made = SYSTEMS[name].scene()
    return getattr(made, "scene", made)


def names_can_be_read(svg: str) -> bool:
    """Whether names lie on no other one, on no head of an arrow, and inside of the frame."""
    corner = svg.rpartition("<g transform")[0] or svg
    boxes = np.array([box_of(match) for match in TEXT.finditer(corner)]).reshape(-1, 4)
    on_each_other = np.triu(shared(boxes, boxes), 1)
    size = re.search(r'viewBox="0 0 (\d+) (\d+)"', svg)
    assert size is not None
    inside = (boxes[:, 2:] <= np.array([float(size[1]), float(size[2])]) + 1).all()
    apart = on_each_other.max(initial=0.0) <= TOUCHING
    beside = shared(boxes, heads_of([corner])).max(initial=0.0) <= ON_HEAD
    return bool(apart and beside and inside and (boxes[:, :2] >= -1).all())


@pytest.mark.sample(2)
@pytest.mark.parametrize("name", SYSTEMS)
def test_names_in_a_drawing_can_be_read(name: str) -> None:
    scene = scene_of(name)
    assert names_can_be_read(drawing(scene, scene.example))
    for _, svg in coordinate_drawings(scene, scene.example):
        assert names_can_be_read(svg)


@pytest.mark.sample(4)
@pytest.mark.parametrize("name", SYSTEMS)
def test_every_arrow_of_a_free_body_has_a_name_that_can_be_read(name: str) -> None:
    scene = scene_of(name)
    mechanism = lower(scene, Builder())
    equations = as_program(scene, mechanism, free_body.derive(mechanism))
    view = View(scene, closed(scene, scene.example))
    acting = arrows(equations, view)
    trees = [mechanism.subtree(k) for k in range(len(mechanism.bodies))]
    for inside in {*((k,) for k in range(len(mechanism.bodies))), *map(tuple, trees)}:
        svg = free_body_diagram(equations, view, acting, Diagram(inside, "free body"))
        groups = re.findall(r'<g class="[\w-]+ arrow \w+">(.*?)</g>', svg)
        assert groups
        assert all(len(TEXT.findall(group)) == 1 for group in groups)
        assert names_can_be_read(svg)


def test_every_load_and_reaction_has_an_arrow_on_each_body() -> None:
    """A damper too, though nothing moves in the drawing."""
    scene = scene_of("half_car")
    mechanism = lower(scene, Builder())
    equations = as_program(scene, mechanism, free_body.derive(mechanism))
    for group in arrows(equations, View(scene, scene.example)):
        assert all(np.any(arrow.force) or np.any(arrow.couple) for arrow in group), group


def test_what_follows_a_subscript_is_on_the_line_again() -> None:
    row = svg_row((svg_name("m_1"), "g"))
    below, above = (float(dy) for dy in re.findall(r'dy="(-?[\d.]+)em"', row))
    small = float(re.search(r'font-size="(\d+)%"', row)[1]) / 100
    assert below * small + above == pytest.approx(0, abs=1e-2)
    assert svg_row(("m", "g")) == "mg"


def test_a_name_is_as_wide_as_its_letters() -> None:
    assert width("ill") < width("abc") < width("mmm")
    assert width(svg_name("m_1")) < width("m1")
