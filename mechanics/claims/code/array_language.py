r"""Arrays as MATLAB and Julia have them: what code that is printed as Python calls.

    a*b, a\b, A^-1     matrices        a(2, :) = b     grows        [a; b]     blocks

A column is an array of one dimension, a row one of shape (1, n), a number no array.
"""

from typing import Any

import numpy as np

from mechanics.claims.code.translation.python_page import EXACT, LONGEST

ALL = slice(None)
LARGEST = 4096
"""Entries of an array, and an exponent."""


def tidy(a: Any) -> Any:
    """A column as one dimension, one entry as a number."""
    if not isinstance(a, np.ndarray):
        return a
    if a.size == 1:
        return a.flat[0]
    return a[:, 0] if a.ndim == 2 and a.shape[1] == 1 else a


def table(a: Any) -> Any:
    """A matrix of two dimensions."""
    array = np.asarray(a, dtype=object)
    return array.reshape(1, 1) if array.ndim == 0 else array.reshape(array.shape[0], -1)


def exact(a: Any) -> Any:
    """What is computed of integers, which Python has of any size and a double has not.

    Raises
    ------
    ValueError
    """
    for one in np.ravel(a):
        if (
            not isinstance(one, float)
            and isinstance(one, int | np.integer)
            and abs(int(one)) > EXACT
        ):
            raise ValueError(f"{one} is more than a double holds exactly: write it with a point")
    return a


def each_one(*values: Any) -> None:
    """Refuse several values where a formula has one.

    Raises
    ------
    ValueError
    """
    if any(isinstance(value, tuple | list) for value in values):
        raise ValueError("several values stand where a formula has one")


def times(a: Any, b: Any) -> Any:
    """a*b"""
    each_one(a, b)
    if not (isinstance(a, np.ndarray) and isinstance(b, np.ndarray)):
        return exact(a * b)
    return exact(tidy(table(a) @ table(b)))


def same_shape(a: Any, b: Any) -> tuple[Any, Any]:
    """Two things that are added, or combined entry by entry."""
    each_one(a, b)
    if isinstance(a, np.ndarray) and isinstance(b, np.ndarray) and a.shape != b.shape:
        raise ValueError(f"arrays of shapes {table(a).shape} and {table(b).shape} are combined")
    return a, b


def plus(a: Any, b: Any) -> Any:
    """a + b"""
    a, b = same_shape(a, b)
    return exact(a + b)


def minus(a: Any, b: Any) -> Any:
    """a - b"""
    a, b = same_shape(a, b)
    return exact(a - b)


def each_times(a: Any, b: Any) -> Any:
    """a .* b"""
    a, b = same_shape(a, b)
    return exact(a * b)


def each_over(a: Any, b: Any) -> Any:
    """a ./ b"""
    a, b = same_shape(a, b)
    return a / b


def each_power(a: Any, b: Any) -> Any:
    """a .^ b"""
    a, b = same_shape(a, b)
    return exact(a**b) if isinstance(a, np.ndarray) else power(a, b)


def transposed(a: Any) -> Any:
    """a'"""
    return tidy(table(a).T) if isinstance(a, np.ndarray) else a


def block(*rows: tuple[Any, ...]) -> Any:
    """[a b; c d]"""
    beside = [
        _concatenated(parts, 1)
        for row in rows
        if (parts := [table(part) for part in row if np.size(part)])
    ]
    return tidy(_concatenated(beside, 0)) if beside else np.zeros((0, 0), dtype=object)


def _concatenated(parts: list[Any], axis: int) -> Any:
    """Matrices side by side, or one below the other.

    Raises
    ------
    ValueError
        Where their sizes do not fit.
    """
    sizes = [part.shape[1 - axis] for part in parts]
    if len({*sizes}) > 1:
        what, many = ("rows", "entries") if axis == 0 else ("parts of a row", "rows")
        raise ValueError(
            f"{what} of a matrix have {' and '.join(map(str, dict.fromkeys(sizes)))} {many}: a"
            " blank before a sign, as in [a -b], makes two entries"
        )
    return np.concatenate(parts, axis=axis)


def places(index: Any, size: int) -> list[int]:
    """Places from 0 of an index from 1."""
    if isinstance(index, slice):
        return list(range(size))
    if any(isinstance(k, bool | np.bool_) for k in np.ravel(index)):
        raise ValueError("an index that is true or false is not read")
    found = [int(k) - 1 for k in np.ravel(index)]
    if any(place != k - 1 for place, k in zip(found, np.ravel(index), strict=True)):
        raise ValueError(f"index {index} is no integer")
    if any(k < 0 for k in found):
        raise ValueError(f"index {min(found) + 1} is below 1")
    return found


def size(a: Any, axis: int, indices: int) -> int:
    """What `end` is at this place of so many indices."""
    return int(np.size(a) if indices == 1 else table(a).shape[axis])


def length(a: Any) -> int:
    """How many rows or columns there are, whichever are more."""
    return max(table(a).shape) if np.size(a) else 0


