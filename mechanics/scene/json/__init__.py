"""Scenes as JSON and back: what they declare, expressions as trees of operations, no code."""

from mechanics.scene.json.read import from_json
from mechanics.scene.json.schema import schema
from mechanics.scene.json.write import to_json

__all__ = ["from_json", "schema", "to_json"]
