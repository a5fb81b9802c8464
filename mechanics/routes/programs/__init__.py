"""The four routes as programs: from a mechanism to rows that vanish along every motion.

free_body     differentiate --> rates of momenta of every body --> reactions eliminated
moving_point  chain         --> principles of free bodies that hold no reaction
kane          chain         --> partial velocities, projected
lagrange      differentiate --> derivatives of the Lagrangian
"""
