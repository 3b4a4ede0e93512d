"""The program itself, as `python -m pra_tactile` and as the command that the wheel installs."""

import os
import sys

from . import Failed, program


def main() -> None:
    try:
        path = program()
    except Failed as fault:
        sys.exit(f"pra-tactile: {fault}")
    os.execv(path, ["pra-tactile", *sys.argv[1:]])


if __name__ == "__main__":
    main()
