"""Time and work against error on problems of published collections, beside other integrators."""
