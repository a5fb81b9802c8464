"""Laws on the tree itself: what DESIGN says about files, checked file by file.

A law is a function from the syntax tree of one file to its breaches, as ``(line, message)``, so
that each law can also be shown a breach and seen to find it.
"""

import ast
import functools
import importlib.metadata
import io
import os
import re
import shutil
import subprocess
import sys
import tokenize
import tomllib
from collections.abc import Callable, Iterable, Iterator, Mapping
from graphlib import CycleError, TopologicalSorter
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[1]
PACKAGES = ("mechanics", "systems")
TOP_LEVEL = {
    "CHANGELOG.md",
    "LICENSE",
    "README.md",
    "benchmarks",
    "docs",
    "mechanics",
    "pyproject.toml",
    "systems",
    "tests",
}
Breaches = Iterator[tuple[int, str]]


def files(*folders: str, suffix: str = "") -> list[Path]:
    """Files below the folders, without what Python leaves behind."""
    return sorted(
        path
        for folder in folders
        for path in (ROOT / folder).rglob(f"*{suffix}")
        if path.is_file() and "__pycache__" not in path.parts
    )


def breaches(law: Callable[[ast.Module], Breaches], paths: Iterable[Path]) -> list[str]:
    """What the law finds in the files, as ``path:line: message``."""
    return [
        f"{path.relative_to(ROOT)}:{line}: {message}"
        for path in paths
        for line, message in law(parsed(path))
    ]


@functools.cache
def parsed(path: Path) -> ast.Module:
    """Syntax tree of a file."""
    return ast.parse(path.read_text(encoding="utf-8"), str(path))


@functools.cache
def nodes(tree: ast.Module) -> tuple[ast.AST, ...]:
    """All nodes of a file: most laws look at each."""
    return tuple(ast.walk(tree))


def called_name(call: ast.Call) -> str:
    """Last name of what is called: ``raises`` for ``pytest.raises(...)``."""
    match call.func:
        case ast.Name(id=name) | ast.Attribute(attr=name):
            return name
    return ""


def without_docstring(tree: ast.Module) -> Breaches:
    if not ast.get_docstring(tree):
        yield 1, "the module has no docstring"


def simplifies(tree: ast.Module) -> Breaches:
    for node in nodes(tree):
        if isinstance(node, ast.Call) and called_name(node) in {"simplify", "trigsimp"}:
            yield node.lineno, f"{called_name(node)} is no proof; use mechanics.symbolic"
        if isinstance(node, ast.ImportFrom):
            for alias in node.names:
                if alias.name in {"simplify", "trigsimp"}:
                    yield node.lineno, f"{alias.name} is no proof; use mechanics.symbolic"


def swallows_errors(tree: ast.Module) -> Breaches:
    for node in nodes(tree):
        if not isinstance(node, ast.ExceptHandler):
            continue
        if node.type is None:
            yield node.lineno, "bare except; name the exceptions that are expected"
            continue
        if isinstance(node.body[-1], ast.Raise):
            continue  # whatever a person's own file raises becomes an error of ours: not swallowed
        caught = node.type.elts if isinstance(node.type, ast.Tuple) else [node.type]
        for exception in caught:
            if ast.unparse(exception) in {"Exception", "BaseException"}:
                yield (
                    node.lineno,
                    f"except {ast.unparse(exception)}; name the exceptions that are expected",
                )


def runs_text(tree: ast.Module) -> Breaches:
    """Calls that turn text into code; `sympify` does unless it is strict."""
    names = {"eval", "exec", "compile", "__import__", "lambdify", "parse_expr", "parse_latex"}
    shells = {"system", "popen", "Popen", "check_output", "check_call", "import_module"}
    for node in nodes(tree):
        if not isinstance(node, ast.Call):
            continue
        plain = isinstance(node.func, ast.Name) or ast.unparse(node.func).startswith("sympy.")
        name = called_name(node)
        strict = any(k.arg == "strict" for k in node.keywords)
        if name in shells or (name in names and plain):
            yield node.lineno, f"{name}: what a person gives is read, never run"
        if name == "sympify" and not strict:
            yield node.lineno, "sympify without strict=True evaluates text"


