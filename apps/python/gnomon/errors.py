"""Errors, each named by its cause. Their sentences are those of the program gnomon."""


class Error(Exception):
    """Any error of this package."""


class ArgumentError(Error, ValueError):
    """An argument makes no sense: a wrong shape, a number that is not finite, a name that the scene does not have."""


class SceneError(Error, ValueError):
    """A scene is wrong; the sentence names file, place, element, what was found and what was expected."""


class UnsupportedError(Error):
    """What was asked for makes sense, but is not available."""


class SceneWarning(UserWarning):
    """A doubt about a scene, or a part of what was asked for that is left out; the sentence says which, and why."""