def numel(a: Any) -> int:
    """How many entries there are."""
    return int(np.size(a))


def get(a: Any, *indices: Any) -> Any:
    """a(2), a(1:2), a(2, :)"""
    array = table(a)
    if len(indices) == 2:
        rows, columns = (places(i, n) for i, n in zip(indices, array.shape, strict=True))
        return tidy(array[np.ix_(rows, columns)])
    wanted = places(indices[0], array.size)
    if wanted and max(wanted) >= array.size:
        raise ValueError(f"entry {max(wanted) + 1} of an array of {array.size} is read")
    flat = array.ravel(order="F")[wanted]
    row = array.shape[0] == 1 and not isinstance(indices[0], slice)
    return tidy(flat.reshape(1, -1) if row else flat)


def segment(a: Any, start: Any, count: Any) -> Any:
    """a.segment(1, 2) of Eigen: a part of a row or column, by its first place from 0."""
    array = table(a)
    if min(array.shape) > 1 or start < 0 or count < 1 or start + count > array.size:
        raise ValueError(f"{count} entries from {start} of an array of shape {array.shape}")
    return array.ravel()[start : start + count]


def exactly(a: Any, count: int) -> Any:
    """A part of so many entries, which Python's slices may have fewer of."""
    if np.size(a) != count:
        raise ValueError(
            f"a part of {count} entries of an array that has no more than {np.size(a)}"
        )
    return a


def laid(a: Any, value: Any, start: Any, count: Any, unset: float = np.nan) -> Any:
    """The array of Eigen after a.segment(1, 2) = value"""
    values = np.ravel(value)
    if len(values) != count:
        raise ValueError(f"{len(values)} numbers for {count} entries")
    for place, one in enumerate(values, start + 1):
        a = put(a, one, place, unset=unset)
    return a


def lay(a: Any, value: Any, *indices: Any) -> Any:
    """The array of C++ after a[2] = value: others have no value before they are set."""
    return put(a, value, *indices, unset=np.nan)