def makes_verdicts(tree: ast.Module) -> Breaches:
    """Findings made by hand, and verdicts changed afterwards."""
    for node in nodes(tree):
        if isinstance(node, ast.ImportFrom | ast.Import):
            for alias in node.names:
                if alias.name in MADE_BY_THE_KERNEL and alias.asname:
                    yield node.lineno, f"{alias.name} has another name; only the kernel makes one"
        if not isinstance(node, ast.Call):
            continue
        if called_name(node) in MADE_BY_THE_KERNEL:
            words = f"only mechanics.kernel makes a {called_name(node)}"
            yield node.lineno, f"{words}: give one of its functions both sides"
        sides = [ast.unparse(side) for side in node.args[1:3]]
        if called_name(node) == "same" and len(sides) == 2 and sides[0] == sides[1]:
            yield node.lineno, "same compares a thing with itself: give both sides"
        if called_name(node) == "replace" and node.args:
            fixed = FIXED | SIDES if "witness" in ast.unparse(node.args[0]) else FIXED
            if fixed & {k.arg for k in node.keywords}:
                yield node.lineno, "a verdict stays: mechanics.kernel makes another finding"


def keeps_objects(tree: ast.Module) -> Breaches:
    """Caches by a scene, equations or a model: state of the module that no caller sees."""
    for node in nodes(tree):
        if isinstance(node, ast.ImportFrom | ast.Import):
            for alias in node.names:
                if alias.name == "WeakKeyDictionary":
                    yield node.lineno, "WeakKeyDictionary: what is made once is handed on"
        if isinstance(node, ast.Assign | ast.AnnAssign) and node in tree.body and is_empty(node):
            names = ast.unparse(node.targets[0] if isinstance(node, ast.Assign) else node.target)
            if not names.isupper():
                yield node.lineno, f"{names} is filled by calls: hand on what is made once"
        if not isinstance(node, ast.FunctionDef):
            continue
        decorators = {ast.unparse(one).partition("(")[0] for one in node.decorator_list}
        arguments = [*node.args.posonlyargs, *node.args.args, *node.args.kwonlyargs]
        annotations = {ast.unparse(a.annotation) for a in arguments if a.annotation is not None}
        kept = {name for text in annotations for name in re.findall(r"\w+", text)} & OBJECTS
        if kept and {name.rpartition(".")[2] for name in decorators} & {"cache", "lru_cache"}:
            yield node.lineno, f"{node.name} is kept by {', '.join(sorted(kept))}: hand it on"


def is_empty(node: ast.Assign | ast.AnnAssign) -> bool:
    """Whether a name begins as an empty table or list."""
    value = node.value
    if isinstance(value, ast.Call):
        return called_name(value) in {"dict", "list", "set"} and not value.args
    return isinstance(value, ast.Dict | ast.List) and ast.unparse(value) in {"{}", "[]"}


OBJECTS = {
    "Candidate", "Case", "ConstraintManifold", "Derivation", "Derived", "Equations", "Graphs",
    "Kinematics", "Mechanism", "Model", "Physics", "Problem", "Reference", "Scene", "System",
    "View",
}  # fmt: skip
"""Data of mechanics with an identity; texts, numbers and programs are compared by value."""

MADE_BY_THE_KERNEL = {"Finding", "Witness", "Gap"}
FIXED, SIDES = {"verdict", "error_bound"}, {"left", "right"}
"""What `dataclasses.replace` may not change in findings, and besides in witnesses."""


def asserts_nothing(tree: ast.Module) -> Breaches:
    for node in nodes(tree):
        if not isinstance(node, ast.FunctionDef) or not node.name.startswith("test"):
            continue
        if not any(is_expectation(part) for part in ast.walk(node)):
            yield node.lineno, f"{node.name} asserts nothing"


