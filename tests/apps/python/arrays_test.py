"""Arrays of every kind go in: the numbers count, not how they lie in memory. What makes no sense is refused."""

import threading

import numpy as np
import pytest

import gnomon

UP = np.array([0.0, 0.0, 1.0])


def some_points(count: int, seed: int = 7) -> np.ndarray:
    print("seed", seed)
    points = np.random.default_rng(seed).uniform(-4, 4, (count, 3))
    points[:, 2] = 0
    return points


def test_every_layout_of_the_same_numbers_gets_the_same_answers(lamp_and_table):
    points = some_points(100)
    normals = np.tile(UP, (100, 1))
    wanted = lamp_and_table.irradiance(points, normals).irradiance
    wide = np.zeros((200, 7))
    wide[::2, 1:4] = points
    unaligned = np.frombuffer(b"x" + points.tobytes(), dtype=np.uint8)[1:].view(np.float64).reshape(100, 3)
    assert not unaligned.flags.aligned
    readonly = points.copy()
    readonly.flags.writeable = False
    layouts = {
        "columns first": np.asfortranarray(points),
        "strided": wide[::2, 1:4],
        "backwards": points[::-1].copy()[::-1],
        "big-endian": points.astype(">f8"),
        "unaligned": unaligned,
        "read only": readonly,
        "lists": points.tolist(),
        "tuples": tuple(map(tuple, points)),
    }
    for name, layout in layouts.items():
        found = lamp_and_table.irradiance(layout, np.broadcast_to(UP, (100, 3))).irradiance
        assert np.array_equal(found, wanted), name


def test_doubles_are_read_where_they_lie(lamp_and_table):
    points = some_points(10)
    assert lamp_and_table.regions(points).points is points
    assert lamp_and_table.regions(points[::2]).points.base is points


@pytest.mark.parametrize("dtype", [np.float32, np.float16, np.int8, np.uint16, np.int32, np.int64, np.uint64])
def test_other_numbers_become_equal_doubles(lamp_and_table, dtype):
    points = np.array([[1, 2, 0], [3, 1, 0], [0, 3, 1]], dtype=dtype)
    found = lamp_and_table.regions(points)
    assert np.array_equal(found.points, points.astype(float))
    assert np.array_equal(found.visible_fraction, lamp_and_table.regions(points.astype(float)).visible_fraction)


@pytest.mark.parametrize("empty", [np.zeros((0, 3)), [], np.zeros((0, 3), dtype=np.int32), np.zeros(0)])
def test_no_points_get_no_answers(lamp_and_table, empty):
    assert lamp_and_table.regions(empty).region.shape == (0, 1)
    assert lamp_and_table.irradiance(empty, empty).irradiance.shape == (0, 1)
    values, bounds = lamp_and_table.irradiance(empty, empty).total()
    assert values.shape == bounds.shape == (0,)


@pytest.mark.parametrize(
    ("points", "sentence"),
    [
        ([0, 0, 0], "points: found an array of shape (3,), expected shape (n, 3); one row alone is [[...]]"),
        ([[0, 0]], "points: found an array of shape (1, 2), expected shape (n, 3)"),
        (np.zeros((2, 3, 1)), "points: found an array of shape (2, 3, 1), expected shape (n, 3)"),
        (5, "points: found an array of shape (), expected shape (n, 3)"),
        ([[0, 0, 0], [0, float("nan"), 0]], "points: found nan in row 1, expected finite numbers"),
        ([[0, 0, float("inf")]], "points: found inf in row 0, expected finite numbers"),
        ([["a", "b", "c"]], "points: found an array of <U1, expected real numbers"),
        ([[1j, 0, 0]], "points: found an array of complex128, expected real numbers"),
        ([[True, False, True]], "points: found an array of bool, expected real numbers"),
        ([[None, 0, 0]], "points: found an array of object, expected real numbers"),
        ([[0, 0, 0], [0, 0]], "points: found what is no array, expected an array of numbers"),
        (np.zeros((1, 3), np.longdouble), "points: found an array of float128, expected numbers that doubles hold"),
        ([[2**53 + 1, 0, 0]], "points: found integers of 2^53 or more, expected numbers that doubles hold"),
        (np.ma.masked_array([[0.0, 0, 0]], mask=[[0, 1, 0]]), "points: found an array with masked numbers, expected numbers that are all there"),
        (None, "points: found an array of object, expected real numbers"),
    ],
)
def test_what_is_no_array_of_points_is_refused_in_a_sentence(lamp_and_table, points, sentence):
    with pytest.raises(gnomon.ArgumentError) as refusal:
        lamp_and_table.regions(points)
    assert str(refusal.value) == sentence
    assert isinstance(refusal.value, ValueError)


def test_normals_are_as_many_as_points_and_never_zero(lamp_and_table):
    with pytest.raises(gnomon.ArgumentError, match="normals: found 1 row, expected 2, as many as points"):
        lamp_and_table.irradiance([[0, 0, 0], [1, 0, 0]], [UP])
    with pytest.raises(gnomon.ArgumentError, match="normals: found zeros in row 1, expected a direction"):
        lamp_and_table.irradiance([[0, 0, 0], [1, 0, 0]], [UP, 0 * UP])


def test_threads_may_ask_the_same_scene_at_once(lamp_and_table):
    points, normals = some_points(2000), np.tile(UP, (2000, 1))
    wanted = lamp_and_table.irradiance(points, normals, threads=1)
    answers: list[gnomon.Irradiance] = []

    def ask() -> None:
        for _ in range(5):
            answers.append(lamp_and_table.irradiance(points, normals, threads=2))

    threads = [threading.Thread(target=ask) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len(answers) == 20
    for answer in answers:
        assert np.array_equal(answer.irradiance, wanted.irradiance)
        assert np.array_equal(answer.error_bound, wanted.error_bound)


def test_a_scene_may_grow_while_another_thread_asks_it(lamp_and_table):
    points = some_points(5000)
    wanted = lamp_and_table.regions(points).region
    answers: list[np.ndarray] = []
    asking = threading.Thread(target=lambda: answers.extend(lamp_and_table.regions(points).region for _ in range(20)))
    asking.start()
    for k in range(50):
        lamp_and_table.add_blocker(f"far {k}", [[90, 0, k], [91, 0, k], [90, 1, k]])
    asking.join()
    assert all(np.array_equal(answer, wanted) for answer in answers)
    assert len(lamp_and_table.blocker_names) == 51
