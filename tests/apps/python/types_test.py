"""The stubs say what the module is, and the package and its tests are typed as mypy wants them."""

import ast
import os
import pathlib
import re
import subprocess
import sys
from collections.abc import Iterable

import gnomon
from gnomon import _gnomon

SOURCES = pathlib.Path(os.environ["GNOMON_PYTHON_SOURCES"])


def mypy(*arguments: str, folder: pathlib.Path) -> None:
    """Runs mypy with the package's sources on its path, its cache in a folder of the test's own."""
    environment = {**os.environ, "MYPYPATH": str(SOURCES.parent), "MYPY_CACHE_DIR": str(folder)}
    run = subprocess.run([sys.executable, *arguments], capture_output=True, text=True, check=False, env=environment, cwd=folder)
    assert run.returncode == 0, run.stdout + run.stderr


def test_the_package_passes_the_strict_checks_of_mypy(tmp_path):
    mypy("-m", "mypy", "--strict", "--python-version", "3.11", "-p", "gnomon", folder=tmp_path)


def public(names: Iterable[str]) -> set[str]:
    return {name for name in names if not name.startswith("_") or name == "__init__"}


def stubbed_classes() -> dict[str, dict[str, ast.FunctionDef]]:
    """The methods and properties of every class of the stubs."""
    tree = ast.parse((SOURCES / "_gnomon.pyi").read_text())
    return {
        node.name: {method.name: method for method in node.body if isinstance(method, ast.FunctionDef)}
        for node in tree.body
        if isinstance(node, ast.ClassDef)
    }


def told_parameters(doc: str) -> list[str]:
    """Names, with = where there is a default, from the signature in the first line of a method's docstring."""
    inside = re.sub(r"\[[^\]]*\]", "", doc.splitlines()[0].split("(", 1)[1].rsplit(")", 1)[0])
    return [re.sub(r":[^=]*", "", part).split("=")[0].strip() + ("=" if "=" in part else "") for part in inside.split(", ")]


def stubbed_parameters(method: ast.FunctionDef) -> list[str]:
    arguments = method.args
    plain = [a.arg for a in arguments.args]
    first_default = len(plain) - len(arguments.defaults)
    names = [name + ("=" if i >= first_default else "") for i, name in enumerate(plain)]
    if arguments.kwonlyargs:
        names.append("*")
    names += [a.arg + ("=" if d else "") for a, d in zip(arguments.kwonlyargs, arguments.kw_defaults)]
    return names + (["**" + arguments.kwarg.arg] if arguments.kwarg else [])


def test_the_stubs_have_the_classes_of_the_module_and_these_what_they_have():
    stubs = stubbed_classes()
    classes = {name: value for name, value in vars(_gnomon).items() if isinstance(value, type)}
    assert set(classes) == set(stubs)
    for name, value in classes.items():
        has_constructor = {"__init__"} if "__init__" in stubs[name] else set()
        assert public(vars(value)) - {"__init__"} | has_constructor == public(stubs[name]), name


def test_the_stubs_have_the_parameters_of_the_module():
    for name, methods in stubbed_classes().items():
        for method, node in methods.items():
            member = vars(getattr(_gnomon, name))[method]
            is_property = any(getattr(d, "id", "") == "property" for d in node.decorator_list)
            assert isinstance(member, property) == is_property, (name, method)
            if not is_property:
                doc = getattr(getattr(_gnomon, name), method).__doc__
                told = [p.replace("**kwargs", "**keys") for p in told_parameters(doc)]
                assert told == stubbed_parameters(node), (name, method)


def test_everything_public_says_what_it_is():
    for name in gnomon.__all__:
        if name != "__version__":
            value = getattr(gnomon, name)
            assert value.__doc__, name
            for member in public(vars(value)) - {"__init__"}:
                assert getattr(value, member).__doc__, (name, member)


def test_a_program_of_a_user_is_checked_by_the_stubs(tmp_path):
    good = "import gnomon\nscene = gnomon.Scene()\nn: int = scene.dimension\nscene.regions([[0, 0, 0]]).region.sum()\n"
    (tmp_path / "good.py").write_text(good)
    mypy("-m", "mypy", "--strict", "good.py", folder=tmp_path)
    (tmp_path / "bad.py").write_text(good + "scene.regions()\n")
    run = subprocess.run([sys.executable, "-m", "mypy", "bad.py"], capture_output=True, text=True, check=False, cwd=tmp_path,
                         env={**os.environ, "MYPYPATH": str(SOURCES.parent), "MYPY_CACHE_DIR": str(tmp_path)})
    assert 'Missing positional argument "points" in call to "regions"' in run.stdout
