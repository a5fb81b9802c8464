"""Recursions over the trees of frames and points of a mechanism.

pseudo_inertia     masses and inertias, grouped over the joints
newton_euler       inverse dynamics, rows power-conjugate to u
"""
