"""Whatever is handed in, the interpreter goes on: errors are exceptions of the kinds that are documented."""

import itertools

import numpy as np
import pytest

import gnomon

REFUSALS = (gnomon.Error, TypeError, ValueError, RecursionError, OverflowError, OSError)


class Endless:
    def tolist(self):
        return self


class Broken:
    def __array__(self, *arguments, **keys):
        raise KeyError("broken")

    def __len__(self):
        raise KeyError("broken")


def things() -> list[object]:
    endless_list: list[object] = []
    endless_list.append(endless_list)
    endless_dict: dict[str, object] = {}
    endless_dict["lights"] = [endless_dict]
    return [
        None, True, 0, -1, 2**70, 10**400, 1.5, float("nan"), float("inf"), 1j, "", "lamp", "\ud800", "a\0b", b"\xff", "x" * 10**5,
        [], [[]], [[[]]], {}, {"a": 1}, {1: 2}, set(), object(), Endless(), Broken(), endless_list, endless_dict, iter([]), int, print,
        np.zeros((0, 3)), np.zeros((3, 0)), np.zeros((2, 3)), np.full((2, 3), 1e308), np.full((2, 3), 5e-324), np.zeros(3)[::-1],
        np.array(None), np.array(["a"]), np.ma.masked_array(np.zeros((1, 3)), mask=True), np.zeros((1, 3), dtype="M8[s]"),
        np.zeros((1, 3), dtype=[("a", float)]), np.zeros((2, 2, 2)), np.broadcast_to(1.0, (4, 3)), [[1, 2, 3], [4, 5]],
        [[0, 0, 0], [1, 0, 0], [0, 1, 0]], memoryview(b"abc"), range(3),
    ]  # fmt: skip


def survives(call, *arguments, **keys) -> None:
    try:
        call(*arguments, **keys)
    except REFUSALS:
        pass


@pytest.mark.parametrize("kind", ["add_light", "add_blocker", "add_receiver"])
def test_elements_of_anything_are_added_or_refused(kind):
    for first, second in itertools.product(things(), things()):
        scene = gnomon.Scene()
        survives(getattr(scene, kind), "a", first, second)
        survives(getattr(scene, kind), first, second)
        survives(getattr(scene, kind), "b", [[0, 0, 0], [1, 0, 0], [0, 1, 0]], shape=first, radiance=second)
        survives(getattr(scene, kind), "c", **{"position": first, "vertices": second})
        survives(scene.regions, [[0, 0, 0.5]])


def test_points_of_anything_are_answered_or_refused(lamp_and_table):
    for first, second in itertools.product(things(), things()):
        survives(lamp_and_table.regions, first, second)
        survives(lamp_and_table.irradiance, first, second)
        survives(lamp_and_table.radiance, first, second, first)
        survives(lamp_and_table.radiance, [[0, 0, 0]], first, second)


def test_other_questions_of_anything_are_answered_or_refused(lamp_and_table):
    pair = lamp_and_table.pair("lamp", "table")
    for thing in things():
        survives(gnomon.Scene.read, thing)
        survives(gnomon.Scene.from_dict, thing)
        survives(gnomon.Scene.from_dict, {"gnomon": 1, "dimension": 3, "lights": thing, "blockers": thing})
        survives(gnomon.Scene.from_dict, {"gnomon": 1, "dimension": thing, "lights": [], "blockers": []})
        survives(gnomon.Scene.from_dict, lamp_and_table.to_dict(), thing)
        survives(gnomon.Scene, thing)
        survives(gnomon.Scene, 2, thing)
        survives(lamp_and_table.pair, thing, thing)
        survives(pair.volume, "umbra", thing)
        survives(pair.volume, thing)
        survives(pair.sides, thing)
        survives(lamp_and_table.place, thing)
        survives(lamp_and_table.place, {"gnomon_goals": 1, "variable": thing, "goals": thing})
        survives(lamp_and_table.receivers, thing)
        survives(lamp_and_table.receivers, light=thing)
        survives(lamp_and_table.view_factors, bound=thing)
        survives(lamp_and_table.illuminate, tolerance=thing, relative=0.5)
        survives(lamp_and_table.partition, box=thing)
        survives(gnomon.Scene(2).regions, thing)


def test_more_threads_than_the_program_takes_are_refused(lamp_and_table):
    for ask in (lambda: lamp_and_table.regions([[0, 0, 0]], threads=1025), lambda: lamp_and_table.receivers(threads=10**6),
                lambda: lamp_and_table.illuminate(threads=2000), lambda: lamp_and_table.view_factors(threads=2000)):
        with pytest.raises(gnomon.ArgumentError, match="threads: found .*, expected 1 to 1024, or 0"):
            ask()
