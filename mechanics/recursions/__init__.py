"""Recursions over the trees of frames and points of a mechanism.

pseudo_inertia      masses and inertias, grouped over the joints
newton_euler        inverse dynamics of any mechanism: rows power-conjugate to u
joints              a mechanism as a tree of joints with one freedom each
composite_bodies    its mass matrix
articulated_bodies  its forward dynamics
local_equations     derivatives of its forward dynamics
"""
