"""What a Python function takes from around itself: numbers, objects, what was kept."""