def is_expectation(node: ast.AST) -> bool:
    """An assert statement, pytest.raises and the like, or a helper named assert_..."""
    if isinstance(node, ast.Call):
        name = called_name(node)
        return name in {"raises", "warns", "fail"} or name.startswith("assert_")
    return isinstance(node, ast.Assert)


def undeclared_imports(tree: ast.Module) -> Breaches:
    """Imports of packages that pyproject.toml does not install: they work by accident."""
    for node in nodes(tree):
        match node:
            case ast.Import(names=aliases):
                imported = [alias.name for alias in aliases]
            case ast.ImportFrom(module=str(module), level=0):
                imported = [module]
            case _:
                continue
        for package in (name.partition(".")[0] for name in imported):
            if not is_installed_by_us(package):
                yield node.lineno, f"{package} is not among the dependencies in pyproject.toml"


def is_installed_by_us(package: str) -> bool:
    if package in sys.stdlib_module_names or package in PACKAGES:
        return True
    providers = distributions().get(package, [package])
    return not declared_dependencies().isdisjoint(map(canonical, providers))


@functools.cache
def distributions() -> Mapping[str, list[str]]:
    """Distributions by the name that they are imported under: flint comes from python-flint."""
    return importlib.metadata.packages_distributions()


def canonical(distribution: str) -> str:
    return re.sub(r"[-_.]+", "-", distribution).lower()


@functools.cache
def declared_dependencies() -> set[str]:
    """Core dependencies, and the extras that users can ask for."""
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    extras = project["optional-dependencies"]
    requirements = project["dependencies"] + extras["parquet"] + extras["taylor"]
    requirements += extras["control"] + extras["gif"] + extras["mujoco"] + extras["cluster"]
    return {canonical(re.split(r"[^\w.-]", requirement)[0]) for requirement in requirements}


def test_every_module_has_a_docstring() -> None:
    assert breaches(without_docstring, files(*PACKAGES, suffix=".py")) == []


def test_nothing_is_simplified_instead_of_proved() -> None:
    assert breaches(simplifies, files("mechanics", suffix=".py")) == []


def test_no_error_is_swallowed() -> None:
    assert breaches(swallows_errors, files(*PACKAGES, suffix=".py")) == []


def test_what_a_person_gives_is_never_run() -> None:
    readers = files("mechanics/claims", "mechanics/program/c", suffix=".py")
    # What one compiles is printed by us, from nodes of a tree that are known one by one; what the
    # other does is a function that a person passes, which is called.
    code = ROOT / "mechanics" / "claims" / "code"
    ours = (code / "translation" / "python_page.py", code / "python" / "local_numbers.py")
    assert breaches(runs_text, [path for path in readers if path not in ours]) == []


def test_only_the_kernel_makes_findings() -> None:
    kernel = set(files("mechanics/kernel", suffix=".py"))
    others = [path for path in files(*PACKAGES, suffix=".py") if path not in kernel]
    assert breaches(makes_verdicts, others) == []


def test_no_module_keeps_what_it_was_asked_for() -> None:
    assert breaches(keeps_objects, files(*PACKAGES, suffix=".py")) == []


LINES_OF_A_VERDICT, CODE_OF_A_VERDICT = 6389, 3999
"""At most 4,000 of code: whoever makes it less writes the figures here and in docs/evidence.md."""


def path_of(module: str) -> Path:
    """The file of a module, or where it would be."""
    path = ROOT.joinpath(*module.split("."))
    return path / "__init__.py" if path.is_dir() else path.with_suffix(".py")


def imported(*modules: str) -> set[str]:
    """Modules of `mechanics`, and all that they import from there; the lazy package apart."""
    known, waiting = set[str](), list(modules)
    while waiting:
        name = waiting.pop()
        if name in known or name == "mechanics" or not path_of(name).exists():
            continue
        known.add(name)
        for node in nodes(parsed(path_of(name))):
            if isinstance(node, ast.ImportFrom) and (node.module or "").startswith("mechanics"):
                waiting += [str(node.module), *(f"{node.module}.{a.name}" for a in node.names)]
    return known


