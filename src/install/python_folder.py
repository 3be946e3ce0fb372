"""Print the folder for Python modules under a prefix: python_folder.py PREFIX

One that this interpreter looks into, as Debian's for /usr and /usr/local and a user's own; else
PREFIX/lib/python3/dist-packages, and status 1, since PYTHONPATH must name it then.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import os
import site
import sys


def main():
    prefix = os.path.normpath(sys.argv[1])
    own = [site.getusersitepackages()] if site.ENABLE_USER_SITE else []
    for folder in [*site.getsitepackages(), *own]:
        if os.path.normpath(folder).startswith(os.path.join(prefix, "lib", "python")):
            print(folder)
            return 0
    print(os.path.join(prefix, "lib/python3/dist-packages"))
    return 1


if __name__ == "__main__":
    sys.exit(main())
