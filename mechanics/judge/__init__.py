"""A person's equations about a scene: read, judged, and blamed where they are wrong."""