def test_what_a_verdict_executes_does_not_grow() -> None:
    """All lines, of the kernel and of what it imports of the program and of errors."""
    own = {path.stem for path in files("mechanics/kernel", suffix=".py")} - {"__init__"}
    names = imported("mechanics.kernel", *(f"mechanics.kernel.{name}" for name in own))
    assert {name.split(".")[1] for name in names} == {"kernel", "program", "errors"}
    sources = [path_of(name).read_text(encoding="utf-8") for name in names]
    assert sum(len(source.splitlines()) for source in sources) <= LINES_OF_A_VERDICT
    assert sum(map(lines_of_code, sources)) <= CODE_OF_A_VERDICT


@pytest.mark.parametrize("page", ["docs/evidence.md", "mechanics/kernel/__init__.py"])
def test_pages_say_how_many_lines_a_verdict_executes(page: str) -> None:
    text = (ROOT / page).read_text(encoding="utf-8")
    assert f"{LINES_OF_A_VERDICT:,}" in text
    assert f"{CODE_OF_A_VERDICT:,}" in text


def test_the_figures_say_how_many_lines_of_code_a_verdict_executes() -> None:
    (row,) = [
        line
        for line in (ROOT / "docs" / "evidence.md").read_text(encoding="utf-8").splitlines()
        if line.startswith("| lines of code that a")
    ]
    assert f"| {CODE_OF_A_VERDICT:,} |" in row


def lines_of_code(source: str) -> int:
    """Lines that hold more than docstrings, comments and blanks."""
    nothing = {tokenize.COMMENT, tokenize.NL, tokenize.NEWLINE, tokenize.INDENT, tokenize.DEDENT,
               tokenize.ENDMARKER}  # fmt: skip
    tokens = tokenize.generate_tokens(io.StringIO(source).readline)
    code = {n for t in tokens if t.type not in nothing for n in range(t.start[0], t.end[0] + 1)}
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant):
            code -= set(range(node.lineno, (node.end_lineno or 0) + 1))
    return len(code)


def test_lines_of_code_are_counted() -> None:
    above = '"""Of a module.\n\nTwo lines."""\n'
    source = above + 'x = (\n    1,  # one\n)\n\n# nothing\ny = 2\n"""Of y."""\n'
    assert lines_of_code(source) == 4


def test_modules_import_each_other_in_one_direction_only() -> None:
    """Imports for types alone and those within functions included."""
    assert circle({"a": {"b"}, "b": {"c"}, "c": {"a"}}) is not None
    imports = {name: named(parsed(path_of(name))) - {name} for name in modules()}
    assert len(imports) > 700
    assert circle({name: found & imports.keys() for name, found in imports.items()}) is None


def modules() -> Iterator[str]:
    """Names of all modules; a package has that of its folder."""
    for path in files(*PACKAGES, suffix=".py"):
        parts = path.relative_to(ROOT).with_suffix("").parts
        yield ".".join(part for part in parts if part != "__init__")


def named(tree: ast.Module) -> set[str]:
    """What a file imports: from a package, its parts and not the package, where it has them."""
    found = set()
    for node in nodes(tree):
        if isinstance(node, ast.ImportFrom):
            parts = {f"{node.module}.{alias.name}" for alias in node.names}
            found |= {part if path_of(part).exists() else str(node.module) for part in parts}
    return found


def circle(imports: Mapping[str, set[str]]) -> list[str] | None:
    """Modules of which each imports the next, or None."""
    try:
        TopologicalSorter(imports).prepare()
    except CycleError as error:
        return list(error.args[1])
    return None


def test_every_test_asserts_something() -> None:
    assert breaches(asserts_nothing, files("tests", suffix=".py")) == []


def test_every_import_is_installed_by_the_package() -> None:
    assert breaches(undeclared_imports, files(*PACKAGES, suffix=".py")) == []


