"""C text as arithmetic: parsed by pycparser, evaluated over any numbers."""
