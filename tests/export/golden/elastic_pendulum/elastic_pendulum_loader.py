# What was generated.
NAME = "elastic_pendulum"
PREFIXES = {"double": "elastic_pendulum"}
ARRAYS = {
    "q": (("x", "m", ""), ("theta", "rad", "")),
    "u": (("x_dot", "m/s", ""), ("theta_dot", "rad/s", "")),
    "ud": (("x_ddot", "m/s^2", ""), ("theta_ddot", "rad/s^2", "")),
    "inputs": (),
    "p": (
        ("L", "m", "length of the pendulum"),
        ("M", "kg", "mass of the pendulum"),
        ("g", "m/s^2", "acceleration of gravity"),
        ("k", "N/m", "stiffness of each of the two springs"),
        ("m", "kg", "mass of the carriage"),
    ),
    "c": (
        ("M", "kg", "mass of the pendulum"),
        ("g", "m/s^2", "acceleration of gravity"),
        ("c2", "", "made of parameters"),
        ("c3", "", "made of parameters"),
        ("c4", "", "made of parameters"),
        ("c5", "", "made of parameters"),
    ),
    "multipliers": (),
    "reactions": (("T", "N", ""), ("N", "N", ""), ("N1", "N", "")),
    "h": (("h", "s", "length of the step"),),
}
TYPICAL = {"L": 1.0, "M": 1.0, "g": 9.81, "k": 10.0, "m": 1.0}
FUNCTIONS = {
    "forward_dynamics": ((("q", 2), ("u", 2), ("p", 5)), (("ud", (2,)),)),
    "mass_matrix": ((("q", 2), ("u", 2), ("p", 5)), (("mass_matrix", (2, 2)),)),
    "forcing": ((("q", 2), ("u", 2), ("p", 5)), (("forcing", (2,)),)),
    "residual": ((("q", 2), ("u", 2), ("p", 5), ("ud", 2)), (("residual", (2,)),)),
    "inverse_dynamics": ((("q", 2), ("u", 2), ("p", 5), ("ud", 2)), (("forces", (2,)),)),
    "energy": (
        (("q", 2), ("u", 2), ("p", 5)),
        (("kinetic", (1,)), ("potential", (1,)), ("total", (1,))),
    ),
    "momenta": (
        (("q", 2), ("u", 2), ("p", 5)),
        (("linear", (3,)), ("angular", (3,)), ("generalized", (2,))),
    ),
    "coordinate_rates": ((("q", 2), ("u", 2), ("p", 5)), (("qd", (2,)),)),
    "jacobians": (
        (("q", 2), ("u", 2), ("p", 5)),
        (("ud_q", (2, 2)), ("ud_u", (2, 2)), ("ud_p", (2, 5))),
    ),
    "step": (
        (("q", 2), ("u", 2), ("p", 5), ("h", 1)),
        (("q_next", (2,)), ("u_next", (2,))),
    ),
    "reactions": ((("q", 2), ("u", 2), ("p", 5)), (("reactions", (3,)),)),
    "prepare": ((("p", 5),), (("c", (6,)),)),
    "forward_dynamics_prepared": ((("q", 2), ("u", 2), ("c", 6)), (("ud", (2,)),)),
}
BATCH = ("forward_dynamics", "energy", "coordinate_rates")
SOURCES = {"double": ("elastic_pendulum.c", "elastic_pendulum_batch.c")}
# End of what was generated.
