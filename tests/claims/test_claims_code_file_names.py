"""Names of a file that are the same whoever runs it, and those that are not."""

import ast

import pytest

from mechanics.claims.code.python.file_names import unsettled

SAME = (
    "K = 2",
    "import numpy as np\nK = np.sqrt(2)/np.array([1, 2])[0]",
    "class P:\n    def __init__(self, m): self.m = m\nK = P(m=2.0)",
    "def twice(x): return 2*x\nK = twice(3)",
    "from functools import partial\nK = partial(max, 2)",
    "A, B = 1.0, 2.0\nK = [A*i + B for i in range(3)]",
    "K = 1\nfor i in range(3):\n    K = K*2",
    "try:\n    from numba import K\nexcept ImportError:\n    def K(f): return f",
    "try:\n    from numpy import sin as K\nexcept ImportError:\n    from math import sin as K",
    "K = 1\ndef main():\n    print(K)\nif __name__ == '__main__':\n    main()",
    "from sympy import *\nK = symbols('m')",
)
OTHER = (
    "K = 1\nif __name__ == '__main__':\n    K = 2",
    "import sys\nK = 1 if 'mechanics' in sys.modules else 2",
    "import sys\nK = 1 if len(sys.argv) > 1 else 2",
    "import sys\nK = 1 if sys._getframe().f_back is None else 2",
    "import inspect\nK = inspect.currentframe().f_back is None",
    "try:\n    get_ipython()\n    K = 2\nexcept NameError:\n    K = 3",
    "from IPython import get_ipython\nK = 3 if get_ipython() is None else 2",
    "try:\n    import numba\n    K = 2\nexcept ImportError:\n    K = 3",
    "try:\n    from math import sin as K\nexcept ImportError:\n    from math import cos as K",
    "try:\n    from numba import K\nexcept ImportError:\n    def K(f): return lambda x: -f(x)",
    "K = 2 if 'In' in dir() else 3",
    "K = 2 if hasattr(__builtins__, 'x') else 3",
    "import numpy as np\nK = np.random.rand()",
    "import numpy as np\nK = np.loadtxt('k.txt')",
    "import os\ndef make(): return len(os.environ)\nK = make()",
    "K = 1\ndef main():\n    global K\n    K = 2",
    "class P: m = 1\nK = P()\ndef main():\n    K.m = 2",
    "import sys\nclass K:\n    if 'mechanics' in sys.modules:\n        m = 2",
    "with open('k.txt') as file:\n    K = 2",
)


@pytest.mark.parametrize("text", SAME)
def test_formulas_of_numbers_are_the_same_everywhere(text: str) -> None:
    assert unsettled(ast.parse(text), {"K"}, {}) == ""


@pytest.mark.parametrize("text", OTHER)
def test_what_asks_who_runs_it_is_named(text: str) -> None:
    assert unsettled(ast.parse(text), {"K"}, {}).startswith("K depends on where the file is run")
