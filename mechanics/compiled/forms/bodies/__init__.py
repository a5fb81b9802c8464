"""Forward dynamics from the bodies of a scene themselves, by Gauss's principle."""
