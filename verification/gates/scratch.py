# SPDX-License-Identifier: Apache-2.0
"""A copy of the tree, to change and to build without touching the tree."""
import shutil
import subprocess


def copy_tree(root, to):
    """Copies the files that git follows, and new ones that it does not ignore, as they stand now."""
    listed = subprocess.run(["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"], cwd=root,
                            stdout=subprocess.PIPE, text=True, check=True).stdout
    for name in filter(None, listed.split("\0")):
        if (root / name).is_file():  # git lists a deleted file until the deletion is committed
            (to / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(root / name, to / name)