def put(a: Any, value: Any, *indices: Any, unset: float = 0) -> Any:
    """The array after a(2) = value"""
    if isinstance(a, bool):
        raise ValueError("entries of what is true or false are not set")
    array = np.zeros((0, 0), dtype=object) if a is None else table(a)
    if len(indices) == 1:
        single = places(indices[0], array.size)
        if min(array.shape) > 1:
            rows = [k % array.shape[0] for k in single]
            columns = [k // array.shape[0] for k in single]
        elif array.shape[1] == 1 and array.shape[0] > 1:
            rows, columns = single, [0] * len(single)
        else:
            rows, columns = [0] * len(single), single
        grown = _grown(array, max(rows, default=0) + 1, max(columns, default=0) + 1, unset)
        grown[rows, columns] = np.ravel(value) if isinstance(value, np.ndarray) else value
        return _kept(grown)
    lengths = list(array.shape)
    for axis, index in enumerate(indices):
        if isinstance(index, slice) and not array.size:  # x(1, :) = 2 of what is not there yet
            lengths[axis] = 1
    rows, columns = (places(i, n) for i, n in zip(indices, lengths, strict=True))
    grown = _grown(array, max(rows) + 1, max(columns) + 1, unset)
    if isinstance(value, np.ndarray):
        value = value.reshape(len(rows), len(columns))
    grown[np.ix_(rows, columns)] = value
    return _kept(grown)


def _grown(array: Any, rows: int, columns: int, unset: float) -> Any:
    shape = max(rows, array.shape[0]), max(columns, array.shape[1])
    found = np.full(shape, unset, dtype=object)
    found[: array.shape[0], : array.shape[1]] = array
    return found


def _kept(array: Any) -> Any:
    """An array that is filled stays one."""
    return array[:, 0] if array.shape[1] == 1 else array


def zeros(*shape: Any) -> Any:
    """zeros(2), zeros(2, 1)"""
    return filled(0, *shape)


def filled(number: int, *shape: Any) -> Any:
    """An array of equal numbers."""
    rows, columns = (int(shape[0]), int(shape[-1])) if shape else (1, 1)
    if rows * columns > LARGEST:
        raise ValueError(f"an array of {rows} x {columns}: {LARGEST} entries at most")
    return number if not shape else _kept(np.full((rows, columns), number, dtype=object))


def ones(*shape: Any) -> Any:
    """ones(2, 1)"""
    return filled(1, *shape)


def eye(rows: Any, columns: Any = None) -> Any:
    """eye(2)"""
    return np.eye(int(rows), int(columns or rows), dtype=int).astype(object)


def diag(a: Any) -> Any:
    """diag([a b])"""
    array = table(a)
    return np.diag(array.ravel()) if 1 in array.shape else np.diag(array)


def total(a: Any, axis: Any = None) -> Any:
    """sum(a), sum(a, 2)"""
    array = table(a)
    way = 0 if array.shape[0] > 1 else 1
    return tidy(array.sum(axis=way if axis is None else int(axis) - 1, keepdims=True))


def of_vectors(*arrays: Any) -> list[Any]:
    """Rows and columns; MATLAB takes matrices otherwise than NumPy."""
    if any(min(table(a).shape) > 1 for a in arrays):
        raise ValueError("a product or norm of matrices is not read")
    return [np.ravel(a) for a in arrays]


def dot(a: Any, b: Any) -> Any:
    """dot(a, b)"""
    return np.dot(*of_vectors(a, b))


def cross(a: Any, b: Any) -> Any:
    """cross(a, b)"""
    return np.cross(*of_vectors(a, b))


def norm(a: Any) -> Any:
    """norm(a)"""
    return np.linalg.norm(*of_vectors(a))


def vector(a: Any) -> Any:
    """What is returned: a row as a column."""
    return a.ravel() if isinstance(a, np.ndarray) and 1 in a.shape else a


def record(values: Any, *names: str) -> Any:
    """What a structure of C++ has, by the names of its fields; other things as they are."""
    plain = isinstance(values, tuple | list | np.ndarray) and len(values) == len(names) > 1
    return dict(zip(names, values, strict=True)) if plain else values


def array(entries: list[Any]) -> Any:
    """Julia's [a, b], of numbers."""
    if any(isinstance(entry, np.ndarray) for entry in entries):
        raise ValueError("an array of arrays is not read")
    found = np.empty(len(entries), dtype=object)
    found[:] = entries
    return found


def single(value: Any) -> Any:
    """A number, whose sine is no matrix's."""
    if isinstance(value, np.ndarray):
        raise ValueError("a function of a whole array is not read: write a dot behind its name")
    return value


def whole(value: Any) -> Any:
    """All entries of an array that is there, as another one has them."""
    if not isinstance(value, np.ndarray):
        raise ValueError("one number for all entries of an array is not read")
    return value.copy()


def over(a: Any, b: Any) -> Any:
    """a/b"""
    each_one(a, b)
    if isinstance(b, np.ndarray):
        return transposed(under(transposed(b), transposed(a)))
    return a / b


def under(a: Any, b: Any) -> Any:
    r"""a\b"""
    each_one(a, b)
    return tidy(np.linalg.solve(numbers(a), numbers(b))) if isinstance(a, np.ndarray) else b / a


def numbers(a: Any) -> Any:
    """An array of numbers as NumPy solves with; others as they are."""
    plain = all(isinstance(entry, int | float | np.number) for entry in np.ravel(a))
    return np.asarray(a, dtype=float) if plain else a


def determinant(a: Any) -> Any:
    """det(a)"""
    return np.linalg.det(numbers(a)) if isinstance(a, np.ndarray) else a


def inverse(a: Any) -> Any:
    """inv(a)"""
    return np.linalg.inv(numbers(a)) if isinstance(a, np.ndarray) else 1 / a


def power(a: Any, b: Any) -> Any:
    """a^b"""
    each_one(a, b)
    if isinstance(b, int | float) and abs(b) > LARGEST:
        raise ValueError(f"an exponent of {b}: {LARGEST} at most")
    if isinstance(b, np.ndarray):
        raise ValueError("a power whose exponent is an array is not read")
    if not isinstance(a, np.ndarray):
        return exact(a**b)
    if b != int(b) or b == 0:
        raise ValueError(f"a matrix to the power of {b} is not read")
    one = inverse(a) if b < 0 else a
    found = one
    for _ in range(abs(int(b)) - 1):
        found = times(found, one)
    return found


def refuse_reals(*numbers: Any) -> None:
    """Refuse integers of C++ that stand for parameters, which are real numbers.

    Raises
    ------
    ValueError
    """
    if any(isinstance(number, float) for number in numbers):
        raise ValueError(
            "an integer of the code stands for a parameter, a real number, and C++ computes with"
            " it as with integers: write it with a point, as 4.0"
        )


def quotient(a: Any, b: Any) -> Any:
    """a / b of integers, towards zero."""
    refuse_reals(a, b)
    found = abs(a) // abs(b)
    return found if (a < 0) == (b < 0) else -found


def held(a: Any, what: str, low: int, high: int) -> Any:
    """An integer of C++, or an array of these, where one of this kind is kept or computed.

    Parameters
    ----------
    a : number or array
    what : str
        Its name and kind.
    low, high : int
        The numbers of that kind.

    Raises
    ------
    ValueError
        For another number: C++ makes one of the kind of it, or leaves open what happens.
    """
    for one in np.ravel(a):
        refuse_reals(one)
        if not isinstance(one, int | np.integer | np.bool_):
            raise ValueError(f"{what}: its value is not known: write it as double")
        if not low <= one <= high:
            raise ValueError(f"{what}: {one} does not fit: write it as double")
    return a


def steps(first: Any, step: Any, last: Any) -> list[Any]:
    """first:step:last"""
    count = int(np.floor((last - first) / step + 1e-10)) + 1
    if count > LONGEST:
        raise ValueError(f"a loop of {count} turns: {LONGEST} at most")
    return [first + k * step for k in range(count)]
