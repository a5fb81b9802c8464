"""Reports: what a cross-check found, as JSON and as HTML."""