@pytest.mark.parametrize(
    ("law", "source"),
    [
        (without_docstring, "x = 1"),
        (simplifies, "import sympy\nsympy.simplify(1)"),
        (simplifies, "x.trigsimp()"),
        (simplifies, "from sympy import simplify as s"),
        (swallows_errors, "try: pass\nexcept: pass"),
        (swallows_errors, "try: pass\nexcept (ValueError, Exception): pass"),
        (runs_text, "def f(text): return eval(text)"),
        (runs_text, "import os\nos.system(text)"),
        (runs_text, "sympify(text)"),
        (runs_text, "sympy.lambdify(x, text)"),
        (makes_verdicts, "Finding(subject, Verdict.PROVED, words)"),
        (makes_verdicts, "kernel.Finding(subject, Verdict.PROVED, words)"),
        (makes_verdicts, "Witness(state, '1', '2')"),
        (makes_verdicts, "same(subject, count, count, words)"),
        (makes_verdicts, "from mechanics.kernel.definedness import Gap as G"),
        (makes_verdicts, "replace(witness, left='1')"),
        (makes_verdicts, "from mechanics.kernel import Finding as F"),
        (makes_verdicts, "replace(finding, verdict=Verdict.PROVED)"),
        (keeps_objects, "from weakref import WeakKeyDictionary"),
        (keeps_objects, "@lru_cache(maxsize=2)\ndef f(truth: Equations | None): return 1"),
        (keeps_objects, "_made: dict[str, int] = {}"),
        (keeps_objects, "made = list()"),
        (keeps_objects, "@functools.cache\ndef f(n: int, *, of: Sequence[Scene]): return 1"),
        (asserts_nothing, "class TestA:\n    def test_a(self): print(1)"),
        (undeclared_imports, "import no_such_package.part"),
        (undeclared_imports, "from pytest import raises"),
    ],
)
def test_laws_find_a_breach(law: Callable[[ast.Module], Breaches], source: str) -> None:
    assert len(list(law(ast.parse(source)))) == 1


@pytest.mark.parametrize(
    ("law", "source"),
    [
        (runs_text, "re.compile(text)\nsympify(1, strict=True)"),
        (simplifies, "from sympy import nsimplify\nnsimplify(1)"),
        (swallows_errors, "try: pass\nexcept (KeyError, ValueError): pass"),
        (swallows_errors, "try: pass\nexcept Exception as e: raise ValueError(e) from None"),
        (makes_verdicts, "def f() -> Finding: return replace(finding, subject='')"),
        (keeps_objects, "@cache\ndef f(text: str): return 1\ndef g(scene: Scene): return 1"),
        (keeps_objects, "NONE: dict[str, int] = {}\nall = [1]\ndef f():\n    found = {}"),
        (asserts_nothing, "def test_a():\n    with pytest.raises(ValueError): f()"),
        (asserts_nothing, "def test_a():\n    np.testing.assert_allclose(1, 1)"),
        (undeclared_imports, "import flint, sympy.physics\nfrom mechanics.scene import Scene"),
    ],
)
def test_laws_accept_what_is_right(law: Callable[[ast.Module], Breaches], source: str) -> None:
    assert list(law(ast.parse(source))) == []


def test_every_folder_of_a_package_can_be_imported() -> None:
    # Without __init__.py a folder still imports, but import-linter does not see it.
    folders = {path.parent for path in files(*PACKAGES, suffix=".py")}
    missing = {str(f.relative_to(ROOT)) for f in folders if not (f / "__init__.py").exists()}
    assert missing == set()


def test_top_level_holds_only_what_the_design_names() -> None:
    entries = {name.partition("/")[0] for name in tracked_files()}
    assert {name for name in entries if not name.startswith(".")} - TOP_LEVEL == set()


def tracked_files() -> list[str]:
    """Files under version control: what lies beside them in a working folder is nobody's fault."""
    git = shutil.which("git")
    if git is not None and (ROOT / ".git").exists():
        command = [git, "-C", str(ROOT), "ls-files"]
        return subprocess.run(command, capture_output=True, text=True, check=True).stdout.split()
    if os.environ.get("MECHANICS_CI") == "1":
        pytest.fail("git or the repository is missing: the top level cannot be checked")
    pytest.skip("no git checkout here")
