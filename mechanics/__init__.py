"""Cross-check engine for equations of motion."""
