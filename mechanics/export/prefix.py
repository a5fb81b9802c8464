"""The name of a folder's library, which begins the names of its files, functions and macros.

It has to be free in C, and nothing that a build would find in place of ours: NAME.h must not hide a
header of the C or C++ library, libNAME no library of the system, and NAME no target of CMake.
"""

from mechanics.compiled import Model
from mechanics.compiled.c.names import identifier
from mechanics.errors import InputError

_HEADERS = """
    assert complex ctype errno fenv float inttypes iso646 limits locale math setjmp signal stdalign
    stdarg stdatomic stdbool stddef stdint stdio stdlib stdnoreturn string tgmath threads time uchar
    wchar wctype algorithm any array atomic barrier bit bitset chrono codecvt compare concepts
    coroutine deque exception execution filesystem format forward_list fstream functional future
    generator initializer_list iomanip ios iosfwd iostream istream iterator latch limits list map
    memory mutex new numbers numeric optional ostream print queue random ranges ratio regex scoped
    semaphore set span sstream stack stdexcept streambuf string string_view thread tuple
    typeindex typeinfo unordered_map unordered_set utility valarray variant vector version features
    pthread unistd strings memory malloc sched poll termios windows
"""
_LIBRARIES = "c m dl rt gcc gcc_s stdc gomp pthread util crypt resolv nosys rdimon"
_TARGETS = "all test help clean depend install package edit_cache rebuild_cache experimental zero"
TAKEN = frozenset(f"{_HEADERS} {_LIBRARIES} {_TARGETS}".split())


def chosen_prefix(model: Model, name: str | None) -> str:
    """The name that was asked for, or one made of the scene's.

    Raises
    ------
    InputError
        If the name that was asked for cannot be used; one that could is said.
    """
    wanted = model.equations.scene.name if name is None else name
    free = free_prefix(wanted)
    if name in (None, free):
        return free
    if wanted.lower() in TAKEN:
        raise InputError(
            f"name {name!r} hides a header, a library or a target of CMake: {free!r} would not"
        )
    raise InputError(f"name {name!r} is no C identifier that is free: {free!r} would be one")


def free_prefix(text: str) -> str:
    """An identifier that resembles the text and hides nothing.

    Names of the library's own functions are fine: a prefix stands in front of another word. An
    underscore at the end would meet the next one, and two belong to C++.
    """
    found = identifier(text).strip("_")
    return f"{found}_system" if found.lower() in TAKEN or identifier(found) != found else found
